"""Chapter 12: names and notes."""

from conventions import Bytes
from errors import require


def read_names(data):
    bytes = Bytes(data)
    count = bytes.varint()
    require(count <= bytes.left() // 4, "name_count")
    names = []
    for _ in range(count):
        attribute = bytes.text()
        dimension = bytes.zigzag()
        require(-1 <= dimension <= 3, "dimension")
        value = bytes.zigzag()
        names.append((attribute, dimension, value, bytes.text()))
    count = bytes.varint()
    require(count <= bytes.left() // 2, "note_count")
    notes = [(bytes.text(), bytes.text()) for _ in range(count)]
    bytes.end()
    return names, notes
