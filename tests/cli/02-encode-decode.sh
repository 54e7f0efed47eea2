# A surface and a volume go in and come back: same counts, and decoding again gives the same file.
ravel -q make torus:quads=2000 -o torus.obj
ravel -q make tets:box=6,jitter=0.2 -o box.vtk
for mesh in torus.obj box.vtk; do
    name=${mesh%.*} ending=${mesh##*.}
    ravel -q encode $mesh -o $name.ravel; echo "encode $?"
    ravel -q decode $name.ravel -o again.$ending; echo "decode $?"
    ravel -q encode again.$ending -o again.ravel; echo "encode again $?"
    ravel info $name.ravel | grep -E '^(cell kind|cells|vertices|components|lossless) '
    ravel verify $name.ravel | grep '^equal'
    ravel verify again.$ending | grep '^equal'
    rm again.*
done
ravel -q encode torus.obj -o ordered.ravel --keep-order
ravel -q decode ordered.ravel -o ordered.obj
cmp torus.obj ordered.obj && echo "the order was kept"
# Nothing is left behind beside the results.
ls -A
