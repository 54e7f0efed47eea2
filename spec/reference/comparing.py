"""What a decoded mesh and a file that the tool wrote differ in."""

import struct

import files
from beside import NO_TUPLE
from container import CELL, COMPANION, CORNER, MESH, POINT

TET = 10
QUADRATIC_TET = 24


def first_difference(ours, theirs):
    if len(ours) != len(theirs):
        return f"{len(ours)} against {len(theirs)}"
    for i, (a, b) in enumerate(zip(ours, theirs)):
        if a != b:
            return f"number {i}: {a} against {b}"
    return None


class Differences(list):
    def compare(self, what, ours, theirs):
        difference = first_difference(ours, theirs)
        if difference:
            self.append(f"{what}, {difference}")


def values_of_elements(a):
    """One tuple per element; None where it has none."""
    if not a.pooled:
        return list(a.values)
    return [None if t == NO_TUPLE else a.values[t] for t in a.indices]


def with_vtk(mesh, data):
    theirs = files.read_vtk(data)
    differences = Differences()
    if mesh.points and mesh.wide != theirs.wide:
        differences.append("wide")
    differences.compare("points", mesh.points, theirs.points)
    # cells, and behind them the companions
    cells = [list(cell) for cell in mesh.cells]
    types = [TET] * len(cells) if mesh.tets else theirs.types[: len(cells)]
    companions = []
    written = []  # of all companions, which are cells of the file
    for b in mesh.companions:
        is_part = b.vtk_type == QUADRATIC_TET and b.hosts is not None
        written += [not is_part] * len(b.cells)
        if is_part:
            for host, nodes in zip(b.hosts, b.cells):
                cells[host] = cells[host] + list(nodes)
                types[host] = QUADRATIC_TET
        else:
            companions += b.cells
            types += [b.vtk_type] * len(b.cells)
    differences.compare("cells", cells + companions, theirs.cells)
    differences.compare("types", types, theirs.types)
    # attributes
    of_cells = {}
    for a in mesh.attributes:
        name = a.name.decode("utf-8", "surrogateescape")
        values = values_of_elements(a)
        if a.place == POINT:
            compare_field(differences, "point " + name, a, values, theirs.point_data.get(name))
        elif a.place in (CELL, COMPANION):
            if a.place == COMPANION:
                values = [v for v, is_cell in zip(values, written) if is_cell]
            of_cells.setdefault(name, {})[a.place] = a, values
        elif a.place == MESH:
            compare_field(differences, "mesh " + name, a, values, theirs.fields.get(name))
    for name, parts in of_cells.items():
        values = []
        for place, count in ((CELL, len(mesh.cells)), (COMPANION, len(theirs.cells) - len(mesh.cells))):
            values += parts[place][1][:count] if place in parts else [None] * count
        a = next(iter(parts.values()))[0]
        compare_field(differences, "cell " + name, a, values, theirs.cell_data.get(name))
    # names
    tags = {}
    for attribute, dimension, value, name in mesh.names:
        attribute = attribute.decode("utf-8", "surrogateescape")
        tags[f"ravel:tag:{dimension}:{value}:{attribute}"] = name
    their_tags = {
        key: bytes(x & 255 for (x,) in values)
        for key, (_, values) in theirs.fields.items()
        if key.startswith("ravel:tag:")
    }
    differences.compare("names", sorted(tags.items()), sorted(their_tags.items()))
    return differences


def compare_field(differences, what, a, values, theirs):
    if theirs is None:
        if values and a.name.isalnum():
            differences.append(f"{what}: not there")
        return
    scalar, their_values = theirs
    if scalar != a.scalar:
        differences.append(f"{what}: {a.scalar} against {scalar}")
    # an element without a tuple is told elsewhere
    their_values = [t if v is not None else None for v, t in zip(values, their_values)] + their_values[len(values) :]
    differences.compare(what, values, their_values)


def with_ply(mesh, data):
    theirs = files.read_ply(data)
    differences = Differences()
    v = theirs["vertex"].values
    differences.compare("points", mesh.points, list(zip(v["x"], v["y"], v["z"])))
    faces = theirs["face"].values if "face" in theirs else {"vertex_indices": []}
    differences.compare("cells", mesh.cells, faces["vertex_indices"])
    for a in mesh.attributes:
        name = a.name.decode("utf-8", "surrogateescape").removeprefix("ply:")
        values = values_of_elements(a)
        if a.place == CORNER and name in faces:
            at = 0
            for c, cell in enumerate(mesh.cells):
                ours = [x for t in values[at : at + len(cell)] for x in (t or [None] * a.arity)]
                at += len(cell)
                if any(x is not None and x != y for x, y in zip(ours, faces[name][c])):
                    differences.append(f"corners of cell {c}, {name}: {ours} against {faces[name][c]}")
                    break
        elif a.place in (POINT, CELL):
            columns = v if a.place == POINT else faces
            names = [name] if a.arity == 1 else [f"{name}.{k}" for k in range(a.arity)]
            for k, column in enumerate(names):
                if column in columns:
                    ours = [t[k] if t else None for t in values]
                    differences.compare(column, ours, [y if x is not None else None for x, y in zip(ours, columns[column])])
                elif values and not a.pooled:
                    differences.append(f"{column}: not there")
    return differences


def with_obj(mesh, data):
    """Points, cells, texture corners and normals; texts of floats are the shortest that name them."""
    def bits(x, wide):
        if wide:
            return struct.unpack("<Q", struct.pack("<d", float(x)))[0]
        return struct.unpack("<I", struct.pack("<f", float(x)))[0]

    differences = Differences()
    lines = [line.split() for line in data.decode().splitlines()]
    points = [tuple(bits(x, mesh.wide) for x in w[1:4]) for w in lines if w and w[0] == "v"]
    differences.compare("points", mesh.points, points)
    faces = [[x.split("/") for x in w[1:]] for w in lines if w and w[0] == "f"]
    differences.compare("cells", mesh.cells, [[int(x[0]) - 1 for x in f] for f in faces])
    for key, place in (("vt", 1), ("vn", 2)):
        a = next((a for a in mesh.attributes if a.place == CORNER and a.name.decode() in (key, "obj:" + key)), None)
        if a is None:
            continue
        pool = [tuple(bits(x, a.scalar == "f64") for x in w[1:]) for w in lines if w and w[0] == key]
        theirs = [pool[int(x[place]) - 1] if len(x) > place and x[place] else None for f in faces for x in f]
        differences.compare(key, values_of_elements(a), theirs)
        if a.pooled:
            differences.compare(key + " pool", list(a.values), pool)
    return differences


BY_ENDING = {"vtk": with_vtk, "ply": with_ply, "obj": with_obj}
