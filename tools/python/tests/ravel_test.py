"""The Python package against libravel and, where it is there, meshio.

usage: ravel_test.py LIBRAVEL RAVEL    (LIBRAVEL: libravel.so; RAVEL: the tool, which makes meshes)
"""

import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
os.environ["RAVEL_LIBRARY"], TOOL = sys.argv[1], sys.argv[2]

import numpy as np

try:
    import meshio
except ImportError:
    meshio = None

import ravel

FOLDER = tempfile.TemporaryDirectory()


def path_of(name):
    return os.path.join(FOLDER.name, name)


def made(recipe, ending):
    mesh = path_of("made." + ending)
    subprocess.run([TOOL, "-q", "make", recipe, "-o", mesh, "--force"], check=True)
    subprocess.run([TOOL, "-q", "encode", mesh, "-o", path_of("made.ravel"), "--force"], check=True)
    return mesh, path_of("made.ravel")


def polygon_set(points, blocks):
    """Polygons as sets of rings of positions, turned to start with their lowest corner."""
    rings = set()
    for _, data in blocks:
        for row in data:
            ring = [tuple(points[i]) for i in row]
            start = ring.index(min(ring))
            rings.add(tuple(ring[start:] + ring[:start]))
    return rings


def even(permutation):
    return sum(a > b for i, a in enumerate(permutation) for b in permutation[i + 1:]) % 2 == 0


class Surfaces(unittest.TestCase):
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0], [3, 0.5, 0]], np.float32)
    cells = [("quad", [[0, 1, 2, 3], [1, 4, 5, 2]]), ("triangle", [[4, 6, 5]])]

    def test_cells_and_data_follow_the_order_that_write_tells(self):
        point_data = {"heat": np.arange(7, dtype=np.float64), "flow": np.arange(21, dtype=np.float32).reshape(7, 3)}
        cell_data = {"region": [np.array([7, 8], np.int32), np.array([9], np.int32)]}
        written = ravel.write(path_of("a.ravel"), self.points, self.cells, point_data, cell_data)
        mesh = ravel.read(path_of("a.ravel"))
        self.assertEqual(written.position_bound, 0)
        np.testing.assert_array_equal(mesh.points[written.new_point], self.points)
        for name, values in point_data.items():
            np.testing.assert_array_equal(mesh.point_data[name][written.new_point], values)
            self.assertEqual(mesh.point_data[name].dtype, values.dtype)
        self.assertEqual(polygon_set(mesh.points, mesh.cells), polygon_set(self.points, self.cells))
        by_number = {}
        for numbers, regions in zip(mesh.numbers, mesh.cell_data["region"]):
            by_number.update(zip(numbers, regions))
        self.assertEqual([by_number[new] for new in written.new_cell], [7, 8, 9])

    def test_the_order_is_kept_when_asked(self):
        ravel.write(path_of("b.ravel"), self.points, self.cells, keep_order=True)
        mesh = ravel.read(path_of("b.ravel"))
        np.testing.assert_array_equal(mesh.points, self.points)
        self.assertEqual([kind for kind, _ in mesh.cells], ["quad", "triangle"])
        for (_, expected), (_, found) in zip(self.cells, mesh.cells):
            np.testing.assert_array_equal(found, expected)

    def test_polygons_of_any_degree_by_offsets(self):
        begin, corners = [0, 5, 8], [0, 1, 4, 5, 3, 4, 6, 5]
        mesh = ravel.loads(ravel.dumps(self.points, ("polygon", (begin, corners)), keep_order=True, fast=True).bytes)
        self.assertEqual([(kind, data.shape) for kind, data in mesh.cells], [("polygon", (1, 5)), ("triangle", (1, 3))])

    def test_threads_change_no_byte(self):
        alone = ravel.dumps(self.points, self.cells, threads=1).bytes
        self.assertEqual(ravel.dumps(self.points, self.cells, threads=3).bytes, alone)
        with self.assertRaises(ValueError):
            ravel.dumps(self.points, self.cells, threads=-1)

    def test_a_grid_keeps_its_bound(self):
        written = ravel.dumps(self.points.astype(np.float64), self.cells, max_error=1e-3)
        error = np.abs(ravel.loads(written.bytes).points[written.new_point] - self.points).max()
        self.assertLessEqual(error, written.position_bound)
        self.assertLessEqual(written.position_bound, 1e-3)
        self.assertGreater(written.position_bound, 0)

    def test_the_bound_may_be_told_in_diagonals_or_by_a_lattice(self):
        points = self.points.astype(np.float64)
        diagonal = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
        relative = ravel.dumps(points, self.cells, max_error_relative=1e-3)
        self.assertGreater(relative.position_bound, 0)
        self.assertLessEqual(relative.position_bound, 1e-3 * diagonal)
        on_lattice = ravel.loads(ravel.dumps(points + 0.3, self.cells, lattice=2.0**-4).bytes).points * 16
        np.testing.assert_array_equal(on_lattice, np.round(on_lattice))

    def test_data_keep_the_bound_they_are_given(self):
        heat = np.linspace(0, 1, len(self.points))
        written = ravel.dumps(self.points, self.cells, {"heat": heat, "exact": heat}, attribute_bounds={"heat": {"max_error": 1e-3}})
        mesh = ravel.loads(written.bytes)
        self.assertLessEqual(np.abs(mesh.point_data["heat"][written.new_point] - heat).max(), 1e-3)
        np.testing.assert_array_equal(mesh.point_data["exact"][written.new_point], heat)
        self.assertEqual([bound > 0 for bound in written.attribute_bounds], [True, False])
        with self.assertRaises(ravel.RavelError):
            ravel.dumps(self.points, self.cells, {"heat": heat}, attribute_bounds={"cold": {"bits": 8}})

    def test_whatever_a_mesh_has_comes_back(self):
        mesh = ravel.read(made("torus:quads=500,attributes,seed=3", "ply")[1])
        self.assertGreater(len(mesh.point_data) + len(mesh.cell_data), 1)
        again = ravel.loads(ravel.dumps(
            mesh.points, mesh.cells, mesh.point_data, mesh.cell_data, corner_data=mesh.corner_data, mesh_data=mesh.mesh_data,
            tag_names=mesh.tag_names, notes=mesh.notes, keep_order=True).bytes)
        np.testing.assert_array_equal(again.points, mesh.points)
        for table in ("point_data", "corner_data", "mesh_data"):
            self.assertEqual(list(getattr(again, table)), list(getattr(mesh, table)))
            for name, values in getattr(mesh, table).items():
                np.testing.assert_array_equal(getattr(again, table)[name], values)
        self.assertEqual((again.tag_names, again.notes), (mesh.tag_names, mesh.notes))

    def test_the_strip_visits_every_cell_once_through_shared_sides(self):
        mesh = ravel.read(made("sphere:subdivide=3", "ply")[1], strip=True)
        quads, = [data for kind, data in mesh.cells if kind == "quad"]
        strip = mesh.strip
        self.assertEqual(sorted(strip.cell), list(range(len(quads))))
        self.assertEqual((strip.came_from < 0).sum(), 1)
        for cell, before, leave, enter in zip(strip.cell, strip.came_from, strip.exit, strip.entry):
            if before >= 0:
                a = {quads[before][leave], quads[before][(leave + 1) % 4]}
                self.assertEqual(a, {quads[cell][enter], quads[cell][(enter + 1) % 4]})


class Tets(unittest.TestCase):
    def test_tets_and_companions_come_back(self):
        mesh = ravel.read(made("tets:box=4x3x2,attributes,companions", "msh")[1])
        self.assertEqual([(kind, data.shape) for kind, data in mesh.cells], [("tetra", (4 * 3 * 2 * 6, 4))])
        self.assertGreater(len(mesh.companions), 0)
        written = ravel.dumps(mesh.points, mesh.cells, mesh.point_data, mesh.cell_data, companions=mesh.companions,
                              companion_data=mesh.companion_data)
        again = ravel.loads(written.bytes)
        np.testing.assert_array_equal(again.points[written.new_point], mesh.points)
        ours, theirs = written.new_point[mesh.cells[0].data], again.cells[0].data[written.new_cell]
        for before, after in zip(ours, theirs):
            self.assertTrue(even([list(before).index(point) for point in after]))
        for name, (values,) in mesh.cell_data.items():
            np.testing.assert_array_equal(again.cell_data[name][0][written.new_cell], values)
        for before, after in zip(mesh.companions, again.companions):
            np.testing.assert_array_equal(written.new_point[before.data], after.data)
        for name, parts in mesh.companion_data.items():
            for before, after in zip(parts, again.companion_data[name]):
                np.testing.assert_array_equal(before, after)


class Trouble(unittest.TestCase):
    def test_broken_files_raise_and_nothing_else(self):
        good = ravel.dumps(Surfaces.points, Surfaces.cells).bytes
        self.assertEqual(ravel.loads(good).points.shape, (7, 3))
        random, refused = np.random.default_rng(1), 0
        for _ in range(300):
            bad = bytearray(good)
            bad[random.integers(len(bad))] ^= 1 << random.integers(8)
            try:
                ravel.loads(bad[:random.integers(len(bad))] if random.integers(2) else bad)
            except ravel.RavelError as error:
                refused += 1
                self.assertTrue(error.code and error.sentence)
        self.assertGreater(refused, 250)
        with self.assertRaises(ravel.RavelError) as caught:
            ravel.loads(b"no ravel file")
        self.assertEqual((caught.exception.code, caught.exception.place), ("not_a_ravel_file", 0))
        with self.assertRaises(ravel.RavelError) as caught:
            ravel.loads(good, memory_limit=10)
        self.assertEqual(caught.exception.code, "limit_exceeded")

    def test_broken_meshes_raise(self):
        with self.assertRaises(ravel.RavelError) as caught:
            ravel.dumps(Surfaces.points, [("quad", [[0, 1, 2, 99]])])
        self.assertEqual(caught.exception.code, "bad_mesh")
        with self.assertRaises(ValueError):
            ravel.dumps(Surfaces.points, [("quad", [[0, 1, 2, 3]]), ("tetra", [[0, 1, 2, 3]])])
        with self.assertRaises(ValueError):
            ravel.dumps(Surfaces.points, Surfaces.cells, cell_data={"x": [np.zeros(3)]})
        with self.assertRaises(TypeError):
            ravel.dumps(Surfaces.points, Surfaces.cells, point_data={"x": np.zeros(7, complex)})

    def test_empty_meshes_and_streams(self):
        self.assertEqual(len(ravel.loads(ravel.dumps(np.empty((0, 3)), []).bytes).points), 0)
        stream = io.BytesIO()
        ravel.write(stream, Surfaces.points, Surfaces.cells)
        self.assertEqual(ravel.read(io.BytesIO(stream.getvalue())).points.shape, (7, 3))
        info = ravel.info(io.BytesIO(stream.getvalue()))
        self.assertEqual((info.kind, info.points, info.cells, info.exact_positions), ("polygon", 7, 3, True))


@unittest.skipIf(meshio is None, "MESHIO IS MISSING: its format is not tested")
class Meshio(unittest.TestCase):
    def check(self, mesh, **options):
        meshio.write(path_of("m.ravel"), mesh, keep_order=True, **options)
        again = meshio.read(path_of("m.ravel"))
        np.testing.assert_array_equal(again.points, mesh.points)
        self.assertEqual([block.type for block in again.cells], [block.type for block in mesh.cells])
        for before, after in zip(mesh.cells, again.cells):
            np.testing.assert_array_equal(before.data, after.data)
        for name, values in mesh.point_data.items():
            np.testing.assert_array_equal(again.point_data[name], values)
        for name, parts in mesh.cell_data.items():
            for before, after in zip(parts, again.cell_data[name]):
                np.testing.assert_array_equal(before, after)
        return again

    def test_surfaces(self):
        self.check(meshio.Mesh(Surfaces.points, Surfaces.cells, {"heat": np.arange(7.0)}, {"region": [np.array([1, 2]), np.array([3])]}))

    def test_a_volume_with_names_and_a_boundary(self):
        made_mesh = ravel.read(made("tets:box=3x3x3,attributes,companions", "msh")[1])
        ravel.write(path_of("named.ravel"), made_mesh.points, made_mesh.cells, made_mesh.point_data, made_mesh.cell_data,
                    companions=made_mesh.companions, companion_data=made_mesh.companion_data,
                    tag_names=[("region", 3, 1, "core"), ("region", 2, 7, "skin")])
        mesh = meshio.read(path_of("named.ravel"))
        self.assertTrue(mesh.field_data and mesh.cell_data)
        tets = [b for b in mesh.cells if b.type == "tetra"]
        self.assertTrue(tets and len(mesh.cells) > len(tets))
        meshio.write(path_of("n.ravel"), mesh, keep_order=True)
        again = meshio.read(path_of("n.ravel"))
        np.testing.assert_array_equal(again.points, mesh.points)
        for kind in {block.type for block in mesh.cells}:
            np.testing.assert_array_equal(np.concatenate([b.data for b in again.cells if b.type == kind]),
                                          np.concatenate([b.data for b in mesh.cells if b.type == kind]))
        for name, parts in mesh.cell_data.items():
            self.assertEqual([part.tolist() for part in again.cell_data[name]], [part.tolist() for part in parts])
        self.assertEqual({name: list(pair) for name, pair in again.field_data.items()},
                         {name: list(pair) for name, pair in mesh.field_data.items()})

    def test_quadratic_tets(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float64)
        tets = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
        middle = {}
        for tet in tets:
            for a, b in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)):
                middle.setdefault(frozenset((tet[a], tet[b])), len(points) + len(middle))
        rows = [[*tet, *(middle[frozenset((tet[a], tet[b]))] for a, b in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)))] for tet in tets]
        ends = [tuple(edge) for edge in middle]
        points = np.vstack([points, [(points[a] + points[b]) / 2 for a, b in ends]])
        self.check(meshio.Mesh(points, [("tetra10", rows), ("line", [[0, 1]])], cell_data={"part": [np.array([4, 5]), np.array([6])]}))

    def test_what_is_broken_is_meshios_error(self):
        with open(path_of("bad.ravel"), "wb") as file:
            file.write(b"Rav1")
        from ravel import meshio_format
        with self.assertRaises(meshio.ReadError):
            meshio_format.read(path_of("bad.ravel"))
        with self.assertRaises(meshio.WriteError):
            meshio.write(path_of("bad.ravel"), meshio.Mesh(Surfaces.points, [("quad", [[0, 1, 2, 99]])]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
