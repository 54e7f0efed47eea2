"""What a decoded mesh and a file that the tool wrote differ in."""

import files

TET = 10


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


def with_vtk(mesh, data):
    theirs = files.read_vtk(data)
    differences = Differences()
    if mesh.points and mesh.wide != theirs.wide:
        differences.append("wide")
    differences.compare("points", mesh.points, theirs.points)
    differences.compare("cells", mesh.cells, theirs.cells[: len(mesh.cells)])
    if mesh.tets:
        differences.compare("types", [TET] * len(mesh.cells), theirs.types[: len(mesh.cells)])
    return differences


def with_ply(mesh, data):
    theirs = files.read_ply(data)
    differences = Differences()
    v = theirs["vertex"].values
    differences.compare("points", mesh.points, list(zip(v["x"], v["y"], v["z"])))
    differences.compare("cells", mesh.cells, theirs["face"].values["vertex_indices"] if "face" in theirs else [])
    return differences
