"""Volume formats against another implementation.

meshio writes meshes, `ravel_convert` converts them, meshio reads both; points, cells and data must
be the same. Usage: meshio_volume_check.py RAVEL_CONVERT
"""

import pathlib
import subprocess
import sys
import tempfile
import warnings

import meshio
import numpy as np

warnings.simplefilter("ignore")

TETS = ("tetra", "tetra10")
POLYGONS = ("triangle", "quad", "polygon")


def meshes():
    """Name and mesh; points and values have all bits in use, and -0 and huge and tiny numbers."""
    rng = np.random.default_rng(5)

    def mesh(cells, points=24, dtype=np.float64):
        xyz = rng.normal(size=(points, 3)).astype(dtype)
        xyz[0] = [-0.0, 1e-30, 1e30]
        cells = [(kind, np.array(nodes)) for kind, nodes in cells]
        return meshio.Mesh(
            xyz,
            cells,
            point_data={"heat": rng.normal(size=points), "flow": rng.normal(size=(points, 3))},
            cell_data={
                "rank": [rng.normal(size=len(nodes)) for _, nodes in cells],
                "stress": [rng.normal(size=(len(nodes), 9)) for _, nodes in cells],
                "count": [rng.integers(-9, 9, size=len(nodes)) for _, nodes in cells],
            },
        )

    def some(kind, size, count):
        return kind, [rng.permutation(24)[:size] for _ in range(count)]

    yield "one tet", mesh([("tetra", [[0, 1, 2, 3]])], points=4)
    yield "tets", mesh([some("tetra", 4, 40)])
    yield "degenerate", mesh([("tetra", [[0, 0, 1, 2], [1, 1, 1, 1], [0, 1, 2, 3], [0, 1, 2, 3]])])
    yield "float32", mesh([some("tetra", 4, 9)], dtype=np.float32)
    yield "tets and their boundary", mesh([some("tetra", 4, 9), some("triangle", 3, 7),
                                           some("line", 2, 5), some("vertex", 1, 3)])
    yield "boundary first", mesh([some("vertex", 1, 2), some("line", 2, 3), some("triangle", 3, 7),
                                  some("tetra", 4, 9)])
    yield "quadratic tets", mesh([some("tetra10", 10, 6)])
    yield "quadratic and linear tets", mesh([some("triangle6", 6, 4), some("tetra10", 10, 6),
                                             some("tetra", 4, 3)])
    yield "all kinds of cells", mesh([some("wedge", 6, 3), some("tetra", 4, 4),
                                      some("hexahedron", 8, 2), some("pyramid", 5, 2),
                                      some("hexahedron20", 20, 2), some("quad", 4, 3),
                                      some("quad8", 8, 2)])
    yield "quads and triangles", mesh([some("quad", 4, 5), some("triangle", 3, 4)])
    yield "surface with lines", mesh([some("line", 2, 5), some("quad", 4, 5)])


def tagged(mesh):
    """The same with Gmsh's tags."""
    mesh = meshio.Mesh(mesh.points, mesh.cells, dict(mesh.point_data), dict(mesh.cell_data))
    for name in ("gmsh:physical", "gmsh:geometrical"):
        mesh.cell_data[name] = [
            np.full(len(block.data), 3 + i, dtype=np.int32) for i, block in enumerate(mesh.cells)
        ]
    return mesh


def writers():
    """Name, ending and a function that writes; None from it means that meshio can't."""

    def gmsh(mesh, path, version, binary):
        mesh = tagged(mesh)
        # Gmsh's data are doubles; meshio writes integers there as if they were.
        mesh.cell_data.pop("count")
        mesh.points = mesh.points.astype(float)
        if version == "gmsh":
            # meshio's 4.1 writer takes the entities from the nodes: each block's needs one. The
            # nodes must be in their order, for meshio's reader ignores the tags of data.
            entities = sorted((block.dim, 3 + i) for i, block in enumerate(mesh.cells))
            n = len(mesh.points)
            mesh.point_data["gmsh:dim_tags"] = np.array(
                [entities[i * len(entities) // n] for i in range(n)])
        elif len(mesh.cells) > 1:
            # meshio's 2.2 reader can't split data over several blocks.
            for name in ("rank", "stress"):
                mesh.cell_data.pop(name)
        meshio.write(path, mesh, file_format=version, binary=binary)

    for binary in (False, True):
        mode = "binary" if binary else "text"
        for version in ("gmsh22", "gmsh"):
            yield (f"{version} {mode}", ".msh",
                   lambda m, p, v=version, b=binary: gmsh(m, p, v, b))
        for version in ("4.2", "5.1"):
            yield (f"vtk {version} {mode}", ".vtk",
                   lambda m, p, v=version, b=binary: meshio.vtk.write(p, m, v, binary=b))
    yield "vtu text", ".vtu", lambda m, p: meshio.vtu.write(p, m, binary=False)
    for compression in (None, "zlib", "lzma"):
        for header in ("UInt32", "UInt64"):
            yield (f"vtu {compression} {header}", ".vtu",
                   lambda m, p, c=compression, h=header: meshio.vtu.write(
                       p, m, binary=True, compression=c, header_type=h))


def flat(mesh):
    """Cells in the order that ravel gives them, (kind, nodes), and all data in that order."""
    kinds = [block.type for block in mesh.cells for _ in block.data]
    nodes = [tuple(int(n) for n in cell) for block in mesh.cells for cell in block.data]
    main = TETS if any(kind in TETS for kind in kinds) else POLYGONS
    order = sorted(range(len(kinds)), key=lambda i: kinds[i] not in main)
    data = {
        name: np.concatenate([np.asarray(part) for part in parts])[order]
        for name, parts in mesh.cell_data.items()
        if parts
    }
    return [(kinds[i], nodes[i]) for i in order], data


def same(a, b):
    """Are the values equal, NaN and -0 included? Decimals of float32 are those of the nearest one."""
    a = np.asarray(a)
    number = np.float32 if a.dtype.kind == "f" and a.dtype.itemsize == 4 else np.float64
    a, b = np.asarray(a, dtype=number), np.asarray(b, dtype=number)
    return a.size == b.size and a.tobytes() == b.reshape(a.shape).tobytes()


def differences(before, after):
    if not same(before.points, after.points):
        yield "points"
    cells_before, data_before = flat(before)
    cells_after, data_after = flat(after)
    if cells_before != cells_after:
        yield "cells"
        return
    for name, values in before.point_data.items():
        # VTK and ravel keep Gmsh's node entities under names of their own.
        if name == "gmsh:dim_tags":
            continue
        if name not in after.point_data or not same(values, after.point_data[name]):
            yield f"point data {name}"
    for name, values in data_before.items():
        if name not in data_after or not same(values, data_after[name]):
            yield f"cell data {name}"
    extra = set(data_after) - set(data_before) | set(after.point_data) - set(before.point_data)
    for name in extra:
        # Every Gmsh element has an entity, and every node in version 4.
        if not name.startswith("gmsh:"):
            yield f"unexpected data {name}"


def main():
    convert = sys.argv[1]
    done, skipped, bad = 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for mesh_name, mesh in meshes():
            for writer, ending, write in writers():
                source = folder / ("in" + ending)
                try:
                    write(meshio.Mesh(mesh.points.copy(), mesh.cells, dict(mesh.point_data),
                                      {k: list(v) for k, v in mesh.cell_data.items()}), source)
                    before = meshio.read(source)
                except (Exception, SystemExit) as problem:  # noqa: BLE001
                    skipped += 1
                    print(f"skipped, meshio can't: {mesh_name}, {writer}: {problem!r}")
                    continue
                for target, options in [(e, o) for e in (".msh", ".vtk", ".vtu")
                                        for o in ([], ["--binary"])]:
                    result = folder / ("out" + target)
                    if result.exists():
                        result.unlink()
                    run = subprocess.run([convert, source, result, *options],
                                         capture_output=True, text=True)
                    what = f"{mesh_name}, {writer} -> {target} {' '.join(options)}"
                    if run.returncode != 0:
                        bad += 1
                        print(f"{what}: {run.stderr.strip()}")
                        continue
                    try:
                        after = meshio.read(result)
                    except (Exception, SystemExit) as problem:  # noqa: BLE001
                        # meshio rewrites the offsets of appended data while it looks for them, and
                        # takes one for the other when they happen to meet.
                        if target == ".vtu" and options and "multiple of element" in str(problem):
                            skipped += 1
                            print(f"skipped, meshio mixes up offsets: {what}")
                            continue
                        bad += 1
                        print(f"{what}: meshio can't read it: {problem!r}")
                        continue
                    wrong = list(differences(before, after))
                    done += 1
                    if wrong:
                        bad += 1
                        print(f"{what}: {', '.join(wrong)}")
    print(f"{done} conversions, {skipped} skipped, {bad} bad")
    return 1 if bad or done == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
