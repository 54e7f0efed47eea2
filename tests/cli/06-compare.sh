# The comparison has the contract's keys, checks its peers, and knows that Draco has no tets.
ravel -q make torus:quads=2000 -o torus.obj
ravel -q make tets:box=6,jitter=0.2 -o box.vtk
ravel -q compare torus.obj box.vtk --position-bits 14 --json >rows; echo "compare $?"
python3 - <<'P'
import json
rows = json.load(open("rows"))
print(*rows[0])
for row in rows:
    print(row["mesh"], row["codec"], row["connectivity_kept"], row["note"])
    if row["bytes"] is not None:
        assert row["max_error"] < 0.01, row
P
ravel -q compare torus.obj --codecs ravel,zstd --csv | cut -d, -f1-5
ravel -q compare torus.obj --codecs ravel --markdown | head -2 | tail -1
ravel -q compare torus.obj --codecs ravel --html page.html >text; grep -q '"codec":"ravel"\|<td class="word">ravel</td>' page.html && echo page
ravel -q compare torus.obj --codecs gzip; echo "unknown codec $?"
# A quadratic tet goes to ravel with its edges' nodes.
cat >ten.vtk <<'P'
# vtk DataFile Version 4.2
ten
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 10 float
0 0 0 8 0 0 0 8 0 0 0 8
4 0 0 4 4 0 0 4 0 0 0 4 4 0 4 0 4 4
CELLS 1 11
10 0 1 2 3 4 5 6 7 8 9
CELL_TYPES 1
24
P
ravel -q compare ten.vtk --codecs ravel,xz --json >rows; echo "quadratic $?"
python3 -c 'import json; print(*[(r["vertices"], r["connectivity_kept"], r["note"]) for r in json.load(open("rows"))])'
python3 -c 'import json; print("with its edges:", json.load(open("rows"))[0]["attribute_bytes"] > 0)'
# Where cells start alike, polygons cost Draco little: a chessboard, each cell from a white point.
python3 - >chess.obj <<'P'
n = 30
for j in range(n + 1):
    for i in range(n + 1):
        print("v", i, j, (i * j) % 5)
for j in range(n):
    for i in range(n):
        cell = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        first = (i + j) % 2
        print("f", *(1 + x + (n + 1) * y for x, y in cell[first:] + cell[:first]))
P
ravel -q compare chess.obj --position-bits 12 --codecs draco-triangles,draco-polygons --json >rows
python3 - <<'P'
import json
triangles, polygons = (row["bytes"] for row in json.load(open("rows")))
print("marks are cheap", polygons < 1.15 * triangles)
P
