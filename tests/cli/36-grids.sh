# Grids: a bound in diagonals, a lattice by number or power; tiles agree; one of the options at a time.
ravel -q make terrain:size=30x20,double -o hill.ply
ravel -q encode hill.ply -o bound.ravel --max-error-relative 1e-4; echo "relative $?"
ravel -q verify hill.ply --max-error-relative 1e-4; echo "verified $?"
ravel -q encode hill.ply -o a.ravel --lattice 2^-10; echo "lattice $?"
ravel -q encode hill.ply -o b.ravel --lattice 0.0009765625; cmp a.ravel b.ravel && echo "the same"
try() { ravel "$@" >out 2>err; echo "$? $*"; grep -c . err; }
try encode hill.ply -o x.ravel --lattice 0.3
try encode hill.ply -o x.ravel --lattice 2^
try encode hill.ply -o x.ravel --lattice 2^-10 --position-bits 9
try encode hill.ply -o x.ravel --max-error-relative 0
try encode hill.ply -o x.ravel --max-error-relative 2
[ -e x.ravel ] || echo "nothing written"
