# Everything through stdin and stdout.
ravel -q make torus:quads=500 -o - --to obj | ravel -q encode - --from obj -o - | ravel -q decode - -o - --to off | head -2
ravel -q make tets:box=3 -o - --to vtk >box.vtk
ravel -q encode - --from vtk -o - <box.vtk | ravel verify - | grep '^equal'
ravel -q encode box.vtk -o - | ravel info - | grep '^cells'
ravel verify - --from vtk --json <box.vtk | grep '"equal"'
ravel -q decode - -o - <box.vtk; echo "$? without --to"
ravel -q encode box.vtk -o /dev/null; echo $?
[ -c /dev/null ] && echo "/dev/null is still there"
ls -A
