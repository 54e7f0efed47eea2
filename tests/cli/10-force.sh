# An existing file stays unless --force is given, and a failed run leaves it as it was.
ravel -q make tiny:cube -o cube.obj
echo precious >out.ravel
ravel encode cube.obj -o out.ravel; echo $?; cat out.ravel
ravel -q encode cube.obj -o out.ravel --force; echo $?
echo precious >out.obj
ravel decode out.ravel -o out.obj; echo $?; cat out.obj
head -c 20 out.ravel >cut.ravel
ravel decode cut.ravel -o out.obj --force; echo $?; cat out.obj
ravel -q decode out.ravel -o out.obj --force; echo $?; grep -c '^f ' out.obj
echo precious >strip.vtk
ravel strip cube.obj -o strip.vtk; echo $?; cat strip.vtk
echo precious >mesh.obj
ravel make tiny:cube -o mesh.obj; echo $?; cat mesh.obj
ravel -q make tiny:cube -o mesh.obj --force; echo $?; cmp cube.obj mesh.obj
ls -A
