"""Reads and writes .ravel files: polygon and tet meshes wound onto one strip.

    import ravel
    mesh = ravel.read("bone.ravel")             # mesh.points, mesh.cells, mesh.point_data, mesh.cell_data
    ravel.write("again.ravel", mesh.points, mesh.cells, mesh.point_data, mesh.cell_data, position_bits=14)

With meshio installed, `meshio.read("bone.ravel")` and `meshio.write("again.ravel", mesh)` work once this
package is imported.
"""

from .library import RavelError
from .mesh import CellBlock, Companion, Mesh, Strip
from .reading import Info, info, loads, read
from .writing import Written, dumps, write

__all__ = ["CellBlock", "Companion", "Info", "Mesh", "RavelError", "Strip", "Written", "dumps", "info",
           "loads", "read", "write"]

try:
    from . import meshio_format as _meshio_format
except ImportError:  # meshio is not installed
    pass
else:
    _meshio_format.register()
