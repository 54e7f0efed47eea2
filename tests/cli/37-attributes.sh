# Attributes within a bound: by bits, error, relative error, directions; integers and unknown names are refused.
ravel -q make terrain:size=12x10,attributes -o hill.vtk
ravel -q encode hill.vtk -o exact.ravel
ravel info --json exact.ravel | grep -c '"bound": 0.0'
names=$(ravel info --json exact.ravel | grep -o '"attribute": "[^"]*"' | cut -d'"' -f4)
types=$(ravel info --json exact.ravel | grep -o '"type": "[^"]*"' | cut -d'"' -f4)
echo "$names" | paste - <(echo "$types")
float=$(echo "$names" | paste - <(echo "$types") | grep float | tail -1 | cut -f1)
integer=$(echo "$names" | paste - <(echo "$types") | grep int | head -1 | cut -f1)
for what in bits=8 max-error=0.01 max-error-relative=1e-3; do
    ravel -q verify hill.vtk --attribute "$float:$what" >report; echo "$what $? $(grep -c "^$float .*[1-9]" report)"
done
ravel -q encode hill.vtk -o rounded.ravel --attribute "$float:bits=8"
[ "$(stat -c %s rounded.ravel)" -lt "$(stat -c %s exact.ravel)" ] && echo "smaller"
ravel -q verify rounded.ravel | tail -1 | grep -c "^$float"
try() { ravel "$@" 2>err; echo "$?"; sed 's/hill.vtk/MESH/' err | head -1; }
try encode hill.vtk -o x.ravel --attribute "$integer:bits=4"
try encode hill.vtk -o x.ravel --attribute "nothing:bits=4"
try encode hill.vtk -o x.ravel --attribute "$float:bits=31"
try encode hill.vtk -o x.ravel --attribute "$float:max-error=0"
try encode hill.vtk -o x.ravel --attribute "$float:max-error=nan"
try encode hill.vtk -o x.ravel --attribute "$float:bits=8" --attribute "$float:bits=9"
try encode hill.vtk -o x.ravel --attribute "$float:bites=8"
try encode hill.vtk -o x.ravel --attribute "$float"
[ -e x.ravel ] || echo "nothing written"
