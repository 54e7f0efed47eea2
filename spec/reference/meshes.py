"""What `check` makes: a recipe of the tool or a function that writes a mesh, its ending, options of `encode`."""

import math
import random

import meshes_riding
from making import box_tets, sheet, vtk

TINY = (
    "empty empty-tets points tet-points triangle quad digon degrees-0-1-2 two-quads two-apart twice both-sides "
    "flipped fan-of-three pinch bow-tie point-cell cube tet two-tets tets-twice tets-both-sides tets-on-one-face "
    "tets-on-one-edge tets-on-one-point flat-tet").split()


def every():
    for name in TINY:
        yield "tiny:" + name, "vtk", ["", "--position-bits 8", "--fast"]
    for recipe in SURFACES:
        yield recipe, "vtk", ["", "--position-bits 14", "--fast --position-bits 12"]
    for recipe in TETS:
        yield recipe, "vtk", ["", "--position-bits 14", "--fast", "--fast --position-bits 12"]
    for recipe in ROUND_TETS:
        yield recipe, "vtk", ["", "--position-bits 9", "--position-bits 14"]
        yield recipe + ",double", "vtk", ["", "--float32", "--max-error 0.001"]
    yield "soup:polygons=120,seed=1", "vtk", ["", "--float32", "--lattice 2^-10", "--max-error 0.01"]
    yield "soup:polygons=120,seed=2,double", "vtk", ["", "--float32", "--lattice 2^-10", "--position-bits 1"]
    yield "soup:tets=120,seed=1", "vtk", ["", "--fast", "--float32", "--lattice 2^-10", "--max-error 0.01"]
    yield "soup:tets=120,seed=2,double", "vtk", ["", "--float32", "--lattice 2^-10", "--position-bits 30"]
    yield decimals, "vtk", [""]
    yield decimal_tets, "vtk", [""]
    yield crowded, "vtk", ["", "--position-bits 14"]
    yield shaken, "vtk", ["", "--lattice 1"]
    yield wild, "vtk", ["", "--fast --position-bits 30", "--position-bits 10"]
    yield two_alike, "vtk", ["", "--position-bits 12"]
    yield books, "vtk", ["", "--position-bits 9"]
    yield late_image, "vtk", ["--position-bits 12"]
    yield scattered_polygons, "vtk", ["", "--position-bits 9"]
    yield from meshes_riding.every()


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
    "polygons:mixed,size=8x8,copies=6",
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

# borders on a sphere, on two, on a cylinder, on a torus
ROUND_TETS = (
    "tets:ball=3,slide=0.5",
    "tets:shell=5,slide=0.5",
    "tets:box=8x3x3,round,slide=0.5",
    "tets:box=12x4x4,round,bend=120,slide=0.5",
)


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
    """A fine lattice of tets beside a coarse one: it all lies in one cube of the grid, more than a search looks at."""
    points = []
    cells = []
    for n, at, side in ((9, 0.0, 1 / 64), (4, 16.0, 64.0)):
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


def late_image():
    """A rough sheet, and its mirror image: so many vertices without an echo that echoes are looked for at one in eight."""
    random.seed(9)
    n = 20
    points = [(x + 0.5, y, random.random()) for y in range(n + 1) for x in range(n + 1)]
    cells = sheet(n, n)
    points += [(-x, y, z) for x, y, z in points]
    cells += [[v + (n + 1) ** 2 for v in reversed(cell)] for cell in cells]
    return vtk(points, cells)


def books():
    """Books, nearly alike, of four leaves that share a back: edges with four sides, so there are copies."""
    random.seed(15)
    high = 6
    points = []
    cells = []
    for book in range(9):
        back = len(points)
        points += [(9.0 * book, y + 0.05 * random.randrange(3), 0.0) for y in range(high)]
        for x, z in ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.6, -0.8)):
            leaf = len(points)
            points += [(9.0 * book + x * k, float(y), z * k) for k in (1, 2) for y in range(high)]
            for a, b in ((back, leaf), (leaf, leaf + high)):
                for y in range(high - 1):
                    quad = [a + y, b + y, b + y + 1, a + y + 1]
                    split = y == 2 or random.random() < 0.02
                    cells += [quad[:3], [quad[0], *quad[2:]]] if split else [quad]
    return vtk(points, cells)


def scattered_polygons():
    """Few large polygons of many degrees, with holes between them, and unused points."""
    random.seed(5)
    points = [(random.randint(-40, 40) / 8, random.randint(-40, 40) / 8, random.randint(0, 3) / 2) for _ in range(60)]
    cells = [random.sample(range(50), random.choice((0, 1, 2, 3, 3, 4, 5, 6, 7, 9, 14))) for _ in range(40)]
    return vtk(points, cells)
