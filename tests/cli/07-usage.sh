# What makes no sense is refused with exit code 2, and nothing is written.
ravel -q make tiny:cube -o cube.obj
try() { ravel "$@" >out 2>err; echo "$? $([ -s out ] && echo 'and spoke on stdout') $*"; }
try
try frobnicate
try encode
try encode cube.obj
try encode cube.obj -o x.ravel --position-bits 0
try encode cube.obj -o x.ravel --position-bits 31
try encode cube.obj -o x.ravel --position-bits twelve
try encode cube.obj -o x.ravel --position-bits 12 --max-error 1
try encode cube.obj -o x.ravel --position-bits 12 --lossless
try encode cube.obj -o x.ravel --max-error -1
try encode cube.obj -o x.ravel --max-error 0
try encode cube.obj -o x.ravel --level 99
try encode cube.obj -o x.ravel --no-such-option
try encode - -o x.ravel
try strip cube.obj --method magic
try make torus:quads=many -o x.obj
try make cone -o x.obj
try make tiny:cube
try view
try view cube.obj --port 70000
ls
