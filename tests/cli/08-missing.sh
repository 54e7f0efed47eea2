# Files that can't be read or written give exit code 3 and leave nothing behind.
try() { ravel "$@" >out 2>err; echo "$? $(wc -l <err) $*"; }
try encode nothing.obj -o x.ravel
try verify nothing.obj
try verify nothing.ravel
try info nothing.ravel
try decode nothing.ravel -o x.obj
try strip nothing.vtk
try compare nothing.off
ravel -q make tiny:cube -o cube.obj
cp cube.obj cube.xyzzy
try verify cube.xyzzy
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >cut.off
try verify cut.off
try encode cube.obj -o no/such/folder/x.ravel
ravel -q encode cube.obj -o cube.ravel
try decode cube.ravel -o x.xyzzy
try encode . -o x.ravel
ls -A
