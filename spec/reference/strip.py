"""9.2: the strip, for readers that want it."""

from conventions import NONE


def read_strip(walk):
    """The gates of the walk that are links, by their cell."""
    cells = walk.cell_count
    parent = [NONE if g == NONE else walk.cell_of[g] for g in walk.gate]
    size = [1] * cells
    for c in reversed(range(cells)):
        if parent[c] != NONE:
            size[parent[c]] += size[c]
    links = [0] * cells
    below = [0] * cells
    open = [0] * cells
    closing = [NONE] * cells
    open_child = [NONE] * cells
    for c in reversed(range(cells)):
        # the children have added their links to below[c]
        best = open[c] = below[c]
        for f in range(walk.first[c], walk.first[c + 1]):
            if walk.twin[f] == NONE or walk.cell_of[walk.twin[f]] <= c:
                continue
            z = walk.cell_of[walk.twin[f]]
            if walk.gate[z] == f:
                on = below[c] - links[z] + open[z]
                if on < open[c]:
                    open[c] = on
                    open_child[c] = z
            elif z < c + size[c]:
                sum = below[c]
                x = z
                while x != c:
                    sum += below[x] - links[x]
                    x = parent[x]
                if sum < best:
                    best = sum
                    closing[c] = z
        links[c] = best + 1
        if parent[c] != NONE:
            below[parent[c]] += links[c]

    taken = [False] * cells
    is_link = [False] * cells
    for c in range(cells):
        if taken[c]:
            continue
        taken[c] = True
        if parent[c] == NONE:
            if links[c] - 1 >= open[c]:
                x = open_child[c]
                while x != NONE:
                    taken[x] = True
                    x = open_child[x]
                continue
        else:
            is_link[c] = True
        x = closing[c]
        while x != NONE and x != c:
            taken[x] = True
            x = parent[x]
    return is_link
