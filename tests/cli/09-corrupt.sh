# A cut file, a changed byte and garbage give exit code 4 and no output.
try() { ravel "$@" >out 2>err; echo "$? $(wc -l <err) $*"; }
ravel -q make torus:quads=500,attributes -o torus.obj
ravel -q encode torus.obj -o whole.ravel
size=$(stat -c %s whole.ravel)
for part in 0 1 4 16; do
    head -c $part whole.ravel >cut.ravel
    ravel -q decode cut.ravel -o x.obj 2>err; echo "$? first $part bytes"
done
head -c $((size / 2)) whole.ravel >cut.ravel
try decode cut.ravel -o x.obj
head -c $((size - 1)) whole.ravel >cut.ravel
try decode cut.ravel -o x.obj
try verify cut.ravel
cp whole.ravel changed.ravel
printf '\xff\xff\xff' | dd of=changed.ravel bs=1 seek=$((size - 40)) conv=notrunc 2>/dev/null
try decode changed.ravel -o x.obj
try decode torus.obj -o x.obj
try info torus.obj
try verify - <torus.obj
{ cat whole.ravel; echo more; } >long.ravel
try decode long.ravel -o x.obj
ls -A
