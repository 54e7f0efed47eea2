"""11.5: links between elements, and the walls about a link."""

from conventions import NONE, cross, minus
from shape import flatness

MOST_FACETS = 24
LINKED = {(3, 2), (5, 3), (9, 4)}


class CellLinks:
    def __init__(self, shape, marked_facets):
        self.shape = shape
        self.walls = set()
        self.former = set(marked_facets) | {shape.twin[f] for f in marked_facets if shape.twin[f] != NONE}

    def begin(self):
        """An attribute begins."""
        self.former |= self.walls
        self.walls = set()

    def links(self, cell):
        return self.shape.corners(cell)

    def twin(self, f):
        return self.shape.twin[f]

    def element(self, f):
        return self.shape.cell_of[f]

    def make_wall(self, f):
        self.walls.add(f)

    def walls_about(self, f, known):
        s = w = 0
        around = self.around_tet if self.shape.tets else self.around_polygon
        for turn in around(f, known):
            for g, a, b in turn:
                if g in self.walls:
                    w += 1
                    s = max(s, flatness(a, b))
                    break
        return 3 * s + min(w, 2)

    def around_tet(self, f, known):
        shape = self.shape
        for turn in shape.turns(f, lambda cell: known[cell]):
            yield ((g, shape.normal(f), shape.normal(g)) for g in turn)

    def around_polygon(self, f, known):
        shape = self.shape

        def way(f):
            return minus(shape.at(shape.succ(f)), shape.at(f))

        def turn(step):
            g = step(f)
            for i in range(MOST_FACETS):
                yield g, way(f), way(g)
                a = shape.twin[g]
                if a == NONE or shape.cell_of[a] == shape.cell_of[f] or not known[shape.cell_of[a]]:
                    return
                g = step(a)

        yield turn(shape.pred)
        yield turn(shape.succ)


class CompanionLinks:
    def __init__(self, shape, blocks):
        self.place = shape.place
        self.nodes = []  # of each companion
        self.first = [0]
        self.link_element = []
        self.twin_of = []
        self.walls = set()
        self.former = set()
        self.wall_points = set()
        waiting = {}
        for b in blocks:
            linked = (b.vtk_type, b.nodes_per_cell) in LINKED
            for cell in b.cells:
                for k in range(len(cell) if linked else 0):
                    f = len(self.twin_of)
                    self.link_element.append(len(self.nodes))
                    key = tuple(sorted(self.points_of(cell, k)))
                    t = waiting.pop(key, NONE)
                    self.twin_of.append(t)
                    if t == NONE:
                        waiting[key] = f
                    else:
                        self.twin_of[t] = f
                self.nodes.append(cell)
                self.first.append(len(self.twin_of))

    @staticmethod
    def points_of(cell, k):
        return (cell[k],) if len(cell) == 2 else (cell[k], cell[(k + 1) % len(cell)])

    def begin(self):
        self.former |= self.walls
        self.walls = set()
        self.wall_points = set()

    def links(self, e):
        return range(self.first[e], self.first[e + 1])

    def twin(self, f):
        return self.twin_of[f]

    def element(self, f):
        return self.link_element[f]

    def link_points(self, f):
        e = self.link_element[f]
        return self.points_of(self.nodes[e], f - self.first[e])

    def make_wall(self, f):
        self.walls.add(f)
        self.wall_points.update(self.link_points(f))

    def walls_about(self, f, known):
        touched = sum(p in self.wall_points for p in self.link_points(f))
        return 3 * flatness(self.direction(f, False), self.direction(self.twin_of[f], True)) + touched

    def direction(self, f, is_twin):
        e = self.link_element[f]
        nodes = self.nodes[e]
        k = f - self.first[e]
        n = len(nodes)
        place = [self.place[p] for p in nodes]
        if n == 2:
            d = minus(place[1 - k], place[k])
            return minus(place[k], place[1 - k]) if is_twin else d
        d = cross(minus(place[(k + 1) % n], place[k]), minus(place[(k + 2) % n], place[k]))
        if (nodes[k] < nodes[(k + 1) % n]) != is_twin:
            return d
        return (-d[0], -d[1], -d[2])
