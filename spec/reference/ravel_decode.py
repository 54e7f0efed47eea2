#!/usr/bin/env python3
"""Ravel's second decoder: written from ../format.md alone, to be read beside it, slow.

ravel_decode.py FILE.ravel prints what is inside; errors are those of chapter 14.
"""

import math
import sys

import container
from container import COMPANIONS, ATTRIBUTES, CONNECTIVITY, NAMES, ORDER, POSITIONS
from attributes import Elements, read_attributes
from companions import read_companions
from errors import Invalid, require
from mesh import build_mesh
from names import read_names
from flags import Stream
from old_mesh import restore
from order import Order
from positions import Positions
from positions_head import read_positions_head
from shape import Shape
from strip import read_strip
from walk_folds import FoldWalk
from walk_surface import SurfaceWalk
from walk_tet import TetWalk

WRONG_LINKS = "links other than `links`"


def decode(data, with_strip=True, limit=math.inf):
    """A mesh from the bytes of a file."""
    # 3
    sections = container.read_sections(data)
    head = container.read_head(sections[container.HEAD])
    block = container.read_block(sections[container.BLOCK], head.tets)
    container.check_references(head, block)
    container.check_sections(sections, head, block)
    container.check_sizes(block, sections)
    container.check_memory(head, block, sections, limit)
    # 5 - 8
    positions_head = read_positions_head(sections[POSITIONS], head)
    positions = Positions(head, block, positions_head, Stream(positions_head.bits, "positions"))
    stream = Stream(sections[CONNECTIVITY], "tet" if head.tets else "surface")
    kind_of_walk = SurfaceWalk if not head.tets else FoldWalk if block.by_folds else TetWalk
    walk = kind_of_walk(head, block, stream, positions)
    walk.run()
    # 9
    mesh = build_mesh(head, block, walk)
    # 10, 11, 12
    shape = Shape(head, block, walk, mesh)
    marked_facets = []
    if COMPANIONS in sections:
        mesh.companions, marked_facets = read_companions(sections[COMPANIONS], block, shape)
    elements = Elements(shape, mesh.companions, marked_facets)
    if ATTRIBUTES in sections:
        mesh.attributes = read_attributes(sections[ATTRIBUTES], head.attributes, elements)
    if NAMES in sections:
        mesh.names, mesh.notes = read_names(sections[NAMES])
    # 13
    if head.keeps_order:
        restore(Order(sections[ORDER], shape, mesh, elements))
    if with_strip:
        mesh.is_link = read_strip(walk)
        require(sum(mesh.is_link) == block.links, WRONG_LINKS)
    return mesh


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    with open(arguments[0], "rb") as file:
        data = file.read()
    try:
        mesh = decode(data)
    except Invalid as error:
        print(error, file=sys.stderr)
        return 4
    kind = "tets" if mesh.tets else "polygons"
    print(f"{len(mesh.points)} points, {len(mesh.cells)} {kind}, {sum(mesh.is_link)} links")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
