"""Of what `check` makes, meshes with attributes, companions, names; kept orders."""

import math
import random

from making import border, box_tets, bumpy_sheet, data_arrays, middle, obj, sheet, unit_vector, vtk, with_companions


def every():
    for recipe in RIDING_POLYGONS:
        for ending in ("vtk", "ply"):
            yield recipe + ",attributes", ending, ["", "--keep-order"]
    for recipe in RIDING_TETS:
        yield recipe + ",attributes,companions", "vtk", ["", "--keep-order", "--position-bits 10"]
    for recipe in ("grid:size=6x5", "polygons:mixed,size=6x6,shuffle", "tets:box=2x2x2", "tets:ball=3,shuffle"):
        yield recipe, "vtk", ["--keep-order", "--keep-order --position-bits 7"]
    yield "tets:box=2x2x2,copies=2,companions", "msh", [""]
    bounds = "--attribute noise:bits=9 --attribute normal:octahedral=10 --attribute wavy:max-error=0.01"
    for source in (fields_on_points, fields_on_cells, fields_on_tets):
        yield source, "vtk", ["", "--keep-order", bounds, bounds + " --position-bits 8 --keep-order"]
    yield textured, "obj", ["", "--keep-order", "--attribute obj:vn:octahedral=9 --attribute obj:vt:bits=8"]
    yield patched, "obj", ["", "--keep-order"]
    yield smooth, "obj", ["", "--keep-order", "--attribute obj:vn:octahedral=12", "--attribute obj:vn:bits=11"]
    yield quadratic, "vtk", ["", "--keep-order", "--position-bits 12"]
    yield all_companions, "vtk", ["", "--keep-order"]
    yield lines_on_sheet, "vtk", ["", "--keep-order"]


RIDING_POLYGONS = (
    "torus:size=8x6",
    "terrain:size=7x7,holes=5,shuffle",
    "polygons:mixed,size=7x7,double",
    "soup:polygons=60,seed=3",
    "tiny:degrees-0-1-2",
    "tiny:points",
    "moebius:size=9x2",
)

RIDING_TETS = (
    "tets:box=3x3x3",
    "tets:box=3x3x2,shuffle,jitter=0.2",
    "tets:ball=4,double",
    "soup:tets=50,seed=2",
    "tets:shell=4,shuffle",
)


def fields(places):
    """Arrays of every kind over these places."""
    n = len(places)
    wild_values = [0.0, -0.0, 1.5, math.nan, math.inf, -1e300]
    arrays = [
        ("wavy", "double", [(math.sin(x) + y * z,) for x, y, z in places]),
        ("linear", "float", [(x * 0.25 + y * 0.5 - z,) for x, y, z in places]),
        ("noise", "float", [(random.random(), random.gauss(0, 1e-3)) for _ in places]),
        ("doubles", "double", [(random.random(),) for _ in places]),
        ("decimal", "double", [(f"{x + 0.1 * y:.2f}", random.choice(["0", "-0.0", "0.25"])) for x, y, z in places]),
        ("holes", "double", [(math.nan if random.random() < 0.2 else round(x * 4) / 8,) for x, y, z in places]),
        ("wild", "double", [(random.choice(wild_values), 2.0**-30, float(i)) for i in range(n)]),
        ("normal", "float", [unit_vector(x, y, z + 0.5) for x, y, z in places]),
        ("directions", "double", [unit_vector(x - y, math.sin(3 * z), 1.0) for x, y, z in places]),
        ("turned", "float", [unit_vector(*random.choice(((1, 0, 0), (0, -1, 0), (1, 2, -2)))) for _ in places]),
        ("bytes", "unsigned_char", [(int(4 * x) % 7, i % 251) for i, (x, y, z) in enumerate(places)]),
        ("patches", "int", [(int(x > 2) + 2 * int(y > 2) - 1,) for x, y, z in places]),
        ("random", "short", [(random.randint(-32768, 32767),) for _ in places]),
        ("large", "long", [(i * 10**15, -(2**63) if i == 3 else random.getrandbits(60)) for i in range(n)]),
        ("constant", "unsigned_long", [(2**64 - 1,)] * n),
        ("five", "float", [(x, y, z, x + y, 1.0) for x, y, z in places]),
    ]
    return arrays


def fields_on_points():
    random.seed(6)
    points = bumpy_sheet(6, 6)
    return vtk(points, sheet(6, 6), scalar="float") + data_arrays("POINT_DATA", len(points), fields(points))


def fields_on_cells():
    random.seed(7)
    points = bumpy_sheet(8, 6)
    cells = sheet(8, 6)
    return vtk(points, cells) + data_arrays("CELL_DATA", len(cells), fields([middle(points, c) for c in cells]))


def fields_on_tets():
    random.seed(8)
    points = [
        (x + random.uniform(-0.2, 0.2), float(y), z + 0.25 * y) for z in range(4) for y in range(4) for x in range(4)]
    cells = box_tets(3)
    return (
        vtk(points, cells, 10)
        + data_arrays("POINT_DATA", len(points), fields(points))
        + data_arrays("CELL_DATA", len(cells), fields([middle(points, c) for c in cells]))
    )


def textured():
    """Texture corners with a seam and gaps, normals that are shared or not, materials."""
    random.seed(9)
    points = bumpy_sheet(7, 6)
    w = len(points)
    vt = [(x / 7, y / 6) for x, y, z in points]
    vt += [(x / 7 + 1, y / 6) for x, y, z in points]
    vn = [unit_vector(math.sin(x), -0.2, 1.0) for x, y, z in points] + [(0.0, 0.0, 1.0), (-0.0, 1.0, 0.0)]
    faces = []
    for i, cell in enumerate(sheet(7, 6)):
        if i % 9 == 0:
            faces.append(f"usemtl colour{i % 4}")
        seam = w if i % 7 > 3 else 0
        lacks = i % 11 == 5
        flat = w + i % 2 if i % 8 == 3 else None
        faces.append([(p, None if lacks else p + seam, p if flat is None else flat) for p in cell])
    return obj(points, faces, vt, vn)


def patched():
    """Every polygon has its own patch of the texture, in shuffled order; triangles and pentagons."""
    random.seed(10)
    points = bumpy_sheet(5, 5)
    faces = []
    vt = []
    for cell in sheet(5, 5):
        if random.random() < 0.3:
            cell = cell[:3]
        at = random.randrange(9) / 8
        own = [(at + (k & 1) / 16, at + (k >> 1) / 16) for k in range(len(cell))]
        faces.append([(p, len(vt) + k, None) for k, p in enumerate(cell)])
        vt += own
    random.shuffle(faces)
    return obj(points, faces, vt, [])


def smooth():
    """A ball with normals by angle, as programs for modelling write them."""
    points = []
    rows, columns = 6, 8
    for i in range(1, rows):
        for k in range(columns):
            a, b = math.pi * i / rows, 2 * math.pi * k / columns
            points.append((math.sin(a) * math.cos(b) * 2, math.sin(a) * math.sin(b), math.cos(a)))
    faces = []
    for i in range(rows - 2):
        for k in range(columns):
            l = (k + 1) % columns
            faces.append([i * columns + k, (i + 1) * columns + k, (i + 1) * columns + l, i * columns + l])

    def minus(a, b):
        return [a[j] - b[j] for j in range(3)]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    normals = [[0.0] * 3 for _ in points]
    for f in faces:
        for j, p in enumerate(f):
            u, v = minus(points[f[(j + 1) % 4]], points[p]), minus(points[f[j - 1]], points[p])
            n = unit_vector(*cross(u, v))
            cosine = sum(x * y for x, y in zip(unit_vector(*u), unit_vector(*v)))
            normals[p] = [a + math.acos(max(-1, min(1, cosine))) * b for a, b in zip(normals[p], n)]
    normals = [tuple(round(x, 4) for x in unit_vector(*n)) for n in normals]
    return obj(points, [[(p, None, p) for p in f] for f in faces], [], normals)


def quadratic():
    """Quadratic tets: the mid-edge nodes are companions with hosts."""
    random.seed(11)
    points = [[float(x), float(y), z + 0.1 * x * y] for z in range(3) for y in range(3) for x in range(3)]
    middles = {}
    cells = []
    for cell in box_tets(2):
        nodes = list(cell)
        for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)):
            key = frozenset((cell[a], cell[b]))
            if key not in middles:
                middles[key] = len(points)
                points.append([(points[cell[a]][k] + points[cell[b]][k]) / 2 for k in range(3)])
            nodes.append(middles[key])
        cells.append(nodes)
    random.shuffle(cells)
    triangles = [list(t) for t in border([c[:4] for c in cells])]
    return with_companions(points, [(24, cells), (5, triangles)])


def all_companions():
    """Triangles of two sides of a box and inside it, lines, points, quads, with attributes and tags."""
    random.seed(12)
    points = [(float(x), float(y), float(z)) for z in range(4) for y in range(4) for x in range(4)]
    tets = box_tets(3)
    outside = border(tets)
    low = [f for f in outside if all(points[p][2] == 0 for p in f)]
    right = [f for f in outside if all(points[p][0] == 3 for p in f)]
    inside = [(t[0], t[1], t[2]) for t in tets if random.random() < 0.15]
    random.shuffle(inside)
    edges = [(x, x + 1) for x in range(3)] + [(4 * y, 4 * y + 4) for y in range(3)] + [(21, 42), (5, 5)]
    quads = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 9, 8), (5, 6, 10, 9)]
    blocks = [
        (10, tets), (5, low), (5, right), (5, inside), (3, edges), (3, [(12, 13), (13, 14)]), (1, [(0,), (3,), (63,)]),
        (9, quads), (5, [(1, 7, 50)])]
    count = sum(len(own) for _, own in blocks)
    tags = [(i % 2 if type == 3 else j,) for j, (type, own) in enumerate(blocks) for i in range(len(own))]
    values = [(random.random(),) for _ in range(count)]
    return with_companions(points, blocks) + data_arrays(
        "CELL_DATA", count, [("tag", "int", tags), ("value", "double", values)])


def lines_on_sheet():
    """Lines along the sides of polygons, chained and not, and points."""
    random.seed(13)
    points = bumpy_sheet(6, 5)
    lines = [(x, x + 1) for x in range(6)] + [(7 * y + 7, 7 * y) for y in range(4)] + [(9, 10), (10, 17), (3, 24)]
    blocks = [(9, sheet(6, 5)), (3, lines), (1, [(0,), (8,), (20,)]), (3, [(30, 31), (31, 32)])]
    count = sum(len(own) for _, own in blocks)
    return with_companions(points, blocks) + data_arrays(
        "CELL_DATA", count, [("tag", "int", [(i // 5,) for i in range(count)])])
