// From a mesh to a file: complex, walk, and the sections one after the other.
#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

#include "container/head.h"
#include "container/sections.h"
#include "encode/attributes.h"
#include "encode/companions.h"
#include "encode/connectivity.h"
#include "encode/course.h"
#include "encode/edge_points.h"
#include "encode/order.h"
#include "encode/order_section.h"
#include "encode/payload.h"
#include "encode/positions.h"
#include "encode/strip_mesh.h"
#include "encode/threads.h"
#include "entropy/pack.h"
#include "ravel/ravel.h"
#include "walk/read_strip.h"

namespace ravel {
namespace {

Status check_options(const EncodeOptions& options) {
    const auto bad = [](std::string why) { return Error{Code::bad_option, 0, std::move(why)}; };
    const int grids = options.position_bits.has_value() + options.max_error.has_value() +
                      options.max_error_relative.has_value() + options.lattice.has_value();
    if (grids > 1) return bad("give position bits, a largest error or a lattice, only one of them");
    if (options.position_bits && (*options.position_bits < 1 || *options.position_bits > 30))
        return bad("position bits are 1 to 30");
    if (options.max_error && !(*options.max_error > 0 && *options.max_error < 1e300))
        return bad("the largest error is a number above 0");
    if (options.max_error_relative &&
        !(*options.max_error_relative > 0 && *options.max_error_relative <= 1))
        return bad("the largest relative error is a number above 0 and at most 1");
    int exponent = 0;
    if (options.lattice && !(*options.lattice > 0 && *options.lattice < 1e300 &&
                             std::frexp(*options.lattice, &exponent) == 0.5))
        return bad("the step of a lattice is a power of two, such as 0.0009765625 (1/1024)");
    if (options.threads < 0) return bad("the threads are as many as may be used, or 0 for all");
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

// What the strip may add when it is read as the walk runs, in percent of the cells, unless asked
// otherwise: what the paper's strips add.
double budget_of(const Complex& complex, const EncodeOptions& options) {
    return options.strip_budget.value_or(complex.kind == CellKind::tet ? 12 : 2.5);
}

Head head_of(const Mesh& mesh, const PositionPlan& plan, const std::vector<AttributeGrid>& grids,
             const EncodeOptions& options) {
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
    for (std::size_t i = 0; i < grids.size(); ++i) {
        const Attribute& a = mesh.attributes[i];
        head.attributes.push_back({a.name, a.place, a.values.scalar, a.values.arity,
                                   is_pool(mesh, a), a.values.count(), a.references, grids[i].bound,
                                   grids[i].error});
    }
    return head;
}

int threads_of(const EncodeOptions& options) {
    return options.threads > 0 ? options.threads
                               : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

struct SectionBytes {
    Bytes raw, packed;
};
SectionBytes packed(Bytes raw, int level) {
    Bytes bytes = pack(raw, level);
    return {std::move(raw), std::move(bytes)};
}

}  // namespace

Result<Encoded> encode(const Mesh& given, const EncodeOptions& options) {
    if (Status status = check_options(options); !status) return status.error();
    if (Status status = check_mesh(given); !status) return status.error();
    if (Status status = check_attribute_options(given, options); !status) return status.error();
    Mesh rounded;
    if (options.float32 && given.positions.scalar == Scalar::f64) {
        rounded = given;
        round_to_float32(rounded.positions);
    }
    const Mesh& mesh = rounded.positions.bytes.empty() ? given : rounded;

    const int threads = threads_of(options);
    auto building = start(threads > 1, [&] { return build_complex(mesh); });
    Result<PositionPlan> plan = plan_positions(mesh, options);
    if (!plan) return plan.error();
    Result<Complex> built = building.get();
    if (!built) return built.error();
    const Complex& complex = *built;
    CoursePlan course_plan = plan_course(mesh, complex, *plan, options.fast);
    BlockHead& block = course_plan.block;
    Answers answers;
    const bool keeps_answers = mesh.kind == CellKind::polygon && !options.fast;
    WalkCodes codes{{}, walk_models(mesh.kind), keeps_answers ? &answers : nullptr};
    Course course = run_course(complex, course_plan, codes);
    if (!course.is_whole) {
        course_plan = plan_course(mesh, complex, *plan, false);
        codes = {{}, walk_models(mesh.kind)};
        course = run_course(complex, course_plan, codes);
    }
    const WalkRecord& record = course.record;
    Reorder order = reorder_of(mesh, complex, record);
    const EdgePoints edges = order_edge_points(mesh, record, order);
    block.has_edge_points = !edges.of.empty();
    const std::vector<Index> unused(
        order.old_point.begin() + static_cast<std::ptrdiff_t>(block.points), order.old_point.end());
    const bool has_more =
        !mesh.attributes.empty() || !mesh.companions.empty() || options.keep_order;
    // Positions take most of the time; what else there is in the file may be made meanwhile.
    const CodedPositions all = in_order(*plan, complex, record, unused, edges);
    const auto write = [&](const ChosenFormat& chosen) {
        return packed(write_positions(all, chosen), options.level);
    };
    std::future<SectionBytes> positions;
    if (has_more) {
        positions = start(threads > 1, [&] {
            return write(choose_format(all, options.fast, std::max(1, threads - 1)));
        });
    } else {
        positions = start(
            threads > 1,
            [&write, chosen = choose_format(all, options.fast, threads)] { return write(chosen); });
    }
    const StripReading strip = read_strip(course.walked);
    block.links = strip.links;
    block.wants_mending = 100 * static_cast<double>(strip.added_cells) >
                          budget_of(complex, options) * static_cast<double>(block.cells);
    StripMesh on_strip;
    if (has_more) on_strip = strip_mesh_of(mesh, complex, record, order, edges, *plan);
    const std::vector<AttributeGrid> grids = round_attributes(on_strip.mesh, options);
    CompanionCodes companions;
    if (!mesh.companions.empty())
        companions = write_companions(on_strip, course.walked, edges, order);
    Encoded encoded;
    encoded.strip = {block.components, strip.links, strip.open_strips, strip.added_cells};
    encoded.position_bound = plan->bound;
    encoded.position_error = plan->error;
    for (const AttributeGrid& grid : grids) encoded.attribute_bounds.push_back(grid.bound);
    encoded.order = maps_of(order, mesh, options.keep_order);
    map_companions(order, options.keep_order, encoded.order);

    SectionBytes attributes, kept_order;
    if (!mesh.attributes.empty())
        attributes = packed(write_attributes(on_strip.ground(course.walked), companions.marked,
                                             grids, order.old_tuple),
                            options.level);
    if (options.keep_order)
        kept_order = packed(write_order(on_strip.ground(course.walked), companions.turned, order),
                            options.level);
    std::future<Connectivity> told;
    if (!answers.empty()) told = start(false, [&] { return by_precedents(answers, block); });
    if (told.valid() && threads > 1) told.wait();  // while positions are written
    const SectionBytes places = positions.get();
    Connectivity connectivity =
        choose_connectivity(codes, std::move(told), places.packed.size(), options.level, block);
    encoded.connectivity_ideal_bytes = connectivity.ideal_bits / 8;

    const bool has_names = !mesh.tag_names.empty() || !mesh.notes.empty();
    const auto bit = [](bool there, SectionId id) { return there ? unsigned{bit_of(id)} : 0u; };
    ByteWriter out;
    write_start(out, static_cast<SectionMask>(bit(!mesh.companions.empty(), SectionId::companions) |
                                              bit(!mesh.attributes.empty(), SectionId::attributes) |
                                              bit(has_names, SectionId::names) |
                                              bit(options.keep_order, SectionId::order)));
    const auto section = [&](const SectionBytes& bytes) {
        write_section(out, bytes.raw, bytes.packed);
    };
    const auto packed_section = [&](Bytes raw) { section(packed(std::move(raw), options.level)); };
    packed_section(write_head(head_of(mesh, *plan, grids, options)));
    packed_section(write_block_head(block, mesh.kind));
    packed_section(std::move(connectivity.bytes));
    section(places);
    if (!mesh.companions.empty()) packed_section(std::move(companions.section));
    if (!mesh.attributes.empty()) section(attributes);
    if (has_names) packed_section(write_names(mesh));
    if (options.keep_order) section(kept_order);
    write_end(out);
    encoded.bytes = out.take();
    return encoded;
}

}  // namespace ravel
