"""Binary legacy VTK and PLY, as far as the tool `ravel` writes them: what `check` compares with.

Floats are kept as their bits, so NaN is equal to itself and 0 is not -0.
"""

import struct
from types import SimpleNamespace
from urllib.parse import unquote

VTK_TYPES = {
    "float": ("I", 4), "double": ("Q", 8), "char": ("b", 1), "unsigned_char": ("B", 1),
    "short": ("h", 2), "unsigned_short": ("H", 2), "int": ("i", 4), "unsigned_int": ("I", 4),
    "long": ("q", 8), "unsigned_long": ("Q", 8), "vtktypeint64": ("q", 8), "vtktypeuint64": ("Q", 8),
    "vtkIdType": ("q", 8), "bit": ("B", 1),
}
SCALAR_OF = {
    "float": "f32", "double": "f64", "char": "i8", "unsigned_char": "u8", "short": "i16",
    "unsigned_short": "u16", "int": "i32", "unsigned_int": "u32", "long": "i64", "unsigned_long": "u64",
    "vtktypeint64": "i64", "vtktypeuint64": "u64",
}


class Lines:
    def __init__(self, data):
        self.data = data
        self.at = 0

    def line(self):
        """The next line that is not empty; None at the end."""
        while self.at < len(self.data):
            end = self.data.find(b"\n", self.at)
            end = len(self.data) if end < 0 else end
            line = self.data[self.at : end].decode("utf-8", "surrogateescape")
            self.at = end + 1
            if line.strip():
                return line
        return None

    def numbers(self, order, letter, size, n):
        values = struct.unpack_from(f"{order}{n}{letter}", self.data, self.at)
        self.at += n * size
        return list(values)


def read_vtk(data):
    lines = Lines(data)
    assert lines.line().startswith("# vtk DataFile")
    lines.line()
    assert lines.line() == "BINARY"
    lines.line()
    mesh = SimpleNamespace(points=[], wide=False, cells=[], types=[], fields={}, point_data={}, cell_data={})
    target = mesh.fields
    while (line := lines.line()) is not None:
        words = line.split()
        if words[0] == "POINTS":
            mesh.wide = words[2] == "double"
            x = lines.numbers(">", *VTK_TYPES[words[2]], 3 * int(words[1]))
            mesh.points = [tuple(x[i : i + 3]) for i in range(0, len(x), 3)]
        elif words[0] == "CELLS":
            x = lines.numbers(">", "i", 4, int(words[2]))
            at = 0
            while at < len(x):
                mesh.cells.append(x[at + 1 : at + 1 + x[at]])
                at += 1 + x[at]
        elif words[0] == "CELL_TYPES":
            mesh.types = lines.numbers(">", "i", 4, int(words[1]))
        elif words[0] == "POINT_DATA":
            target = mesh.point_data
        elif words[0] == "CELL_DATA":
            target = mesh.cell_data
        elif words[0] == "FIELD":
            for _ in range(int(words[2])):
                name, arity, tuples, type = lines.line().split()
                arity = int(arity)
                x = lines.numbers(">", *VTK_TYPES[type], arity * int(tuples))
                target[unquote(name)] = SCALAR_OF[type], [tuple(x[i : i + arity]) for i in range(0, len(x), arity)]
        else:
            raise ValueError(f"VTK line {line}")
    return mesh


PLY_TYPES = {
    "char": ("b", "i8"), "uchar": ("B", "u8"), "short": ("h", "i16"), "ushort": ("H", "u16"),
    "int": ("i", "i32"), "uint": ("I", "u32"), "int64": ("q", "i64"), "uint64": ("Q", "u64"),
    "float": ("I", "f32"), "double": ("Q", "f64"),
}


def read_ply(data):
    """Per element a dictionary of its properties, scalars or lists, and the types of these."""
    lines = Lines(data)
    assert lines.line() == "ply"
    elements = []
    while (line := lines.line()) != "end_header":
        words = line.split()
        if words[0] == "format":
            assert words[1] == "binary_little_endian"
        elif words[0] == "element":
            elements.append(SimpleNamespace(name=words[1], count=int(words[2]), types={}, values={}))
        elif words[0] == "property":
            elements[-1].types[words[-1]] = words[1:-1]
            elements[-1].values[words[-1]] = []
    for element in elements:
        for _ in range(element.count):
            for name, type in element.types.items():
                if type[0] == "list":
                    (n,) = read_one(lines, PLY_TYPES[type[1]][0], 1)
                    element.values[name].append(read_one(lines, PLY_TYPES[type[2]][0], n))
                else:
                    element.values[name].append(read_one(lines, PLY_TYPES[type[0]][0], 1)[0])
    return {element.name: element for element in elements}


def read_one(lines, letter, n):
    size = struct.calcsize(letter)
    return lines.numbers("<", letter, size, n)
