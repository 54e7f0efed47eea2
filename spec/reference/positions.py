"""Chapter 8: the position of each vertex."""

import math

import guesses
from along import Along
from conventions import NONE, clamp, divide, i64, scale, to_24_digits, width
from echoes import Echoes
from errors import require
from followers import Followers
from guesses import NUMBER
from levels import Levels
from positions_head import BINARY, DECIMAL, GRID
from rice import RiceMeans
from signs import Signs, sign_of
from sizes import MOST32, FollowerSizes, Sizes, scale_of
from ties import neighbours_of


class Positions:
    """All vertices so far: values, coordinates, magnitudes."""

    def __init__(self, head, block, p, stream):
        self.head = p
        self.block = block
        self.wide = head.wide
        self.base = p.base
        self.places = p.places
        self.digits = p.digits
        self.place_origin = getattr(p, "place_origin", None)
        self.place_scale = getattr(p, "place_scale", None)
        # 8.2: coordinates that do not follow from values; elsewhere `coordinate` has None
        self.keeps_coordinates = p.base == DECIMAL and p.digits > 0
        self.M = 2**40 if p.base == GRID else 2**53
        self.stream = stream
        self.contexts = self.stream.blocks
        self.value = []
        self.coordinate = []
        self.escaped_bits = {}  # by vertex and axis
        self.sizes = Sizes(stream, guesses.KINDS, self.start(head))
        if p.has_rice:
            self.sizes.rice = RiceMeans(stream)
        self.signs = Signs(stream)
        self.echoes = Echoes(block, p, self) if p.echoes else None
        self.followers = Followers(block, self) if p.has_follows else None
        self.follower_sizes = FollowerSizes(stream)
        self.along = Along(self, p.round_faces) if p.has_along else None
        self.levels = Levels(block, p, self) if p.has_levels else None
        # of what follows or is echoed and of which an axis is not the same
        self.differs = p.digits == 0 and not p.has_escapes and not p.has_minus_zero
        # by whether it follows
        self.all_same_history = [0, 0]
        self.same_history = [0, 0]
        self.usual_rest = [0, 0, 0]
        self.rounds = self.base == BINARY and not self.wide
        self.last_minus_zero = [False] * 3
        self.last_whole_zero = [False] * 3
        self.last_escape = [False] * 3
        self.last_escaped_bits = [0] * 3

    def start(self, head):
        """8.6: what expected sizes start from."""
        if not head.tets:
            return 16
        x = divide(float(self.block.grid_side), self.place_scale if head.lossless else 1.0) / 4
        return math.floor(min(x, 2.0**40)) if x > 1 else 1

    def flag(self, name, *coordinates):
        return self.stream.flag(self.contexts[name], *coordinates)

    # 8.2

    def digits_of_rest(self, m):
        if self.base == DECIMAL:
            d = len(str(m)) if m else 0
        else:
            d = width(m)
        return max(0, self.digits - d)

    def value_and_coordinate(self, whole, rest, zeros, negative):
        m = abs(whole)
        e = self.digits_of_rest(m)
        coordinate = None
        if self.base == GRID:
            return float(whole), coordinate
        if self.base == DECIMAL:
            a, b = (m * 10**e + rest, e + zeros) if rest else (m, 0)
            value = float(a) / float(10**b)
            if self.keeps_coordinates:
                coordinate = float(a) / float(10 ** (b + self.places))
        else:
            value = float(m)
            if rest:
                value = value + scale(float(rest), -(e + zeros))
        if whole < 0 or (whole == 0 and negative):
            value = -value
            if self.keeps_coordinates:
                coordinate = -coordinate
        return value, coordinate

    def coordinate_of(self, v, axis):
        """The coordinate of a vertex that is not escaped on this axis, where it is `lossless`."""
        if self.keeps_coordinates:
            return self.coordinate[v][axis]
        value = self.value[v][axis]
        if self.base == DECIMAL:
            return value / float(10**self.places)
        return scale(value, -self.places)

    # 8.3

    def guess(self, configuration, stencil, variant=0):
        if configuration == "edge":
            a, b = self.value[stencil[0]], self.value[stencil[1]]
            g = tuple((x + y) * 0.5 for x, y in zip(a, b))
        else:
            c = guesses.set_of(configuration, variant)
            g = guesses.guess(
                configuration, stencil, self.value, None if c is None else self.head.weights[c],
                self.block.mirrored, self.block.leaders_move)
        g = tuple(clamp(x, -float(self.M), float(self.M)) for x in g)
        return tuple(to_24_digits(x) for x in g) if configuration == "edge" and self.rounds else g

    def whole_of(self, x):
        return math.trunc(x) if self.digits > 0 else math.floor(x + 0.5)

    # 8.4

    def read(self, configuration, stencil, borders=(), variant=0):
        stencil = stencil + [NONE] * (guesses.PLACES - len(stencil))
        v = len(self.value)
        beside = neighbours_of(configuration, stencil)
        sizes = self.sizes
        on_edge = configuration == "edge"
        near = stencil[2:5] if on_edge else stencil[:3]
        near = [p for p in near if p != NONE]
        sizes.begin(near, NUMBER[configuration], variant)
        self.signs.begin(sizes.told_by)
        # 1
        guess = self.guess(configuration, stencil, variant)
        w = [self.whole_of(x) for x in guess]
        # 2
        follows = repeats = False
        if self.followers and not on_edge:
            self.followers.advance(v, configuration, stencil)
            leader = self.followers.leader(v, configuration, stencil)
            if leader != NONE:
                repeats, whole_said, value_said, coordinate_said = self.followers.says(
                    v, leader, configuration, stencil, variant, guess)
                self.follower_sizes.begin(NUMBER[configuration], variant)
                follows = self.followers.read(repeats, self.follower_sizes.far())
        # 3
        echo = None
        if self.echoes and not follows and not on_edge:
            echo = self.echoes.read(v, guess, beside)
            if echo:
                said = [self.echoes.says(*echo, k, self.M) for k in range(3)]
                whole_said, value_said, coordinate_said = zip(*said)
        # 4
        border = None
        if self.along and not follows and not echo:
            border = self.along.read(stencil, borders)
        if border:
            configuration = "border"
            stencil = border.stencil
            guess = border.begin(self.guess(configuration, stencil), float(self.M))
            w = [self.whole_of(x) for x in guess]
            # 5
            sizes.begin(stencil[:3], NUMBER[configuration], order=border.order)
            self.signs.begin(sizes.told_by)
        # 6
        all_same = None  # if the flag is not read
        if echo or follows and (repeats or self.digits == 0):
            all_same = self.read_all_same(follows, repeats)
        same = [False] * 3
        value = [None] * 3
        coordinate = [None] * 3
        signs = [0] * 3
        for k in sizes.order:
            off_plane = None
            if border and k == border.last:
                w[k] = self.whole_of(clamp(border.x(guess, value), -float(self.M), float(self.M)))
                off_plane = self.along.expected(border)
            # 6.1
            level = None
            if all_same is not None:
                same[k] = all_same or self.read_same(k, follows, same)
            elif not follows and self.levels and not on_edge:
                before = value[k - 1] if k > 0 else None
                level = self.levels.read(configuration, stencil, k, w[k], before)
                same[k] = level is not None
            # 6.2
            if same[k]:
                if level is not None:
                    value[k] = self.value[level][k]
                    coordinate[k] = self.coordinate[level][k]
                else:
                    value[k] = value_said[k]
                    coordinate[k] = coordinate_said[k]
                    require(abs(value[k]) < self.M, "the value of an echo or of a leader")
            # 6.3
            else:
                if echo:
                    miss = sizes.residual_under(k, 96 + k, self.differs)
                elif follows:
                    miss = self.follower_sizes.residual(k, self.differs)
                else:
                    miss = self.residual(k, guess[k], w[k], off_plane)
                whole = i64(miss + (whole_said[k] if echo or follows else w[k]))
                require(-self.M < whole < self.M, "whole")
                told = guess[k] if on_edge and miss == 0 else None
                behind = self.behind_the_point(v, k, whole, told)
                value[k], coordinate[k] = self.value_and_coordinate(whole, *behind)
            # 6.4
            if same[k] or echo or follows:
                miss = sizes.note(k, math.trunc(value[k] - float(w[k])))
            signs[k] = sign_of(miss)
        if border:
            k = border.last
            self.along.keep(v, sizes.r[k])
            sizes.r[k] = min(math.trunc(abs(value[k] - guess[k]) + 0.5), MOST32)
        # 7
        sizes.keep(v)
        if follows:
            self.follower_sizes.keep()
        self.signs.keep(signs)
        stays = all(same) and bool(repeats if follows else echo and self.echoes.stays(echo[1]))
        if self.echoes and not on_edge:
            self.echoes.pair(v, echo, beside)
        self.add(tuple(value), tuple(coordinate), stays)
        if self.followers:
            if on_edge:
                self.followers.skip()
            else:
                self.followers.enter(v, configuration, guess)

    def residual(self, k, guess, w, off_plane):
        """6.3, where the vertex neither follows nor is echoed; `off_plane`: the e of the last axis along a border."""
        part = 0.0 if self.digits > 0 or off_plane is not None else guess - float(w)
        return self.sizes.residual(k, off_plane, lambda s: self.signs.read(k, part, s))

    def read_all_same(self, follows, repeats):
        """6: whether all axes are the same."""
        h = self.all_same_history[follows]
        answer = self.flag("all_same", follows, h, *((repeats, self.follower_sizes.far()) if follows else (1, 0)))
        self.all_same_history[follows] = (h * 2 + answer) % 8
        return answer

    def read_same(self, k, follows, same):
        """6.1, where not all are: whether axis k is the same; `same`: which of those before it are."""
        if k == 2 and same[0] and same[1]:
            return False
        h = self.same_history[follows]
        if follows:
            answer = self.flag("follow_same", self.follower_sizes.far(), k, h)
        else:
            answer = self.flag("same", k, h)
        self.same_history[follows] = (h * 2 + answer) % 4
        return answer

    def add(self, value, coordinate, stays):
        """`stays`: it is where an earlier vertex is, as copies are, too."""
        self.value.append(value)
        self.coordinate.append(coordinate)
        v = len(self.value) - 1
        if self.echoes and not stays:
            self.echoes.enter(v)
        if self.levels:
            self.levels.enter(v, stays)

    # 8.5.4

    def behind_the_point(self, v, axis, whole, told):
        """rest, zeros, negative; `told`: the guess, where it tells of the rest"""
        if self.head.has_escapes and self.read_escape(v, axis):
            return 0, 0, False
        has_minus_zero = self.head.has_minus_zero
        if self.digits == 0:
            negative = False
            if whole == 0 and has_minus_zero:
                negative = self.flag("minus_zero", axis, self.last_minus_zero[axis])
                self.last_minus_zero[axis] = negative
            return 0, 0, negative
        e = self.digits_of_rest(abs(whole))
        zeros = 0
        negative = False
        if whole == 0:
            is_zero = self.flag("whole_zero", axis, self.last_whole_zero[axis])
            self.last_whole_zero[axis] = is_zero
            if is_zero:
                if has_minus_zero:
                    negative = self.flag("minus_zero", axis, 0)
                return 0, 0, negative
            negative = self.stream.plain(1) == 1
            while zeros < 63 and self.flag("leading", zeros):
                zeros += 1
        elif e == 0:
            return 0, 0, False
        elif told is not None:
            return self.rest_by(told, axis, whole, e), 0, False
        elif self.flag("rest_zero", e):
            return 0, 0, False
        if self.base == DECIMAL:
            require(self.places + zeros + e <= 22, "more than 22 decimal places")
        return self.read_rest(e), zeros, negative

    def read_escape(self, v, axis):
        """Whether the coordinate is escaped; if so its bits are kept."""
        escaped = self.flag("escape", axis, self.last_escape[axis])
        self.last_escape[axis] = escaped
        if escaped:
            if not self.flag("escape_same", axis):
                self.last_escaped_bits[axis] = self.stream.plain(64 if self.wide else 32)
            self.escaped_bits[v, axis] = self.last_escaped_bits[axis]
        return escaped

    def read_rest(self, e):
        if self.base == DECIMAL:
            rest = self.stream.plain(width(10**e - 1))
            require(rest < 10**e, "rest of 10^e or more")
        else:
            rest = self.stream.plain(e)
        require(rest != 0, "rest 0 where it can't be")
        return rest

    def rest_by(self, told, axis, whole, e):
        one = 10**e if self.base == DECIMAL else 2**e
        near = int((abs(told) - float(abs(whole))) * float(one) + 2.0**52 - 2.0**52)
        usual = self.usual_rest[axis]
        residual = self.stream.residual(*scale_of(usual))
        size = min(abs(residual), 2**53)
        self.usual_rest[axis] = usual + ((16 * size + 31) >> 5) - ((usual + 31) >> 5)
        rest = (near + residual) % 2**64
        require(rest < one, "rest of a point of an edge")
        require(self.base != DECIMAL or rest == 0 or self.places + e <= 22, "more than 22 decimal places")
        return rest

    # 8.7

    def copy(self, original):
        self.sizes.keep(len(self.value), [0, 0, 0])
        self.signs.keep([0, 0, 0])
        self.add(self.value[original], self.coordinate[original], True)
        if self.followers:
            self.followers.skip()

    # 8.8

    def read_unused_points(self, edges):
        require(len(edges.ends) <= self.block.unused_points, "more edges than points")
        for i in range(self.block.unused_points):
            v = self.block.vertices + i
            if i < len(edges.ends):
                self.read("edge", [*edges.ends[i], *range(v - 1, v - 1 - min(i, 3), -1)])
            else:
                self.read("seed", [v - 1] if v > 0 else [], variant=2)
