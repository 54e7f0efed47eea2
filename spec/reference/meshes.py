"""What `check` makes: a recipe of the tool or a function that writes a mesh, its ending, options of `encode`."""

import math
import random

TINY = (
    "empty empty-tets points tet-points triangle quad digon degrees-0-1-2 two-quads two-apart twice both-sides "
    "flipped fan-of-three pinch bow-tie point-cell cube tet two-tets tets-twice tets-both-sides tets-on-one-face "
    "tets-on-one-edge tets-on-one-point flat-tet").split()


def all():
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
    yield wild, "vtk", ["", "--position-bits 10"]
    yield two_alike, "vtk", ["", "--position-bits 12"]
    yield scattered_polygons, "vtk", ["", "--position-bits 9"]


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
