# A full disk, a file that may not grow, a pipe that nobody reads: exit code 3, a sentence, nothing left.
ravel -q make torus:quads=40000,bumps=0.3 -o torus.ply
ravel -q make tets:box=14 -o box.vtk
ravel -q encode torus.ply -o torus.ravel
ravel -q encode box.vtk -o box.ravel
try() { "$@" 2>err; echo "$? $(wc -l <err) $*"; }
for ending in obj off ply stl msh mesh vtk vtu; do
    try ravel -q decode box.ravel -o /dev/full --to $ending
done
try ravel -q encode torus.ply -o /dev/full
try ravel -q strip torus.ply -o /dev/full --to obj
ls -A >before
# At most 32 blocks of a KiB, with a shell that is told no signal either way.
limited() { bash -c 'ulimit -f 32; exec "$@"' limited "$@"; }
for ending in obj off ply stl msh mesh vtk vtu node; do
    try limited ravel -q decode torus.ravel -o out.$ending
    try limited ravel -q decode box.ravel -o out.$ending
done
try limited ravel -q encode torus.ply -o out.ravel
ls -A | diff before - | grep -v -e err -e before
# A reader that stops early.
ravel -q decode torus.ravel -o - --to obj 2>err | head -1
echo "${PIPESTATUS[0]} $(grep -c 'Broken pipe' err)"
ravel -q make torus:quads=200000 -o large.ply
ravel -q encode large.ply -o - 2>err | head -c 1
echo " ${PIPESTATUS[0]} $(grep -c 'Broken pipe' err)"
