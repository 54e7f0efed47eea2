# One strip per component, whichever way the factor is found; the strip comes out as a mesh.
ravel -q make torus:quads=1000 -o torus.obj
ravel -q make tets:box=5,jitter=0.2,copies=3 -o box.vtk
for mesh in torus.obj box.vtk; do
    for method in steered euler; do
        ravel strip $mesh --method $method --json >report; echo "$mesh $method $?"
        python3 - <<'P'
import json
report = json.load(open("report"))
print(*report)
print(*report["factor"])
print("strips == components", report["strips"] == report["components"], report["components"])
P
    done
done
ravel -q strip box.vtk -o strip.vtk >facts; echo "strip $?"
grep -q strip_position strip.vtk && grep -q parent strip.vtk && echo "cell data is there"
ravel -q encode box.vtk -o box.ravel
ravel -q decode box.ravel --strip -o strip2.vtk; echo "decode --strip $?"
grep -q strip_position strip2.vtk && echo "cell data is there"
ravel strip torus.obj --method two-pass; echo "two-pass $?"
ravel strip torus.obj --method template; echo "template $?"
