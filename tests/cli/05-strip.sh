# One strip per component, whichever way the factor is found; the strip comes out as a mesh.
ravel -q make torus:quads=1000 -o torus.obj
ravel -q make tets:box=5,jitter=0.2,copies=3 -o box.vtk
for mesh in torus.obj box.vtk; do
    for method in steered euler two-pass template; do
        ravel -q strip $mesh --method $method --json >report; echo "$mesh $method $?"
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
ravel -q make polygons:hex,size=9x9 -o hex.obj
ravel strip hex.obj --method two-pass --json 2>&1 >report; grep two_factor report
for objective in turns normals axis=x; do
    ravel strip torus.obj --objective $objective --json | grep '"objective"'
done
ravel strip box.vtk --method template --unmatched --json | grep -c '"links"'
ravel strip box.vtk --unmatched; echo "unmatched without a matching $?"
ravel strip box.vtk --objective normals; echo "normals of tets $?"
ravel strip torus.obj --method euler --objective normals; echo "objective and euler $?"
ravel strip torus.obj box.vtk; echo "two meshes $?"
# The tables: the paper's rows where it has a model of like size.
ravel -q make torus:size=32x20 -o sphere_like.obj
ravel strip --tables sphere_like.obj torus.obj box.vtk --json >tables; echo "tables $?"
python3 - <<'P'
import json
tables = json.load(open("tables"))
for name, rows in tables.items():
    for row in rows:
        print(name, row["model"], "|", row["by"], "|", *row)
P
