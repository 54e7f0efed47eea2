// From a mesh to a file: complex, walk, and the sections one after the other.
#include <algorithm>
#include <cmath>
#include <string>

#include "container/head.h"
#include "container/sections.h"
#include "encode/payload.h"
#include "encode/positions.h"
#include "encode/walk_driver.h"
#include "entropy/pack.h"
#include "ravel/ravel.h"
#include "walk/read_strip.h"
#include "walk/surface_walk.h"
#include "walk/tet_walk.h"

namespace ravel {
namespace {

Status check_options(const EncodeOptions& options) {
    const auto bad = [](std::string why) { return Error{Code::bad_option, 0, std::move(why)}; };
    if (options.position_bits && options.max_error)
        return bad("give position bits or a largest error, not both");
    if (options.position_bits && (*options.position_bits < 1 || *options.position_bits > 30))
        return bad("position bits are 1 to 30");
    if (options.max_error && !(*options.max_error > 0 && *options.max_error < 1e300))
        return bad("the largest error is a number above 0");
    if (options.level < 1 || options.level > 22) return bad("the level is 1 to 22");
    if (options.strip_budget && !(*options.strip_budget >= 0))
        return bad("the strip budget is a percentage of at least 0");
    return Done{};
}

// Doubles to the nearest floats; a NaN stays one.
void round_to_float32(Array& positions) {
    if (positions.scalar != Scalar::f64) return;
    Array rounded = make_array(Scalar::f32, 3, positions.count());
    const auto from = positions.as<double>();
    const auto to = rounded.as<float>();
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<float>(from[i]);
    positions = std::move(rounded);
}

WalkLimits limits_of(const Complex& complex) {
    WalkLimits limits;
    limits.cells = complex.cell_count();
    limits.corners = static_cast<Id>(complex.twin.size());
    limits.vertices = static_cast<Id>(complex.point.size());
    limits.has_border =
        std::find(complex.twin.begin(), complex.twin.end(), kNone) != complex.twin.end();
    if (complex.kind == CellKind::polygon && limits.cells > 0) {
        limits.uniform_degree = complex.degree(0);
        for (Id c = 1; c < limits.cells && limits.uniform_degree != 0; ++c)
            if (complex.degree(c) != limits.uniform_degree) limits.uniform_degree = 0;
    }
    return limits;
}

// Points of the complex in the order of their first vertex on the walk, then the others.
Reorder reorder_of(const Mesh& mesh, const Complex& complex, const WalkRecord& record) {
    Reorder order;
    order.old_point.reserve(mesh.point_count());
    std::vector<bool> used(mesh.point_count(), false);
    for (std::size_t v = 0; v < record.vertex_of.size(); ++v)
        if (record.copy_of[v] == kNone) {
            const Id p = complex.point[record.vertex_of[v]];
            order.old_point.push_back(p);
            used[p] = true;
        }
    for (Index p = 0; p < mesh.point_count(); ++p)
        if (!used[p]) order.old_point.push_back(p);

    std::size_t corner = 0;  // of the walk
    for (const Id cell : record.cell_of) {
        const Id degree = complex.degree(cell), first = complex.first[cell];
        const bool flipped = complex.flipped[cell] != 0;
        std::uint32_t turn = 0;
        if (complex.kind == CellKind::tet) {
            std::array<std::uint8_t, 4> p{};
            for (std::size_t i = 0; i < 4; ++i) {
                auto local = static_cast<std::uint8_t>(record.facet_of[corner + i] - first);
                if (flipped && local >= 2) local = static_cast<std::uint8_t>(5 - local);
                p[i] = local;
            }
            if (flipped) std::swap(p[2], p[3]);
            turn = number_of_tet_turn(p);
        } else if (degree > 0) {
            const Id local = record.facet_of[corner] - first;
            turn = flipped && local > 0 ? degree - local : local;
        }
        corner += degree;
        order.old_cell.push_back(cell);
        order.turn.push_back(turn);
    }
    return order;
}

// The grid in which the walk looks for apexes: cubes of two mean edges, fewer where the box is
// large beside the mesh. Where there are more tets of negative volume than of positive, the walk
// looks for mirror images.
void choose_grid(const Complex& complex, const std::vector<Point3>& places, BlockHead& block) {
    Point3 high{};
    double length = 0;
    Index edges = 0, negative = 0, positive = 0;
    for (Id base = 0; base < complex.twin.size(); base += 4) {
        std::array<Point3, 4> p;
        for (Id i = 0; i < 4; ++i) {
            p[i] = places[complex.point[complex.vertex[base + i]]];
            for (std::size_t axis = 0; axis < 3; ++axis)
                high[axis] = std::max(high[axis], p[i][axis]);
        }
        const Point3 u = minus(p[1], p[0]);
        const double volume = dot(cross(u, minus(p[2], p[0])), minus(p[3], p[0]));
        positive += volume > 0;
        negative += volume < 0;
        length += std::sqrt(dot(u, u));
        ++edges;
    }
    block.mirrored = negative > positive;
    double side =
        edges == 0 ? 1 : std::max(1.0, std::floor(2 * length / static_cast<double>(edges)));
    for (;; side = std::floor(side * 1.25) + 1) {
        std::uint64_t cubes = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double count = std::floor(high[axis] / side) + 1;
            block.grid_count[axis] = static_cast<std::uint32_t>(std::min(count, 1048576.0));
            cubes *= block.grid_count[axis];
        }
        if (cubes <= most_cubes(block.vertices)) break;
    }
    block.grid_side = static_cast<Index>(side);
}

// What the strip may add when it is read as the walk runs, in percent of the cells, unless asked
// otherwise: what the paper's strips add.
double budget_of(const Complex& complex, const EncodeOptions& options) {
    return options.strip_budget.value_or(complex.kind == CellKind::tet ? 12 : 2.5);
}

struct Course {
    WalkRecord record;
    Walked walked;
};

template <class Walk, class Driver>
Course walk_by(const Complex& complex, const WalkPlan& plan, const WalkLimits& limits,
               const BlockHead& block) {
    Driver driver(complex, plan, block.has_copies, block.has_flips);
    Walk walk(driver, limits);
    walk.run();
    return {driver.take(), walk.take()};
}

Head head_of(const Mesh& mesh, const PositionPlan& plan, const EncodeOptions& options) {
    Head head;
    head.kind = mesh.kind;
    head.position_scalar = mesh.positions.scalar;
    head.lossless = !plan.format.grid();
    head.keeps_order = options.keep_order;
    head.position_bits = plan.bits;
    head.step = plan.grid.step;
    std::copy(plan.grid.origin.begin(), plan.grid.origin.end(), head.origin);
    head.bound = plan.bound;
    head.error = plan.error;
    for (const Attribute& a : mesh.attributes)
        head.attributes.push_back({a.name, a.place, a.values.scalar, a.values.arity,
                                   is_pool(mesh, a), a.values.count(), a.references});
    return head;
}

}  // namespace

Result<Encoded> encode(const Mesh& given, const EncodeOptions& options) {
    if (Status status = check_options(options); !status) return status.error();
    if (Status status = check_mesh(given); !status) return status.error();
    Mesh rounded;
    if (options.float32 && given.positions.scalar == Scalar::f64) {
        rounded = given;
        round_to_float32(rounded.positions);
    }
    const Mesh& mesh = rounded.positions.bytes.empty() ? given : rounded;

    Result<PositionPlan> plan = plan_positions(mesh, options);
    if (!plan) return plan.error();
    Result<Complex> built = build_complex(mesh);
    if (!built) return built.error();
    const Complex& complex = *built;
    WalkLimits limits = limits_of(complex);
    BlockHead block;
    block.cells = limits.cells;
    block.corners = limits.corners;
    block.vertices = limits.vertices;
    block.uniform_degree = limits.uniform_degree;
    block.has_border = limits.has_border;
    block.has_flips =
        std::find(complex.flipped.begin(), complex.flipped.end(), 1) != complex.flipped.end();
    std::vector<bool> used(mesh.point_count(), false);
    for (const Id p : complex.point) {
        block.points += !used[p];
        used[p] = true;
    }
    block.has_copies = block.points != block.vertices;
    block.unused_points = mesh.point_count() - block.points;
    block.companions = mesh.companions.size();
    WalkPlan walk_plan{choose_seeds(complex), plan_places(mesh, *plan),
                       place_of(plan->format, Point3{}), plan->outlier};
    if (mesh.kind == CellKind::tet) {
        choose_grid(complex, walk_plan.places, block);
        limits.grid_side = static_cast<double>(block.grid_side);
        limits.grid_count = block.grid_count;
        limits.mirrored = plan->format.mirrored = block.mirrored;
    }
    const Course course =
        mesh.kind == CellKind::tet
            ? walk_by<TetWalk<TetEncodeDriver>, TetEncodeDriver>(complex, walk_plan, limits, block)
            : walk_by<SurfaceWalk<SurfaceEncodeDriver>, SurfaceEncodeDriver>(complex, walk_plan,
                                                                             limits, block);
    const WalkRecord& record = course.record;
    const StripReading strip = read_strip(course.walked);
    block.components = walk_plan.seeds.size();
    block.links = strip.links;
    block.wants_mending = 100 * static_cast<double>(strip.added_cells) >
                          budget_of(complex, options) * static_cast<double>(block.cells);

    const Reorder order = reorder_of(mesh, complex, record);
    Encoded encoded;
    encoded.strip = {block.components, strip.links, strip.open_strips, strip.added_cells};
    encoded.position_bound = plan->bound;
    encoded.position_error = plan->error;
    if (options.keep_order) {
        encoded.order.point.resize(order.old_point.size());
        encoded.order.cell.resize(order.old_cell.size());
        for (Index i = 0; i < order.old_point.size(); ++i) encoded.order.point[i] = i;
        for (Index i = 0; i < order.old_cell.size(); ++i) encoded.order.cell[i] = i;
        encoded.order.turn.assign(order.old_cell.size(), 0);
    } else {
        encoded.order.point = inverse_of(order.old_point, mesh.point_count());
        encoded.order.cell = inverse_of(order.old_cell, mesh.cell_count());
        encoded.order.turn.resize(order.turn.size());
        for (Index i = 0; i < order.turn.size(); ++i)
            encoded.order.turn[order.old_cell[i]] = order.turn[i];
    }

    ByteWriter out;
    out.raw(kMagic);
    out.u8(kVersion);
    const auto section = [&](SectionId id, const Bytes& raw) {
        write_section(out, id, raw, pack(raw, options.level));
    };
    section(SectionId::head, write_head(head_of(mesh, *plan, options)));
    section(SectionId::block, write_block_head(block, mesh.kind));
    section(SectionId::connectivity, record.codes.finish());
    const std::vector<Index> unused(
        order.old_point.begin() + static_cast<std::ptrdiff_t>(block.points), order.old_point.end());
    section(SectionId::positions, write_positions(*plan, complex, record, unused));
    const std::vector<Index> new_point = inverse_of(order.old_point, mesh.point_count());
    const std::vector<Index> new_cell = inverse_of(order.old_cell, mesh.cell_count());
    if (!mesh.companions.empty())
        section(SectionId::companions, write_companions(mesh, order, new_point, new_cell));
    if (!mesh.attributes.empty())
        section(SectionId::attributes, write_attributes(mesh, order, new_point, new_cell));
    if (!mesh.tag_names.empty() || !mesh.notes.empty())
        section(SectionId::names, write_names(mesh));
    if (options.keep_order) section(SectionId::order, write_order(order));
    out.u8(static_cast<std::uint8_t>(SectionId::end));
    encoded.bytes = out.take();
    return encoded;
}

}  // namespace ravel
