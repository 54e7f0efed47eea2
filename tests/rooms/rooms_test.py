#!/usr/bin/env python3
"""Checks every #include of codec/ against the table of which room may see which.

usage: rooms_test.py CODEC_FOLDER
"""
import pathlib
import re
import sys

# Room -> the rooms whose headers it may include, besides its own.
MAY_INCLUDE = {
    "base": set(),
    "mesh": {"base"},
    "graph": {"base"},
    "strip": {"base", "mesh", "graph"},
    "walk": {"base", "mesh"},
    "predict": {"base", "mesh"},
    "entropy": {"base"},
    "container": {"base"},
    "decode": {"base", "mesh", "walk", "predict", "entropy", "container"},
    "encode": {"base", "mesh", "graph", "strip", "walk", "predict", "entropy", "container"},
    # The C interface: it sees what every user sees.
    "c": set(),
}

# The public headers are words everybody may use, but a room of pure theory knows no mesh, and
# options and results belong to those who serve them. `mesh` holds the comparison of two meshes.
PUBLIC = {
    "ravel/result.h": set(MAY_INCLUDE),
    "ravel/mesh.h": set(MAY_INCLUDE) - {"base", "graph", "entropy"},
    "ravel/ravel.h": {"mesh", "strip", "encode", "decode", "c"},
    "ravel/ravel_c.h": {"c"},
}

# Libraries: the entropy room packs, the graph room (the encoder's) matches.
LIBRARIES = {
    "zstd.h": {"entropy"},
    "zstd_errors.h": {"entropy"},
    "lemon/core.h": {"graph"},
    "lemon/matching.h": {"graph"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
# C++'s headers have no dot and no folder; of C's the interface for C takes two.
STANDARD = re.compile(r"^([a-z_0-9]+|stddef\.h|stdint\.h)$")


def complaint(room, quote, header):
    if quote == "<":
        if STANDARD.match(header) or room in LIBRARIES.get(header, ()):
            return None
        return f"<{header}> is a library this room does not know"
    if header in PUBLIC:
        return None if room in PUBLIC[header] else f'"{header}" is not for this room'
    other = header.split("/")[0] if "/" in header else None
    if other is None:
        return f'"{header}" must be written with its room'
    if other == room or other in MAY_INCLUDE[room]:
        return None
    return f'"{header}": {room} may not see {other}'


def main(codec):
    wrong, includes, files = [], 0, 0
    for path in sorted(codec.rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        files += 1
        room = path.relative_to(codec).parts[0]
        if room != "include" and room not in MAY_INCLUDE:
            wrong.append(f"{path}: {room} is no room")
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            includes += 1
            if room == "include":
                quote, header = found.groups()
                ok = header in PUBLIC if quote == '"' else STANDARD.match(header)
                problem = None if ok else f"{header}: public headers include each other and the library only"
            else:
                problem = complaint(room, *found.groups())
            if problem:
                wrong.append(f"{path}:{number}: {problem}")
    print(f"{includes} includes in {files} files, {len(wrong)} wrong")
    for line in wrong:
        print(line)
    return 1 if wrong or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
