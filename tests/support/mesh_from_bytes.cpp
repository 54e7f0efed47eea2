#include "support/mesh_from_bytes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace ravel::test {
namespace {

class Source {
  public:
    explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}
    bool empty() const { return at_ >= bytes_.size(); }
    unsigned u8() { return empty() ? 0 : static_cast<unsigned>(bytes_[at_++]); }
    unsigned below(unsigned n) { return n == 0 ? 0 : u8() % n; }
    std::uint64_t u64() {
        std::uint64_t v = 0;
        for (int i = 0; i < 8; ++i) v = v << 8 | u8();
        return v;
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

double number(Source& in) {
    using Limits = std::numeric_limits<double>;
    const unsigned kind = in.u8();
    if (kind < 200) return static_cast<double>(kind) * 0.125 - 5;
    switch (kind % 12) {
        case 0:
            return Limits::quiet_NaN();
        case 1:
            return Limits::infinity();
        case 2:
            return -Limits::infinity();
        case 3:
            return -0.0;
        case 4:
            return Limits::denorm_min();
        case 5:
            return -Limits::max();
        case 6:
            return Limits::max();
        case 7:
            return 1e-300;
        case 8:
            return 1e30 + in.u8();
        case 9:
            return static_cast<double>(std::numeric_limits<float>::denorm_min()) * in.u8();
        case 10:
            return 1e6 + in.u8() / 256.0;
        default: {
            const std::uint64_t bits = in.u64();
            double x = 0;
            std::memcpy(&x, &bits, sizeof x);
            return x;
        }
    }
}

void add_points(Mesh& mesh, Source& in) {
    const bool narrow = in.u8() % 2 == 0;
    const std::size_t points = in.below(40);
    mesh.positions = make_array(narrow ? Scalar::f32 : Scalar::f64, 3, points);
    for (std::size_t i = 0; i < 3 * points; ++i) {
        if (narrow)
            mesh.positions.as<float>()[i] = static_cast<float>(number(in));
        else
            mesh.positions.as<double>()[i] = number(in);
    }
}

// Cells of new random points, or over a facet of an earlier cell.
void add_cells(Mesh& mesh, Source& in) {
    const auto points = static_cast<unsigned>(mesh.point_count());
    if (mesh.kind == CellKind::polygon) mesh.corner_begin.assign(1, 0);
    if (points == 0) return;
    for (unsigned left = in.below(120); left > 0 && !in.empty(); --left) {
        const unsigned how = in.u8();
        std::size_t degree = 4;
        if (mesh.kind == CellKind::polygon)
            degree = std::array<std::size_t, 10>{4, 3, 5, 4, 6, 2, 1, 0, 8, 19}[how % 10];
        std::vector<Index> cell;
        const Index cells = mesh.cell_count();
        if (cells > 0 && how >= 64) {
            const auto old = mesh.cell(
                how % 3 == 0 ? in.below(static_cast<unsigned>(std::min<Index>(cells, 256)))
                             : cells - 1);
            if (how >= 250) {
                cell.assign(old.begin(), old.end());
                degree = cell.size();
            } else if (mesh.kind == CellKind::tet) {
                const unsigned skip = in.below(4);
                for (unsigned i = 0; i < 4; ++i)
                    if (i != skip) cell.push_back(old[i]);
                if ((skip + how) % 2 == 0) std::swap(cell[0], cell[1]);
            } else if (old.size() >= 2 && degree >= 2) {
                const unsigned side = in.below(static_cast<unsigned>(old.size()));
                cell = {old[(side + 1) % old.size()], old[side]};
                if (how % 7 == 0) std::swap(cell[0], cell[1]);
            }
        }
        while (cell.size() < degree) cell.push_back(in.below(points));
        mesh.corners.insert(mesh.corners.end(), cell.begin(), cell.end());
        if (mesh.kind == CellKind::polygon) mesh.corner_begin.push_back(mesh.corners.size());
    }
}

void add_companions(Mesh& mesh, Source& in) {
    const auto points = static_cast<unsigned>(std::min<Index>(mesh.point_count(), 255));
    const auto cells = static_cast<unsigned>(std::min<Index>(mesh.cell_count(), 255));
    for (unsigned left = in.below(3); left > 0; --left) {
        CompanionBlock block;
        const bool hosted = in.u8() % 4 == 0 && cells > 0 && points > 0;
        block.vtk_type = hosted ? 24 : static_cast<std::uint16_t>(in.u8());
        block.nodes_per_cell = hosted ? 6 : points == 0 ? 0 : in.below(5);
        block.cell_count = in.below(10);
        for (Index i = 0; i < block.cell_count * block.nodes_per_cell; ++i)
            block.nodes.push_back(in.below(points));
        for (Index i = 0; hosted && i < block.cell_count; ++i)
            block.hosts.push_back(in.below(cells));
        mesh.companions.push_back(std::move(block));
    }
}

// Points, lines and triangles that are parts of cells, some of them twice.
void add_parts(Mesh& mesh, Source& in) {
    const auto cells = static_cast<unsigned>(std::min<Index>(mesh.cell_count(), 255));
    if (cells == 0) return;
    for (std::uint32_t nodes = 1; nodes <= 3; ++nodes) {
        CompanionBlock block;
        block.vtk_type = std::array<std::uint16_t, 4>{0, 1, 3, 5}[nodes];
        block.nodes_per_cell = nodes;
        for (unsigned left = in.below(40); left > 0 && !in.empty(); --left) {
            const auto cell = mesh.cell(in.below(cells));
            if (cell.size() < nodes) continue;
            const unsigned from = in.u8(),
                           step = from >= 128 ? 1 : static_cast<unsigned>(cell.size()) - 1;
            for (std::uint32_t k = 0; k < nodes; ++k)
                block.nodes.push_back(cell[(from + std::size_t{k} * step) % cell.size()]);
            ++block.cell_count;
        }
        mesh.companions.push_back(std::move(block));
    }
}

void add_attributes(Mesh& mesh, Source& in) {
    for (unsigned left = in.below(4); left > 0; --left) {
        Attribute a;
        a.name = std::string(in.below(4), static_cast<char>('a' + left));
        a.place = static_cast<Place>(in.below(5));
        const auto scalar = static_cast<Scalar>(in.below(10));
        const unsigned arity = 1 + in.below(4);
        const Index elements = element_count(mesh, a.place);
        const bool pool = a.place == Place::mesh || in.u8() % 3 == 0;
        const Index tuples = pool ? in.below(6) : elements;
        a.values = make_array(scalar, arity, tuples);
        if (in.u8() % 2 == 0) {
            for (std::byte& b : a.values.bytes) b = static_cast<std::byte>(in.u8());
        } else {
            // A few values, mostly that of the element before.
            const std::size_t stride = a.values.stride();
            for (Index t = 0; t < tuples; ++t) {
                const unsigned tag = in.u8();
                for (std::size_t b = 0; b < stride; ++b)
                    a.values.bytes[t * stride + b] =
                        t > 0 && tag >= 32 ? a.values.bytes[(t - 1) * stride + b]
                                           : static_cast<std::byte>(b == 0 ? tag % 5 : 0);
            }
        }
        if (pool && a.place != Place::mesh)
            for (Index i = 0; i < elements; ++i)
                a.index.push_back(tuples == 0 || in.u8() % 5 == 0
                                      ? kNoIndex
                                      : in.below(static_cast<unsigned>(tuples)));
        if (!is_float(scalar) && size_of(scalar) >= 4 && in.u8() % 3 == 0) {
            const bool has_sign = scalar == Scalar::i32 || scalar == Scalar::i64;
            a.references.push_back({in.below(arity), in.u8() % 2 == 0 ? Place::point : Place::cell,
                                    static_cast<std::int64_t>(in.below(5)) - (has_sign ? 2 : 0)});
        }
        mesh.attributes.push_back(std::move(a));
    }
    if (in.u8() % 4 == 0)
        mesh.tag_names.push_back({"b", static_cast<int>(in.below(5)) - 1, -7, "wall"});
    if (in.u8() % 4 == 0) mesh.notes.push_back({"key", std::string(in.below(9), '\0')});
}

}  // namespace

MeshCase mesh_from_bytes(std::span<const std::byte> bytes) {
    Source in(bytes);
    MeshCase made;
    made.mesh.kind = in.u8() % 2 == 0 ? CellKind::polygon : CellKind::tet;
    EncodeOptions& options = made.options;
    options.level = 1;
    const unsigned quality = in.u8();
    switch (quality % 6) {
        case 0:
            options.position_bits = 1 + static_cast<int>(in.below(30));
            break;
        case 1:
            options.max_error = 0.001 * (1 + in.u8());
            break;
        case 2:
            options.max_error = std::abs(number(in));
            break;
        case 3:
            options.float32 = true;
            break;
        default:
            break;
    }
    const unsigned rest = in.u8();
    options.keep_order = (rest & 1) != 0;
    options.strip_budget = rest & 4 ? 0 : 12.5;
    const bool extras = (rest & 8) != 0;
    add_points(made.mesh, in);
    add_cells(made.mesh, in);
    if (extras) {
        add_companions(made.mesh, in);
        if (in.u8() % 2 == 0) add_parts(made.mesh, in);
        add_attributes(made.mesh, in);
    }
    return made;
}

std::string step_trouble(const Decoded& decoded) {
    const Mesh& mesh = decoded.mesh;
    if (decoded.steps.size() != mesh.cell_count()) return "not one step per cell";
    std::vector<bool> seen(mesh.cell_count(), false);
    const auto facet = [&](Index c, std::uint32_t f) {
        const auto cell = mesh.cell(c);
        std::vector<Index> points;
        if (mesh.kind == CellKind::tet) {
            for (std::uint32_t i = 0; i < 4; ++i)
                if (i != f) points.push_back(cell[i]);
        } else {
            points = {cell[f], cell[(f + 1) % cell.size()]};
        }
        std::sort(points.begin(), points.end());
        return points;
    };
    for (const StripStep& step : decoded.steps) {
        if (step.cell >= mesh.cell_count() || seen[step.cell]) return "a step to no new cell";
        seen[step.cell] = true;
        if (step.from == kNoIndex) {
            if (step.link) return "a component starts with a link";
            continue;
        }
        if (step.from >= mesh.cell_count() || !seen[step.from])
            return "a step from no visited cell";
        if (step.exit >= mesh.cell(step.from).size() || step.entry >= mesh.cell(step.cell).size())
            return "a step through no facet";
        if (facet(step.from, step.exit) != facet(step.cell, step.entry))
            return "a step's facets differ";
    }
    return {};
}

std::string trouble(const Mesh& mesh, const EncodeOptions& options) {
    if (const Status status = check_mesh(mesh); !status)
        return "the test's mesh: " + status.error().detail;
    const Result<Encoded> packed = encode(mesh, options);
    if (!packed) {
        const bool may_fail = (options.max_error || options.max_error_relative) && packed.error().code == Code::bad_option;
        return may_fail ? "" : "encode: " + packed.error().detail;
    }
    DecodeOptions all;
    all.steps = true;
    const Result<Decoded> again = decode(packed->bytes, all);
    if (!again) return "decode: " + again.error().detail;
    if (const Status status = check_mesh(again->mesh); !status)
        return "decoded mesh: " + status.error().detail;
    // Rounding to float32 is the one change that is asked for.
    Mesh original = mesh;
    if (options.float32 && mesh.positions.scalar == Scalar::f64 && mesh.point_count() > 0) {
        original.positions = make_array(Scalar::f32, 3, mesh.point_count());
        for (std::size_t i = 0; i < 3 * mesh.point_count(); ++i)
            original.positions.as<float>()[i] = static_cast<float>(mesh.positions.as<double>()[i]);
    }
    const Comparison found =
        compare_meshes(original, again->mesh, packed->order, packed->position_bound);
    if (!found.equal) return "differs: " + found.difference;
    if (options.keep_order && !found.order_kept) return "the order was not kept";
    if (options.max_error && !(found.max_error <= *options.max_error))
        return "the error asked for was passed";
    if (found.max_error > packed->position_error)
        return "the error is larger than the encoder measured";
    if (const std::string steps = step_trouble(*again); !steps.empty()) return steps;
    const Result<FileInfo> info = inspect(packed->bytes);
    if (!info) return "inspect: " + info.error().detail;
    const auto starts =
        static_cast<Index>(std::count_if(again->steps.begin(), again->steps.end(),
                                         [](const StripStep& s) { return s.from == kNoIndex; }));
    if (starts != packed->strip.components || info->components != starts)
        return "components are miscounted";
    if (info->cells != mesh.cell_count() || info->points != mesh.point_count())
        return "inspect miscounts";
    const Result<Encoded> twice = encode(mesh, options);
    if (!twice || twice->bytes != packed->bytes) return "encoding twice gives other bytes";
    return {};
}

}  // namespace ravel::test
