// From a file to a mesh. Every count is checked against the bytes and the memory limit before
// anything is allocated for it; the walk itself checks every code.
#include "decode/decoder.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "decode/attributes.h"
#include "decode/companions.h"
#include "decode/file.h"
#include "decode/order.h"
#include "decode/payload.h"
#include "decode/positions.h"
#include "decode/walk_driver.h"
#include "predict/edge_points.h"
#include "walk/fold_walk.h"
#include "walk/priors.h"
#include "walk/read_strip.h"
#include "walk/surface_walk.h"
#include "walk/tet_walk.h"

namespace ravel {
namespace {

Status corrupt(std::uint64_t at, const char* why) {
    return Error{Code::corrupt, at, why};
}

// Do values of points, or their old numbers, follow from those of their stencils?
bool needs_stencils(const Head& head) {
    return head.keeps_order ||
           std::any_of(head.attributes.begin(), head.attributes.end(),
                       [](const AttributeHead& a) { return a.place == Place::point; });
}

// The most a block's own arrays can take, from its head alone.
std::uint64_t memory_of(const FileSections& file, bool steps) {
    const BlockHead& b = file.block;
    const bool order = file.head.keeps_order;  // then there are two meshes for a while
    // Of tets, 32 bytes are for a front that hostile vertices crowd (see OpenTriangles).
    const std::uint64_t per_corner = (file.head.kind == CellKind::tet ? 100 : 52) +
                                     (order ? 24 : 0) + (b.has_precedents ? 6 : 0);
    const std::uint64_t per_cell =
                            (order ? 192 : 80) + (steps ? 112 : 0) + (b.has_precedents ? 6 : 0),
                        per_vertex = (order ? 828 : 772) + (b.has_copies ? 40 : 0),
                        per_edges = b.has_edge_points ? 168 : 0;
    return b.corners * per_corner + b.cells * (per_cell + per_edges) +
           (b.vertices + b.unused_points) * per_vertex;
}

// Cells of the walk as cells of the mesh: points instead of vertices, flipped ones turned back.
void write_cells(const Walked& walked, const std::vector<Id>& point,
                 const std::vector<std::uint8_t>& flipped, Mesh& mesh) {
    mesh.corners.resize(walked.vertex.size());
    if (mesh.kind == CellKind::polygon) {
        mesh.corner_begin.resize(std::size_t{walked.cell_count()} + 1);
        for (Id c = 0; c < walked.cell_count(); ++c) mesh.corner_begin[c + 1] = walked.end(c);
    }
    for (std::size_t i = 0; i < walked.vertex.size(); ++i)
        mesh.corners[i] = point[walked.vertex[i]];
    for (Id c = 0; c < flipped.size(); ++c) {
        if (!flipped[c]) continue;
        const auto begin = mesh.corners.begin() + walked.begin(c),
                   end = mesh.corners.begin() + walked.end(c);
        if (mesh.kind == CellKind::tet)
            std::swap(begin[2], begin[3]);
        else if (begin != end)
            std::reverse(begin + 1, end);
    }
}

template <class Walk>
Status run_walk(DecodeDriver& driver, const WalkLimits& limits, std::uint64_t at, Walked& out) {
    Walk walk(driver, limits);
    if (!walk.run() || driver.failed())
        return Error{Code::corrupt, at,
                     "the codes of the strip lead astray at cell " +
                         std::to_string(walk.walked().cell_count())};
    out = walk.take();
    return Done{};
}

// `stencils`: of the points that cells have, then of those of edges, if values at points are
// guessed from them.
Status decode_geometry(const FileSections& file, const Bytes& codes, const Bytes& position_bytes,
                       DecodedWalk& out, std::vector<Stencil>& stencils, EdgePoints& edges) {
    const BlockHead& block = file.block;
    const Section& section = file[SectionId::positions];
    ByteReader in(position_bytes, section.at);
    Result<PositionFormat> format = read_position_format(in, file.head);
    if (!format) return format.error();
    format->mirrored = block.mirrored;
    format->leaders_move = block.leaders_move;
    if (file.head.kind == CellKind::tet)
        format->usual_start = usual_start_of(*format, static_cast<double>(block.grid_side));
    WalkLimits limits;
    limits.cells = static_cast<Id>(block.cells);
    limits.corners = static_cast<Id>(block.corners);
    limits.vertices = static_cast<Id>(block.vertices);
    limits.uniform_degree = static_cast<Id>(block.uniform_degree);
    limits.has_border = block.has_border;
    limits.mirrored = block.mirrored;
    limits.grid_side = static_cast<double>(block.grid_side);
    limits.grid_count = block.grid_count;
    limits.shape_step = static_cast<double>(block.shape_step);
    limits.leaders_move = block.leaders_move;
    // A flag costs at least 1/1386 bit; a vertex asks for one at least.
    const std::uint64_t flags =
        (std::uint64_t{codes.size()} + position_bytes.size() + 16) * 8 * 1386;
    limits.plausible = static_cast<std::size_t>(std::min<std::uint64_t>(flags, PTRDIFF_MAX));
    const std::uint64_t at = file[SectionId::connectivity].at;
    if (block.cells > limits.plausible || block.vertices > limits.plausible ||
        block.corners / 3 > limits.plausible)
        return corrupt(at, "the codes of the strip can't tell of so many cells");
    const Index points = block.vertices + block.unused_points;
    if (points > limits.plausible)
        return corrupt(section.at, "the positions can't tell of so many points");
    FlagDecoder position_bits(in.raw(in.left()));
    ReadingCoder coder{position_bits};
    PositionCodes<ReadingCoder> positions(coder, *format, points);
    positions.reserve(points);
    const bool tets = file.head.kind == CellKind::tet;
    DecodeDriver driver(codes, positions, position_bits,
                        tets ? models_of(tet::kPriors, tet::kContexts, tet::kPriorSeen)
                             : models_of(surface::kPriors, surface::kContexts, surface::kPriorSeen),
                        file.head.kind, block, needs_stencils(file.head));
    Status status = block.by_folds
                        ? run_walk<FoldWalk<DecodeDriver>>(driver, limits, at, out.walked)
                    : tets ? run_walk<TetWalk<DecodeDriver>>(driver, limits, at, out.walked)
                           : run_walk<SurfaceWalk<DecodeDriver>>(driver, limits, at, out.walked);
    if (!status) return status.error();

    const auto starts =
        static_cast<Index>(std::count(out.walked.gate.begin(), out.walked.gate.end(), kNone));
    if (starts != block.components)
        return corrupt(at, "the walk has not as many parts as announced");
    out.flipped = driver.flipped();
    stencils = driver.take_stencils();
    std::vector<Id> vertex;  // per point, where edges have points of their own
    Id own_points = 0;
    out.point.resize(block.vertices);
    const std::vector<Id>& copy_of = driver.copy_of();
    for (Id v = 0; v < block.vertices; ++v) {
        const bool own = copy_of.empty() || copy_of[v] == kNone;
        out.point[v] = own ? own_points++ : out.point[copy_of[v]];
        if (own && block.has_edge_points) vertex.push_back(v);
    }
    if (own_points != block.points) return corrupt(at, "the points are not as many as announced");
    out.mesh.kind = file.head.kind;
    write_cells(out.walked, out.point, out.flipped, out.mesh);
    if (block.has_edge_points) edges = edge_points_of(out.mesh.corners, vertex);
    if (edges.end.size() > block.unused_points)
        return corrupt(at, "more edges than points for them");
    for (Index i = 0; i < block.unused_points; ++i) {
        const Stencil stencil = stencil_of_unused(edges, i, block.vertices);
        if (i < edges.end.size() && needs_stencils(file.head)) stencils.push_back(stencil);
        if (!positions.next(stencil, {}) || position_bits.exhausted())
            return corrupt(section.at, "the positions of unused points make no sense");
    }
    if (!driver.finished())
        return corrupt(at, "connectivity or positions are longer than the walk");
    out.mesh.positions =
        positions_of(file.head, positions, copy_of, block.points + block.unused_points);
    return Done{};
}

template <class Read>
Status decode_section(const FileSections& file, SectionId id, std::uint64_t& budget,
                      std::uint64_t growth, const Read& read) {
    if (!file.has(id)) return Done{};
    const Section& section = file[id];
    Result<Bytes> raw = unpack_section(section, budget, growth);
    if (!raw) return raw.error();
    ByteReader in(*raw, section.at);
    return read(in);
}

// What indices of attributes take beside their section.
Status charge_indices(const FileSections& file, const Mesh& mesh, std::uint64_t& budget) {
    const std::uint64_t per_index = file.head.keeps_order ? 24 : 8;
    for (const AttributeHead& a : file.head.attributes) {
        const Index elements = a.indexed ? element_count(mesh, a.place) : 0;
        if (elements > budget / per_index)
            return Error{Code::limit_exceeded, file[SectionId::attributes].at,
                         "the attributes need more memory than allowed"};
        budget -= elements * per_index;
    }
    return Done{};
}

Status read_walk(std::span<const std::byte> bytes, const DecodeOptions& options, DecodedWalk& out) {
    // Where sizes have 32 bits, no array holds more than half of what they count.
    std::uint64_t budget = std::min<std::uint64_t>(options.memory_limit, PTRDIFF_MAX);
    Result<FileSections> opened = open_file(bytes, budget);
    if (!opened) return opened.error();
    const FileSections& file = *opened;
    const std::uint64_t need = memory_of(file, options.steps);
    if (need > budget)
        return Error{Code::limit_exceeded, file[SectionId::block].at,
                     std::string("the mesh needs up to ") + std::to_string(need) +
                         " bytes; the limit is " + std::to_string(budget)};
    budget -= need;
    Result<Bytes> codes = unpack_section(file[SectionId::connectivity], budget);
    if (!codes) return codes.error();
    Result<Bytes> positions = unpack_section(file[SectionId::positions], budget);
    if (!positions) return positions.error();

    std::vector<Stencil> stencils;
    EdgePoints edges;
    out.wants_mending = file.block.wants_mending;
    out.links = file.block.links;
    Status status = decode_geometry(file, *codes, *positions, out, stencils, edges);
    if (!status) return status;
    Mesh& mesh = out.mesh;
    if ((file.block.companions > 0) != file.has(SectionId::companions) ||
        file.head.attributes.empty() == file.has(SectionId::attributes))
        return corrupt(0, "the heads and the sections contradict each other");
    // Growth: nodes are a byte in the file and twice eight in memory, while the order is restored;
    // a block, a name or a note is a few dozen times its shortest form.
    const Ground<Walked> ground{out.walked, mesh, out.point, out.flipped, stencils};
    std::vector<Id> marked;
    std::vector<Index> turned;
    status = decode_section(file, SectionId::companions, budget, 40, [&](ByteReader& in) {
        return read_companions(in, file.head, file.block, ground, budget, mesh, edges, marked,
                               turned);
    });
    if (!status) return status;
    if (status = charge_indices(file, mesh, budget); !status) return status;
    status = decode_section(file, SectionId::attributes, budget, file.head.keeps_order ? 4 : 2,
                            [&](ByteReader& in) {
                                return read_attributes(in, file.head, ground, marked, budget, mesh);
                            });
    if (!status) return status;
    status = decode_section(file, SectionId::names, budget, 72,
                            [&](ByteReader& in) { return read_names(in, mesh); });
    if (!status) return status;
    status = decode_section(file, SectionId::order, budget, 1, [&](ByteReader& in) -> Status {
        Result<Reorder> order = read_order(in, ground, turned, budget);
        if (!order) return order.error();
        restore_order(mesh, *order);
        out.cell = std::move(order->old_cell);
        out.turn = std::move(order->turn);
        return Done{};
    });
    if (!status) return status;
    // Whatever the bytes were, what leaves is a mesh.
    if (status = check_mesh(mesh); !status) return Error{Code::corrupt, 0, status.error().detail};
    return Done{};
}

}  // namespace

Result<DecodedWalk> decode_walk(std::span<const std::byte> bytes, const DecodeOptions& options) {
    DecodedWalk walk;
    if (Status status = read_walk(bytes, options, walk); !status) return status.error();
    return walk;
}

namespace {

// Facets as the mesh numbers them: a flipped cell's sides run backwards, its last corners are
// swapped; a kept order turns cells too.
std::uint32_t local_facet(const DecodedWalk& walk, Id facet) {
    const Walked& walked = walk.walked;
    const Id cell = walked.cell_of(facet), degree = walked.degree(cell);
    Id i = facet - walked.begin(cell);
    if (!walk.flipped.empty() && walk.flipped[cell])
        i = walked.kind == CellKind::polygon ? degree - 1 - i : i < 2 ? i : 5 - i;
    return walk.turn.empty() ? i : old_corner(walked.kind, walk.turn[cell], degree, i);
}

}  // namespace

Result<std::vector<StripStep>> steps_of(const DecodedWalk& walk) {
    const Walked& walked = walk.walked;
    const StripReading strip = read_strip(walked);
    if (strip.links != walk.links)
        return Error{Code::corrupt, 0, "the strip has not as many links as announced"};
    const auto mesh_cell = [&](Id c) -> Index { return walk.cell.empty() ? c : walk.cell[c]; };
    std::vector<StripStep> steps(walked.cell_count());
    for (Id c = 0; c < walked.cell_count(); ++c) {
        StripStep& step = steps[c];
        step.cell = mesh_cell(c);
        if (walked.gate[c] == kNone) continue;
        step.from = mesh_cell(walked.cell_of(walked.gate[c]));
        step.exit = local_facet(walk, walked.gate[c]);
        step.entry = local_facet(walk, walked.entry(c));
        step.link = strip.link[c] != 0;
    }
    return steps;
}

Result<Decoded> decode(std::span<const std::byte> bytes, const DecodeOptions& options) {
    DecodedWalk walk;
    if (Status status = read_walk(bytes, options, walk); !status) return status.error();
    Decoded decoded;
    decoded.mesh = std::move(walk.mesh);
    decoded.wants_mending = walk.wants_mending;
    if (!options.steps) return decoded;
    auto steps = steps_of(walk);
    if (!steps) return steps.error();
    decoded.steps = std::move(*steps);
    return decoded;
}

}  // namespace ravel
