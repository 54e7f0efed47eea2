"""Checks OBJ, OFF, PLY, STL, MEDIT and TetGen files against meshio, another implementation.

usage: meshio_surface_check.py CONVERT
CONVERT IN OUT [--binary] reads IN and writes OUT. meshio writes IN and reads OUT; points, cells and
data must be those it wrote. Prints one line per pair of formats; exit status 1 when any differs.
"""
import itertools
import pathlib
import subprocess
import sys
import tempfile
import warnings

import meshio
import numpy as np

warnings.filterwarnings("ignore")


def grid(cells_of_quad, dtype, seed):
    """A bumpy sheet of 5 x 4 quads, each made into the given cells, and one unused point."""
    random = np.random.default_rng(seed)
    nx, ny = 6, 5
    points = np.array([[i, j, 0] for j in range(ny) for i in range(nx)] + [[9, 9, 9]], dtype=float)
    points = (points + random.uniform(-0.3, 0.3, points.shape)).astype(dtype)
    cells = {"triangle": [], "quad": []}
    for j, i in itertools.product(range(ny - 1), range(nx - 1)):
        a = j * nx + i
        quad = [a, a + 1, a + nx + 1, a + nx]
        if cells_of_quad(i, j) == "quad":
            cells["quad"].append(quad)
        else:
            cells["triangle"] += [quad[:3], [quad[0], quad[2], quad[3]]]
    return meshio.Mesh(points, [(k, np.array(v)) for k, v in cells.items() if v])


def tets(dtype, seed):
    """Tets of random points; whether they overlap does not matter to a file."""
    random = np.random.default_rng(seed)
    points = random.normal(size=(50, 3)).astype(dtype)
    cells = np.array([random.permutation(50)[:4] for _ in range(120)])
    return meshio.Mesh(points, [("tetra", cells)])


def cells_by_type(mesh):
    found = {}
    for block in mesh.cells:
        found.setdefault(block.type, []).append(np.asarray(block.data))
    return {k: np.concatenate(v) for k, v in found.items()}


def trouble_with_cells(before, after, soup):
    old, new = cells_by_type(before), cells_by_type(after)
    if set(old) != set(new):
        return f"cell types {sorted(old)} became {sorted(new)}"
    same = np.array_equal
    for kind in old:
        if soup:
            a, b = before.points[old[kind]], after.points[new[kind]]
            if not same(a.astype(np.float32), b.astype(np.float32)):
                return "corner positions"
        elif not same(old[kind], new[kind]):
            return f"{kind} cells"
    return ""


def trouble(before, after, soup):
    if not soup:
        kind = before.points.dtype
        if not np.array_equal(before.points, after.points.astype(kind)):
            return "points"
    return trouble_with_cells(before, after, soup)


def trouble_with_data(before, after):
    """Data whose names meshio knows on both sides."""
    for name in ("tetgen:ref", "medit:ref", "tetgen:attr1", "red", "weight"):
        for place in ("point_data", "cell_data"):
            old, new = getattr(before, place), getattr(after, place)
            if name in old and name in new:
                a, b = np.concatenate([np.ravel(old[name])]), np.concatenate([np.ravel(new[name])])
                if not np.array_equal(a, b):
                    return f"{place} {name}"
    return ""


# name: ending, keywords of meshio's writer, arguments of CONVERT, is a soup of triangles
FORMATS = {
    "obj": (".obj", {}, [], False),
    "off": (".off", {}, [], False),
    "ply text": (".ply", {"binary": False}, [], False),
    "ply binary": (".ply", {"binary": True}, ["--binary"], False),
    "stl text": (".stl", {"binary": False}, [], True),
    "stl binary": (".stl", {"binary": True}, ["--binary"], True),
    "medit": (".mesh", {}, [], False),
    "tetgen ele": (".ele", {}, [], False),
    "tetgen node": (".node", {}, [], False),
}
TRIANGLES = ["obj", "off", "ply text", "ply binary", "stl text", "stl binary", "medit"]
POLYGONS = ["obj", "ply text", "ply binary", "medit"]
TETS = ["medit", "tetgen ele", "tetgen node"]
# meshio reads only the first value of a scalar column of faces in binary PLY, and no column of
# vertices whose name has a colon in PLY as text, so no such pairs.
NOT_READ_BY_MESHIO = {("stl text", "ply binary"), ("stl binary", "ply binary"),
                      ("medit", "ply binary"), ("medit", "ply text")}


def cases():
    for dtype in (np.float32, np.float64):
        name = np.dtype(dtype).name
        yield f"triangles {name}", grid(lambda i, j: "triangle", dtype, 1), TRIANGLES
        yield f"quads {name}", grid(lambda i, j: "quad", dtype, 2), POLYGONS
        yield f"mixed {name}", grid(
            lambda i, j: "quad" if j < 2 else "triangle", dtype, 3), POLYGONS
        yield f"tets {name}", tets(dtype, 4), TETS
    with_data = tets(np.float64, 5)
    with_data.point_data["tetgen:attr1"] = np.linspace(0, 1, 50)
    with_data.point_data["tetgen:ref"] = np.arange(50) % 7
    with_data.cell_data["tetgen:ref"] = [np.arange(120) % 3]
    yield "tets with data", with_data, ["tetgen ele", "tetgen node"]
    with_refs = tets(np.float64, 6)
    with_refs.cells.append(meshio.CellBlock("triangle", with_refs.cells[0].data[:, :3]))
    with_refs.point_data["medit:ref"] = np.arange(50) - 3
    with_refs.cell_data["medit:ref"] = [np.arange(120), np.arange(120) % 5]
    yield "tets and triangles with references", with_refs, ["medit"]
    colored = grid(lambda i, j: "quad", np.float32, 7)
    colored.point_data["red"] = (np.arange(31) * 8).astype(np.uint8)
    colored.point_data["weight"] = np.linspace(0, 1, 31)
    # "uchar" is signed in meshio's binary reader, so only text is compared.
    yield "quads with point data", colored, ["ply text"]


def main():
    convert = sys.argv[1]
    bad = checked = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, mesh, formats in cases():
            for source, target in itertools.product(formats, formats):
                if (source, target) in NOT_READ_BY_MESHIO:
                    continue
                if "stl binary" in (source, target) and mesh.points.dtype == np.float64:
                    continue  # binary STL has float32 only
                for old in folder.iterdir():
                    old.unlink()
                start = folder / ("in" + FORMATS[source][0])
                end = folder / ("out" + FORMATS[target][0])
                meshio.write(start, mesh.copy(), **FORMATS[source][1])
                run = subprocess.run([convert, start, end, *FORMATS[target][2]],
                                     capture_output=True, text=True)
                wrong = run.stderr.strip() if run.returncode else ""
                if not wrong:
                    soup = FORMATS[source][3] or FORMATS[target][3]
                    after = meshio.read(end)
                    wrong = trouble(mesh, after, soup) or trouble_with_data(mesh, after)
                checked += 1
                bad += bool(wrong)
                print(f"{name}: {source} -> {target}: {wrong or 'same'}")
    print(f"{checked} pairs, {bad} differ")
    return 1 if bad or not checked else 0


sys.exit(main())
