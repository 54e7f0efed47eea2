"""8.9 and chapter 9: from the walk to the mesh."""

import struct
from types import SimpleNamespace

from conventions import NONE, f32


def bits_of(x, wide):
    if wide:
        return struct.unpack("<Q", struct.pack("<d", x))[0]
    return struct.unpack("<I", struct.pack("<f", f32(x)))[0]


def coordinates(head, positions, v):
    """8.9: the bits of the three coordinates of vertex v."""
    result = []
    for k in range(3):
        if (v, k) in positions.escaped_bits:
            result.append(positions.escaped_bits[v, k])
            continue
        if head.lossless:
            x = positions.coordinate_of(v, k)
        else:
            x = head.origin[k] + head.step * positions.value[v][k]
        result.append(bits_of(x, head.wide))
    return tuple(result)


def build_mesh(head, block, walk):
    """9.1"""
    positions = walk.positions
    mesh = SimpleNamespace(
        tets=head.tets, wide=head.wide, points=[], cells=[], companions=[], attributes=[],
        names=[], notes=[])
    # the point of each vertex, and of each point a vertex that is no copy
    point_of = mesh.point_of = []
    mesh.vertex_of = [v for v in range(block.vertices) if walk.copy_of[v] == NONE]
    for v in range(block.vertices):
        copied = walk.copy_of[v]
        if copied == NONE:
            point_of.append(len(mesh.points))
            mesh.points.append(coordinates(head, positions, v))
        else:
            point_of.append(point_of[copied])
    for v in range(block.vertices, block.vertices + block.unused_points):
        mesh.points.append(coordinates(head, positions, v))
    for c in range(block.cells):
        cell = [point_of[v] for v in walk.vertex[walk.first[c] : walk.first[c + 1]]]
        if walk.flipped[c]:
            if head.tets:
                cell[2], cell[3] = cell[3], cell[2]
            else:
                cell[1:] = cell[:0:-1]
        mesh.cells.append(cell)
    return mesh
