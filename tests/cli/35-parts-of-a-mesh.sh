# TetGen's meshes are several files: parts of an older mesh do not mix with a new one.
ravel -q make tets:box=1,attributes,companions -o old.node
ravel -q make tiny:two-tets -o new.vtk
ravel -q encode new.vtk -o new.ravel
ls old.*
mkdir there && mv old.face there/new.face
ravel -q decode new.ravel -o there/new.node; echo $?
ravel -q decode new.ravel -o there/new.node -f; echo $?
ls -A there
