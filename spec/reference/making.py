"""What the meshes of `check` are made with: text of files, cells, places."""

import math


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


def border(cells):
    """The triangles of tets that are there once."""
    count = {}
    for a, b, c, d in cells:
        for f in ((a, b, d), (b, c, d), (c, a, d), (a, c, b)):
            count.setdefault(frozenset(f), []).append(f)
    return [f[0] for f in count.values() if len(f) == 1]


def bumpy_sheet(columns, rows):
    return [
        (float(x), y + 0.1 * math.sin(x), round(math.cos(x) * math.sin(y), 3))
        for y in range(rows + 1)
        for x in range(columns + 1)
    ]


def unit_vector(x, y, z):
    l = math.sqrt(x * x + y * y + z * z) or 1.0
    return x / l, y / l, z / l


def middle(points, cell):
    return tuple(sum(points[p][k] for p in cell) / len(cell) for k in range(3))


def data_arrays(place, count, arrays):
    lines = [f"{place} {count}", f"FIELD FieldData {len(arrays)}"]
    for name, scalar, tuples in arrays:
        lines.append(f"{name} {len(tuples[0])} {len(tuples)} {scalar}")
        lines += [" ".join(x if isinstance(x, str) else repr(x) for x in t) for t in tuples]
    return "\n".join(lines) + "\n"


def with_companions(points, blocks, scalar="double"):
    """`blocks` are (type, cells), the mesh's cells among them."""
    cells = [c for _, own in blocks for c in own]
    types = [str(type) for type, own in blocks for _ in own]
    text = vtk(points, cells, scalar=scalar)
    return text[: text.index("CELL_TYPES")] + f"CELL_TYPES {len(cells)}\n" + "\n".join(types) + "\n"


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
