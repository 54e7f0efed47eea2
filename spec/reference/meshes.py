"""What `check` makes: a recipe of the tool or a function that writes a mesh, its ending, options of `encode`."""

import math
import random

TINY = (
    "empty empty-tets points tet-points triangle quad digon degrees-0-1-2 two-quads two-apart twice both-sides "
    "flipped fan-of-three pinch bow-tie point-cell cube tet two-tets tets-twice tets-both-sides tets-on-one-face "
    "tets-on-one-edge tets-on-one-point flat-tet").split()


def every():
    for name in TINY:
        yield "tiny:" + name, "vtk", ["", "--position-bits 8"]
    for recipe in SURFACES:
        yield recipe, "vtk", ["", "--position-bits 14"]
    for recipe in TETS:
        yield recipe, "vtk", ["", "--position-bits 14"]
    yield "soup:polygons=120,seed=1", "vtk", ["", "--float32", "--lattice 2^-10", "--max-error 0.01"]
    yield "soup:polygons=120,seed=2,double", "vtk", ["", "--float32", "--lattice 2^-10", "--position-bits 1"]
    yield "soup:tets=120,seed=1", "vtk", ["", "--float32", "--lattice 2^-10", "--max-error 0.01"]
    yield "soup:tets=120,seed=2,double", "vtk", ["", "--float32", "--lattice 2^-10", "--position-bits 30"]
    yield decimals, "vtk", [""]
    yield decimal_tets, "vtk", [""]
    yield crowded, "vtk", ["", "--position-bits 14"]
    yield shaken, "vtk", ["", "--lattice 1"]
    yield wild, "vtk", ["", "--position-bits 10"]
    yield two_alike, "vtk", ["", "--position-bits 12"]
    yield scattered_polygons, "vtk", ["", "--position-bits 9"]
    yield from riding()


def riding():
    """Meshes with attributes, companions, names; kept orders."""
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

SURFACES = (
    "grid:size=9x7",
    "grid:size=9x7,triangles,jitter=0.3",
    "grid:size=9x7,jitter=0.2,double",
    "torus:size=12x9,bumps=0.3",
    "torus:size=12x9,copies=3",
    "torus:size=12x9,double,shuffle",
    "sphere:subdivide=2",
    "sphere:subdivide=2,bumps=0.2,double",
    "moebius:size=20x3",
    "terrain:size=14x14,holes=9",
    "terrain:size=14x14,double",
    "polygons:hex,size=7x7",
    "polygons:mixed,size=10x10",
    "polygons:mixed,size=8x8,double,copies=2",
    "polygons:cap,size=24",
)

TETS = (
    "tets:box=4x4x4",
    "tets:box=4x4x3,five",
    "tets:box=4x4x4,jitter=0.2",
    "tets:box=3x3x3,jitter=0.3,double,seed=3",
    "tets:box=2x2x3,copies=3",
    "tets:box=8x4x4,bend=60",
    "tets:box=6x4x4,twist=90,five",
    "tets:ball=4",
    "tets:ball=4,double,shuffle",
    "tets:shell=5",
)


def vtk(points, cells, type=None, scalar="double"):
    """An ASCII file; points are triples of numbers or of their text."""
    lines = ["# vtk DataFile Version 3.0", "mesh", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines.append(f"POINTS {len(points)} {scalar}")
    lines += [" ".join(x if isinstance(x, str) else repr(x) for x in p) for p in points]
    lines.append(f"CELLS {len(cells)} {sum(len(c) + 1 for c in cells)}")
    lines += [" ".join(str(x) for x in [len(c), *c]) for c in cells]
    lines.append(f"CELL_TYPES {len(cells)}")
    lines += [str(type or 7)] * len(cells)
    return "\n".join(lines) + "\n"


def sheet(columns, rows):
    """Quads over (columns + 1) x (rows + 1) points."""
    w = columns + 1
    return [
        [y * w + x, y * w + x + 1, (y + 1) * w + x + 1, (y + 1) * w + x]
        for y in range(rows)
        for x in range(columns)
    ]


def box_tets(n):
    """Six tets in each of n x n x n cubes."""
    w = n + 1
    cells = []
    for z in range(n):
        for y in range(n):
            for x in range(n):
                for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (1, 0, 2), (2, 1, 0)):
                    at = [x, y, z]
                    cell = []
                    for axis in (*order, None):
                        cell.append((at[2] * w + at[1]) * w + at[0])
                        if axis is not None:
                            at[axis] += 1
                    if order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                        cell[2], cell[3] = cell[3], cell[2]
                    cells.append(cell)
    return cells


def decimals():
    """Decimals of three to seven places, 0 and -0, numbers below 1."""
    random.seed(1)
    points = []
    for y in range(9):
        for x in range(9):
            points.append((f"{x * 0.1:.3f}", f"{y * 0.137:.7f}", random.choice(
                ["0", "-0.0", "0.0004", "-0.003", f"{random.gauss(0, 1):.5f}"])))
    return vtk(points, sheet(8, 8))


def decimal_tets():
    random.seed(2)
    points = []
    for z in range(4):
        for y in range(4):
            for x in range(4):
                points.append([f"{a + random.uniform(-0.2, 0.2):.4f}" for a in (x, y, z)])
    return vtk(points, box_tets(3), 10)


def crowded():
    """A fine lattice of tets beside a coarse one: it all lies in one cube of the grid."""
    points = []
    cells = []
    for n, at, side in ((5, 0.0, 1 / 64), (4, 16.0, 64.0)):
        cells += [[len(points) + p for p in cell] for cell in box_tets(n)]
        steps = range(n + 1)
        points += [(at + side * x, side * y, side * z) for z in steps for y in steps for x in steps]
    return vtk(points, cells, 10)


def shaken():
    """A lattice of tets whose points are a step off, here and there."""
    random.seed(14)
    steps = [64 * i for i in range(5)]
    points = [tuple(a + random.randint(-1, 1) for a in (x, y, z)) for z in steps for y in steps for x in steps]
    return vtk(points, box_tets(4), 10)


def wild():
    """NaN, infinities, huge and tiny numbers."""
    random.seed(3)
    points = []
    for y in range(8):
        for x in range(8):
            points.append([random.choice(
                [x * 1.5, y * 0.25, math.nan, math.inf, -math.inf, 1e300, -1e-300, 5e-324, 0.0, -0.0, 1.0])
                if random.random() < 0.3 else a for a in (float(x), float(y), x * y / 16)])
    return vtk(points, sheet(7, 7))


def two_alike():
    """A bumpy sheet, itself mirrored, moved, turned and grown."""
    random.seed(4)
    bumps = [random.uniform(-0.4, 0.4) for _ in range(49)]
    sheet_points = [(i % 7 + bumps[i], i // 7 + bumps[48 - i], 3 * bumps[i] ** 2) for i in range(49)]
    points = []
    cells = []
    for move in (
        lambda x, y, z: (x, y, z),
        lambda x, y, z: (20 - x, y, z),
        lambda x, y, z: (x, y + 30, z),
        lambda x, y, z: (y + 40, x * 0.5, z),
        lambda x, y, z: (2 * x - 60, 2 * y, 2 * z),
        lambda x, y, z: (x, y, z),
    ):
        base = len(points)
        points += [move(*p) for p in sheet_points]
        cells += [[base + c for c in cell] for cell in sheet(6, 6)]
    points = [tuple(float(f"{a:.5f}") for a in p) for p in points]
    return vtk(points, cells)


def scattered_polygons():
    """Few large polygons of many degrees, with holes between them, and unused points."""
    random.seed(5)
    points = [(random.randint(-40, 40) / 8, random.randint(-40, 40) / 8, random.randint(0, 3) / 2) for _ in range(60)]
    cells = [random.sample(range(50), random.choice((0, 1, 2, 3, 3, 4, 5, 6, 7, 9, 14))) for _ in range(40)]
    return vtk(points, cells)


def data_arrays(place, count, arrays):
    lines = [f"{place} {count}", f"FIELD FieldData {len(arrays)}"]
    for name, scalar, tuples in arrays:
        lines.append(f"{name} {len(tuples[0])} {len(tuples)} {scalar}")
        lines += [" ".join(x if isinstance(x, str) else repr(x) for x in t) for t in tuples]
    return "\n".join(lines) + "\n"


def unit_vector(x, y, z):
    l = math.sqrt(x * x + y * y + z * z) or 1.0
    return x / l, y / l, z / l


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


def bumpy_sheet(columns, rows):
    return [
        (float(x), y + 0.1 * math.sin(x), round(math.cos(x) * math.sin(y), 3))
        for y in range(rows + 1)
        for x in range(columns + 1)
    ]


def fields_on_points():
    random.seed(6)
    points = bumpy_sheet(6, 6)
    return vtk(points, sheet(6, 6), scalar="float") + data_arrays("POINT_DATA", len(points), fields(points))


def middle(points, cell):
    return tuple(sum(points[p][k] for p in cell) / len(cell) for k in range(3))


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


def obj(points, faces, vt, vn):
    """Faces are lists of (point, vt or None, vn or None), or text."""
    lines = ["v " + " ".join(repr(x) for x in p) for p in points]
    lines += ["vt " + " ".join(repr(x) for x in t) for t in vt]
    lines += ["vn " + " ".join(repr(x) for x in n) for n in vn]

    def text(x):
        return "" if x is None else str(x + 1)

    for f in faces:
        if isinstance(f, str):
            lines.append(f)
        else:
            corners = [f"{text(p)}/{text(t)}/{text(n)}".rstrip("/") for p, t, n in f]
            lines.append("f " + " ".join(corners))
    return "\n".join(lines) + "\n"


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


def with_companions(points, blocks, scalar="double"):
    """`blocks` are (type, cells), the mesh's cells among them."""
    cells = [c for _, own in blocks for c in own]
    types = [str(type) for type, own in blocks for _ in own]
    text = vtk(points, cells, scalar=scalar)
    return text[: text.index("CELL_TYPES")] + f"CELL_TYPES {len(cells)}\n" + "\n".join(types) + "\n"


def border(cells):
    """The triangles of tets that are there once."""
    count = {}
    for a, b, c, d in cells:
        for f in ((a, b, d), (b, c, d), (c, a, d), (a, c, b)):
            count.setdefault(frozenset(f), []).append(f)
    return [f[0] for f in count.values() if len(f) == 1]


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
