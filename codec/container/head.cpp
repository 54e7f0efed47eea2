#include "container/head.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/float32.h"

namespace ravel {
namespace {

// Doubles of a grid are stored as float32 where that is all they are.
bool fits_float32(double x) {
    return to_float32(x) == x;
}

void put(ByteWriter& out, double x, bool narrow) {
    if (narrow)
        out.u32(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    else
        out.f64(x);
}
double get(ByteReader& in, bool narrow) {
    return narrow ? static_cast<double>(std::bit_cast<float>(in.u32())) : in.f64();
}

// An error is kept as a number of steps that are the finer the less it is.
constexpr unsigned kWholeBound = 255;
double error_of(unsigned steps, double bound) {
    const double share = steps / double{kWholeBound};
    return bound * (share * share * share);
}
std::uint8_t steps_above(double error, double bound) {
    unsigned least = 0;
    while (least < kWholeBound && error_of(least, bound) < error) ++least;
    return static_cast<std::uint8_t>(least);
}

constexpr double kMostSteps = 0x1p53;
double steps_of(double x, double step) {
    return std::floor(x / step + 0.5);
}

// How the floats of a grid are told.
struct GridForm {
    bool narrow = false;        // as float32
    bool whole_origin = false;  // the origin in steps
    bool coarse = false;        // or in so many at a time (see origin_unit)
    bool half_step = false;     // no bound, as it is half a step
};
constexpr unsigned kCoarse = 128;  // beside position_bits

GridForm form_of(const Head& head) {
    if (head.lossless) return {};
    const auto all_in = [&](double unit) {
        return std::all_of(std::begin(head.origin), std::end(head.origin),
                           [&](double x) { return is_whole_steps(x, unit); });
    };
    GridForm form;
    form.whole_origin = all_in(head.step);
    const double unit = origin_unit(head.position_bits);
    const bool zero = std::all_of(std::begin(head.origin), std::end(head.origin),
                                  [](double x) { return x == 0; });
    form.coarse = form.whole_origin && !zero && unit > 1 && all_in(head.step * unit);
    form.half_step = head.bound == head.step / 2;
    form.narrow = fits_float32(head.step) && (form.half_step || fits_float32(head.bound)) &&
                  (form.whole_origin ||
                   std::all_of(std::begin(head.origin), std::end(head.origin), fits_float32));
    return form;
}

void write_grid(ByteWriter& out, const Head& head, const GridForm& form) {
    out.u8(static_cast<std::uint8_t>(head.position_bits | (form.coarse ? kCoarse : 0)));
    put(out, head.step, form.narrow);
    const double unit = form.coarse ? head.step * origin_unit(head.position_bits) : head.step;
    for (const double x : head.origin)
        if (form.whole_origin)
            out.varint(zigzag(static_cast<std::int64_t>(steps_of(x, unit))));
        else
            put(out, x, form.narrow);
    if (!form.half_step) put(out, head.bound, form.narrow);
    out.u8(steps_above(head.error, head.bound));
}
bool read_grid(ByteReader& in, Head& head, GridForm form) {
    const unsigned bits = in.u8();
    form.coarse = (bits & kCoarse) != 0;
    head.position_bits = static_cast<std::uint8_t>(bits % kCoarse);
    head.step = get(in, form.narrow);
    bool sane = std::isfinite(head.step) && head.step > 0 && head.position_bits <= 64 &&
                (form.whole_origin || !form.coarse);
    for (double& x : head.origin) {
        if (form.whole_origin) {
            const double steps = static_cast<double>(unzigzag(in.varint())) *
                                 (form.coarse ? origin_unit(head.position_bits) : 1);
            sane = sane && std::abs(steps) < kMostSteps;
            x = steps * head.step;
        } else {
            x = get(in, form.narrow);
        }
        sane = sane && std::isfinite(x);
    }
    head.bound = form.half_step ? head.step / 2 : get(in, form.narrow);
    head.error = error_of(in.u8(), head.bound);
    return sane && std::isfinite(head.bound) && head.bound >= 0;
}

}  // namespace

double origin_unit(int position_bits) {
    return std::ldexp(1.0, std::max(position_bits - 6, 0));
}

bool is_whole_steps(double x, double step) {
    const double steps = steps_of(x, step);
    return std::abs(steps) < kMostSteps && steps * step == x;
}

double kept_error(double error, double bound) {
    return error_of(steps_above(error, bound), bound);
}

const char* name_of(SectionId id) {
    switch (id) {
        case SectionId::head:
            return "head";
        case SectionId::block:
            return "block";
        case SectionId::connectivity:
            return "connectivity";
        case SectionId::positions:
            return "positions";
        case SectionId::companions:
            return "companions";
        case SectionId::attributes:
            return "attributes";
        case SectionId::names:
            return "names";
        case SectionId::order:
            return "order";
        case SectionId::count:
            break;
    }
    return "unknown";
}

Bytes write_head(const Head& head) {
    ByteWriter out;
    const GridForm form = form_of(head);
    out.u8(static_cast<std::uint8_t>(
        (head.kind == CellKind::tet ? 1 : 0) | (head.position_scalar == Scalar::f64 ? 2 : 0) |
        (head.lossless ? 4 : 0) | (head.keeps_order ? 8 : 0) | (form.narrow ? 16 : 0) |
        (form.whole_origin ? 32 : 0) | (form.half_step ? 64 : 0) |
        (head.attributes.empty() ? 0 : 128)));
    if (!head.lossless) write_grid(out, head, form);
    if (!head.attributes.empty()) out.varint(head.attributes.size());
    for (const AttributeHead& a : head.attributes) {
        out.text(a.name);
        out.u8(static_cast<std::uint8_t>(static_cast<unsigned>(a.place) | (a.indexed ? 8u : 0u) |
                                         static_cast<unsigned>(a.scalar) << 4));
        out.varint(std::uint64_t{a.arity} << 2 | (a.bound > 0 ? 2 : 0) |
                   (a.references.empty() ? 0 : 1));
        out.varint(a.tuples);
        if (a.bound > 0) {
            out.f64(a.bound);
            out.f64(a.error);
        }
        if (!a.references.empty()) out.varint(a.references.size());
        for (const Reference& r : a.references) {
            out.varint(std::uint64_t{r.component} << 1 | (r.place == Place::cell ? 1 : 0));
            out.varint(zigzag(r.base));
        }
    }
    return out.take();
}

Result<Head> read_head(ByteReader& in) {
    const auto start = in.at();
    const auto bad = [&](const char* why) { return Error{Code::corrupt, start, why}; };
    Head head;
    const unsigned flags = in.u8();
    if ((flags & 4) != 0 && (flags & 0x70) != 0)
        return bad("the flags of the head contradict each other");
    head.kind = flags & 1 ? CellKind::tet : CellKind::polygon;
    head.position_scalar = flags & 2 ? Scalar::f64 : Scalar::f32;
    head.lossless = (flags & 4) != 0;
    head.keeps_order = (flags & 8) != 0;
    if (!head.lossless &&
        !read_grid(in, head, {(flags & 16) != 0, (flags & 32) != 0, false, (flags & 64) != 0}) &&
        in.ok())
        return bad("the grid of the positions makes no sense");
    const std::uint64_t count = (flags & 128) != 0 ? in.varint() : 0;
    if (count > in.left() / 4) return bad("more attributes than the head has room for");
    head.attributes.reserve(count);
    for (std::uint64_t i = 0; i < count && in.ok(); ++i) {
        AttributeHead a;
        a.name = in.text();
        const unsigned kind = in.u8();
        const std::uint64_t width = in.varint(), arity = width >> 2;
        a.tuples = in.varint();
        if ((width & 2) != 0) {
            a.bound = in.f64();
            a.error = in.f64();
            const bool sane = std::isfinite(a.bound) && a.bound > 0 && a.error >= 0 &&
                              a.error <= a.bound && kind >> 4 >= static_cast<unsigned>(Scalar::f32);
            if (in.ok() && !sane) return bad("the bound of an attribute makes no sense");
        }
        const std::uint64_t references = width & 1 ? in.varint() : 0;
        if (references > in.left() / 2) return bad("more references than the head has room for");
        a.references.reserve(references);
        for (std::uint64_t r = 0; r < references; ++r) {
            const std::uint64_t component = in.varint();
            const std::int64_t base = unzigzag(in.varint());
            if (component >> 1 >= arity ||
                (!a.references.empty() && component >> 1 <= a.references.back().component))
                return bad("an attribute refers by a component it has not, or twice by one");
            a.references.push_back({static_cast<std::uint32_t>(component >> 1),
                                    component & 1 ? Place::cell : Place::point, base});
        }
        if ((kind & 7) > static_cast<unsigned>(Place::mesh) ||
            kind >> 4 > static_cast<unsigned>(Scalar::f64) || arity == 0 || arity > kMostArity)
            return bad("an attribute of a kind this version does not know");
        a.place = static_cast<Place>(kind & 7);
        a.indexed = (kind & 8) != 0;
        a.scalar = static_cast<Scalar>(kind >> 4);
        a.arity = static_cast<std::uint32_t>(arity);
        head.attributes.push_back(std::move(a));
    }
    if (!in.ok() || in.left() != 0) return bad("the head ends too early or too late");
    return head;
}

namespace {

// Counts that are told only where they are not as usual.
constexpr std::array<Index BlockHead::*, 5> kSeldomTold{
    &BlockHead::unused_points, &BlockHead::companions, &BlockHead::components, &BlockHead::links,
    &BlockHead::shape_step};
constexpr unsigned kToldShape = 16;  // of tets only
constexpr std::uint64_t kMostSide = std::uint64_t{1} << 52;
BlockHead usual_counts(Index cells) {
    BlockHead usual;
    usual.components = cells > 0 ? 1 : 0;
    return usual;
}

}  // namespace

Bytes write_block_head(const BlockHead& b, CellKind kind) {
    ByteWriter out;
    out.u8(static_cast<std::uint8_t>(
        (b.has_border ? 1 : 0) | (b.has_flips ? 2 : 0) | (b.has_copies ? 4 : 0) |
        (b.mirrored ? 8 : 0) | (b.wants_mending ? 16 : 0) | (b.has_edge_points ? 32 : 0) |
        (b.leaders_move ? 64 : 0) | (b.has_precedents || b.by_folds ? 128 : 0)));
    out.varint(b.cells);
    if (kind == CellKind::polygon) {
        out.varint(b.uniform_degree);
        if (b.uniform_degree == 0) out.varint(b.corners);
    }
    out.varint(b.vertices);
    if (b.has_copies) out.varint(b.points);
    const BlockHead usual = usual_counts(b.cells);
    unsigned told = 0;
    for (std::size_t i = 0; i < kSeldomTold.size(); ++i)
        told |= unsigned{b.*kSeldomTold[i] != usual.*kSeldomTold[i]} << i;
    out.u8(static_cast<std::uint8_t>(told));
    for (std::size_t i = 0; i < kSeldomTold.size(); ++i)
        if ((told >> i & 1) != 0) out.varint(b.*kSeldomTold[i]);
    if (kind == CellKind::tet) {
        out.varint(b.grid_side);
        if (!b.by_folds)
            for (const std::uint32_t n : b.grid_count) out.varint(n);
    }
    return out.take();
}

Result<BlockHead> read_block_head(ByteReader& in, CellKind kind) {
    const auto start = in.at();
    const auto bad = [&](const char* why) { return Error{Code::corrupt, start, why}; };
    BlockHead b;
    const unsigned flags = in.u8();
    b.has_border = (flags & 1) != 0;
    b.has_flips = (flags & 2) != 0;
    b.has_copies = (flags & 4) != 0;
    b.mirrored = (flags & 8) != 0;
    b.wants_mending = (flags & 16) != 0;
    b.has_edge_points = (flags & 32) != 0;
    b.leaders_move = (flags & 64) != 0;
    b.has_precedents = (flags & 128) != 0 && kind == CellKind::polygon;
    b.by_folds = (flags & 128) != 0 && kind == CellKind::tet;
    b.cells = in.varint();
    constexpr Index kMost = 0xFFFFFFFEu;
    if (((b.mirrored || b.has_edge_points || b.leaders_move) && kind != CellKind::tet) ||
        b.cells >= (kind == CellKind::tet ? kMostTets : kMost))
        return bad("a block with more cells than a block may have, or flags of other cells");
    if (kind == CellKind::polygon) {
        b.uniform_degree = in.varint();
        if (b.uniform_degree >= kMost) return bad("cells with more corners than a block may have");
        b.corners = b.uniform_degree == 0 ? in.varint() : b.cells * b.uniform_degree;
    } else {
        b.corners = 4 * b.cells;
    }
    b.vertices = in.varint();
    b.points = b.has_copies ? in.varint() : b.vertices;
    const BlockHead usual = usual_counts(b.cells);
    const unsigned told = in.u8();
    if (told >> kSeldomTold.size() != 0 || ((told & kToldShape) != 0 && kind != CellKind::tet))
        return bad("counts that are not known to this version");
    for (std::size_t i = 0; i < kSeldomTold.size(); ++i)
        b.*kSeldomTold[i] = (told >> i & 1) != 0 ? in.varint() : usual.*kSeldomTold[i];
    if (!in.ok()) return bad("the block's head ends too early");
    if (b.corners >= kMost || b.vertices > b.corners || b.points > b.vertices ||
        b.unused_points >= kMost || b.vertices + b.unused_points >= kMost ||
        b.components > b.cells || b.links > b.corners || b.shape_step > kMostSide)
        return bad("the counts of a block contradict each other");
    if (kind == CellKind::tet) {
        b.grid_side = in.varint();
        // So few that the grid is no larger than what else is kept of the vertices.
        std::uint64_t left = most_grid_blocks(b.vertices);
        for (std::uint32_t& n : b.grid_count) {
            if (b.by_folds) break;
            const std::uint64_t count = in.varint();
            if (count == 0 || count > 0xFFFFFFFFu || grid_blocks_of(count) > left)
                return bad("a grid of too many cubes");
            n = static_cast<std::uint32_t>(count);
            left /= grid_blocks_of(count);
        }
        if (b.grid_side == 0 || b.grid_side > kMostSide) return bad("a grid of impossible cubes");
    }
    if (!in.ok() || in.left() != 0) return bad("the block's head ends too early or too late");
    return b;
}

}  // namespace ravel
