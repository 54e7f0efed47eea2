// The streams are read by a plain reader of bits that follows chapter 4 of spec/format.md to the
// letter; walks and predictors are those of codec/.
#include "spec/trace.h"

#include <cstdio>
#include <optional>

#include "base/checksum.h"
#include "container/head.h"
#include "container/sections.h"
#include "entropy/flag_model.h"
#include "entropy/pack.h"
#include "entropy/priors.h"
#include "predict/priors.h"
#include "ravel/ravel.h"
#include "spec/context_names.h"
#include "walk/priors.h"
#include "walk/surface_walk.h"
#include "walk/tet_walk.h"

namespace ravel::test {
namespace {

std::string hex(std::span<const std::byte> bytes) {
    std::string text;
    char two[8];
    for (const std::byte b : bytes) {
        std::snprintf(two, sizeof two, text.empty() ? "%02X" : " %02X", static_cast<unsigned>(b));
        text += two;
    }
    return text;
}
// The same, but of many bytes only how many.
std::string data_hex(std::span<const std::byte> bytes) {
    return bytes.size() <= 400 ? hex(bytes) : "(" + std::to_string(bytes.size()) + " bytes)";
}
std::string number_text(double x, bool narrow = false) {
    char text[40];
    std::snprintf(text, sizeof text, narrow ? "%.9g" : "%.17g", x);
    return text;
}
std::string id_text(Id id) {
    return id == kNone ? "-" : std::to_string(id);
}

// --- fields ------------------------------------------------------------------------------------

// Reads fields and tells each: where it starts, its bytes, its name, its value.
class Fields {
  public:
    Fields(std::span<const std::byte> bytes, std::string& out)
        : bytes_(bytes), in_(bytes), out_(out) {}

    unsigned u8(const char* name) {
        const unsigned v = in_.u8();
        tell(name, std::to_string(v));
        return v;
    }
    std::uint64_t varint(const char* name) {
        const std::uint64_t v = in_.varint();
        tell(name, std::to_string(v));
        return v;
    }
    std::int64_t signed_varint(const char* name) {
        const std::int64_t v = unzigzag(in_.varint());
        tell(name, std::to_string(v));
        return v;
    }
    double real(const char* name, bool narrow) {
        const double v = narrow ? static_cast<double>(std::bit_cast<float>(in_.u32())) : in_.f64();
        tell(name, number_text(v, narrow));
        return v;
    }
    void text(const char* name) {
        const std::string v = in_.text();
        tell(name, "\"" + v + "\"");
    }
    std::span<const std::byte> rest() {
        const std::size_t from = at_;
        at_ = bytes_.size();
        return bytes_.subspan(from);
    }

  private:
    void tell(const char* name, const std::string& value) {
        const std::size_t end = bytes_.size() - in_.left();
        out_ += "  +" + std::to_string(at_) + "  " + hex(bytes_.subspan(at_, end - at_)) + "  " +
                name + " = " + value + "\n";
        at_ = end;
    }

    std::span<const std::byte> bytes_;
    ByteReader in_;
    std::string& out_;
    std::size_t at_ = 0;
};

void tell_head(Fields f) {
    const unsigned flags = f.u8("flags");
    if ((flags & 4) == 0) {
        f.u8("position_bits");
        const bool narrow = (flags & 16) != 0;
        for (const char* name : {"step", "origin", "origin", "origin", "bound", "error"})
            f.real(name, narrow);
    }
    const std::uint64_t count = f.varint("attribute_count");
    for (std::uint64_t i = 0; i < count; ++i) {
        f.text("name");
        f.u8("kind");
        const std::uint64_t width = f.varint("width");
        f.varint("tuples");
        const std::uint64_t references = width & 1 ? f.varint("reference_count") : 0;
        for (std::uint64_t r = 0; r < references; ++r) {
            f.varint("component * 2 + to_cells");
            f.signed_varint("base");
        }
    }
}

void tell_block(Fields f, bool tets) {
    const unsigned flags = f.u8("flags");
    f.varint("cells");
    if (!tets && f.varint("uniform_degree") == 0) f.varint("corners");
    f.varint("vertices");
    if (flags & 4) f.varint("points");
    for (const char* name : {"unused_points", "companions", "components", "links"}) f.varint(name);
    if (!tets) return;
    f.varint("grid_side");
    for (int axis = 0; axis < 3; ++axis) f.varint("grid_count");
}

PositionFormat tell_position_head(Fields& f, const Head& head, const BlockHead& block) {
    PositionFormat format;
    format.narrow = head.position_scalar == Scalar::f32;
    format.mirrored = block.mirrored;
    const unsigned flags = f.u8("flags"), fitted = f.u8("fitted");
    format.has_outliers = (flags & 4) != 0;
    format.numbers.has_minus_zero = (flags & 8) != 0;
    format.numbers.base = static_cast<NumberBase>(flags >> 4 & 3);
    format.has_levels = (flags & 128) != 0;
    format.has_follows = (fitted & 128) != 0;
    if (head.lossless) {
        format.numbers.places = static_cast<int>(f.signed_varint("places"));
        format.numbers.digits = static_cast<int>(f.u8("digits"));
    }
    if (flags & 64) {
        const unsigned count = f.u8("echo_count"), look = f.u8("look");
        format.cube_bits = static_cast<int>(look & 127);
        format.looks_far = (look & 128) != 0;
        for (unsigned e = 0; e < count; ++e) {
            Echo echo;
            const unsigned mirrored = f.u8("mirrored");
            for (std::size_t k = 0; k < 3; ++k) {
                echo.mirrored[k] = (mirrored >> k & 1) != 0;
                echo.offset[k] = f.signed_varint("offset");
            }
            format.echoes.push_back(echo);
        }
    }
    for (std::size_t c = 0; c < kConfigurations; ++c)
        for (std::size_t i = 0; i < kFeatureCount[c] && (fitted >> c & 1); ++i)
            format.weights[c][i] = static_cast<std::int16_t>(f.signed_varint("weight"));
    format.has_stand_ins = head.lossless && head.kind == CellKind::tet;
    if (format.has_stand_ins) {
        for (double& x : format.place_origin) x = f.real("place_origin", false);
        format.place_scale = f.real("place_scale", false);
    }
    return format;
}

// --- flags -------------------------------------------------------------------------------------

// The first flags and cells go into the text, all blocks of contexts into the set.
struct Telling {
    std::string& out;
    std::set<std::string>& blocks;
    const TraceLimits limits;
    int flags = 0, cells = 0;

    bool tells_flags() const { return flags < limits.flags && tells_cells(); }
    bool tells_cells() const { return cells <= limits.cells; }
    void flag(const std::string& text) {
        if (tells_flags()) out += text + "\n";
        if (++flags == limits.flags && tells_cells()) out += "    ...\n";
    }
    void cell(const std::string& text) {
        ++cells;
        out += tells_cells() ? text : cells == limits.cells + 1 ? "...\n" : "";
    }
    void detail(const std::string& text) {
        if (tells_cells()) out += text;
    }
};

class Stream {
  public:
    Stream(std::span<const std::byte> bytes, char letter, std::string stream,
           const std::vector<NamedBlock>& blocks, std::vector<FlagModel> models, Telling& telling)
        : bytes_(bytes),
          letter_(letter),
          stream_(std::move(stream)),
          blocks_(blocks),
          models_(std::move(models)),
          telling_(telling) {}

    bool flag(Context context) {
        FlagModel& model = models_[context];
        const auto c = static_cast<std::size_t>(model.flag_class());
        Run& run = runs_[c];
        bits_.clear();
        if (run.left == 0) {
            run.ends_in_miss = bit() == 0;
            run.left = run.ends_in_miss ? below(kRunOf[c]) + 1 : kRunOf[c];
        }
        --run.left;
        const bool missed = run.left == 0 && run.ends_in_miss;
        const bool yes = model.likely() != missed;
        model.update(yes);
        const std::string name = name_of_context(blocks_, context);
        telling_.blocks.insert(stream_ + " " + name.substr(0, name.find('(')));
        if (telling_.tells_flags())
            telling_.flag("    " + std::string(1, letter_) + " " + name + "  " + std::to_string(c) +
                          "  " + (bits_.empty() ? "-" : bits_) + "  " + (yes ? "yes" : "no"));
        return yes;
    }
    std::uint64_t plain(int count) {
        bits_.clear();
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) value = value << 1 | bit();
        if (count > 0)
            telling_.flag("    " + std::string(1, letter_) + " plain(" + std::to_string(count) +
                          ")  " + bits_ + "  " + std::to_string(value));
        return value;
    }
    bool exhausted() const { return at_ > 8 * bytes_.size(); }
    // Fewer than eight bits are left, all of them 0.
    bool finished() {
        if (exhausted() || 8 * bytes_.size() - at_ >= 8) return false;
        while (at_ < 8 * bytes_.size())
            if (bit() != 0) return false;
        return true;
    }

  private:
    struct Run {
        std::uint32_t left = 0;
        bool ends_in_miss = false;
    };

    unsigned bit() {
        const std::size_t byte = at_ / 8;
        const unsigned b =
            byte < bytes_.size() ? static_cast<unsigned>(bytes_[byte]) >> (7 - at_ % 8) & 1 : 0;
        ++at_;
        bits_ += b ? '1' : '0';
        return b;
    }
    std::uint32_t below(std::uint32_t s) {
        if (s <= 1) return 0;
        const auto w = static_cast<unsigned>(std::bit_width(s - 1));
        const std::uint32_t b = (1u << w) - s;
        std::uint32_t v = 0;
        for (unsigned i = 1; i < w; ++i) v = v << 1 | bit();
        return v < b ? v : 2 * v + bit() - b;
    }

    std::span<const std::byte> bytes_;
    const char letter_;
    const std::string stream_;
    const std::vector<NamedBlock>& blocks_;
    std::vector<FlagModel> models_;
    Telling& telling_;
    std::size_t at_ = 0;
    std::array<Run, kFlagClasses> runs_{};
    std::string bits_;
};

struct TraceCoder {
    static constexpr bool kWrites = false;
    Stream& in;
    bool flag(Context context, bool) { return in.flag(context); }
    std::uint64_t plain(std::uint64_t, int count) { return in.plain(count); }
};

// --- the walk ----------------------------------------------------------------------------------

constexpr const char* kConfigurationName[] = {
    "seed", "quad_third", "quad_fourth", "quad_corner", "triangle", "polygon", "tet"};

class TraceDriver {
  public:
    TraceDriver(Stream& codes, PositionCodes<TraceCoder>& positions, const BlockHead& block,
                bool tets, Telling& telling)
        : codes_(codes), positions_(positions), block_(block), tets_(tets), telling_(telling) {}

    bool flag(Context context, bool) { return codes_.flag(context); }
    std::uint64_t number(Context base, std::uint64_t) {
        int n = 1;
        while (n < 64 && codes_.flag(base + static_cast<Context>(n) - 1)) ++n;
        return (std::uint64_t{1} << (n - 1) | codes_.plain(n - 1)) - 1;
    }
    bool failed() const { return bad_ || codes_.exhausted(); }

    void begin_cell(Id gate) {
        telling_.cell("cell " + std::to_string(cells_++) +
                      (gate == kNone ? ": seed" : ": gate " + id_text(gate)) + "\n");
    }
    void new_vertex(Id v, Id, const Stencil& stencil) {
        Id of = kNone;
        if (block_.has_copies &&
            (last_was_copy_ =
                 flag((tets_ ? tet::kCopy : surface::kCopy).at(last_was_copy_), false))) {
            const Context base = (tets_ ? tet::kCopyOf : surface::kCopyOf).base;
            last_copied_ += static_cast<std::uint64_t>(unzigzag(number(base, 0)));
            of = static_cast<Id>(last_copied_);
            bad_ = bad_ || last_copied_ >= v;
        }
        if (bad_) return;
        if (of != kNone)
            positions_.copy(of);
        else
            bad_ = !positions_.next(stencil, {}, false);
        places_.push_back(place_of(positions_.format(), positions_.values().back()));
        tell_vertex(v, stencil, of);
    }
    void tell_vertex(Id v, const Stencil& stencil, Id of) {
        std::string text = "  vertex " + std::to_string(v) + ": ";
        if (of != kNone) {
            telling_.detail(text + "copy of " + std::to_string(of) + "\n");
            return;
        }
        text += kConfigurationName[static_cast<std::size_t>(stencil.configuration)];
        std::size_t count = kStencilSize;
        while (count > 0 && stencil.at[count - 1] == kNone) --count;
        text += " [";
        for (std::size_t i = 0; i < count; ++i) text += (i ? " " : "") + id_text(stencil.at[i]);
        text += "], value";
        for (const double x : positions_.values().back()) text += " " + number_text(x);
        telling_.detail(text + "\n");
    }
    const Point3& place(Id v) const { return places_[v]; }
    void end_cell(Id cell) {
        if (block_.has_flips)
            last_flip_ = flag((tets_ ? tet::kFlip : surface::kFlip).at(last_flip_), false);
        std::string text = "  corners";
        for (Id i = walked->begin(cell); i < walked->end(cell); ++i)
            text += " " + std::to_string(walked->vertex[i]);
        telling_.detail(text + (last_flip_ ? ", flipped\n" : "\n"));
    }

    Id degree() const { return 0; }
    bool zips(Id) const { return false; }
    bool is_new(Id) const { return false; }
    Id gap(Id, bool&) const { return kNone; }
    bool apex_is(Id) const { return false; }
    Id apex() const { return kNone; }
    bool glues(Id) const { return false; }
    bool border(Id) const { return false; }

    const Walked* walked = nullptr;

  private:
    Stream& codes_;
    PositionCodes<TraceCoder>& positions_;
    const BlockHead& block_;
    const bool tets_;
    Telling& telling_;
    std::vector<Point3> places_;
    std::uint64_t last_copied_ = 0, cells_ = 0;
    bool last_was_copy_ = false, last_flip_ = false, bad_ = false;
};

template <class Walk>
bool run(TraceDriver& driver, const WalkLimits& limits) {
    Walk walk(driver, limits);
    driver.walked = &walk.walked();
    return walk.run() && !driver.failed();
}

// Empty, or what is wrong.
std::string tell_walk(const Head& head, const BlockHead& block, const Bytes& connectivity,
                      const PositionFormat& format, std::span<const std::byte> position_bits,
                      Trace& trace, const TraceLimits& trace_limits) {
    const bool tets = head.kind == CellKind::tet;
    Telling telling{trace.text, trace.blocks, trace_limits};
    Stream codes(connectivity, 'c', tets ? "tet" : "surface",
                 tets ? tet_blocks() : surface_blocks(),
                 tets ? models_of(tet::kPriors, tet::kContexts, tet::kPriorSeen)
                      : models_of(surface::kPriors, surface::kContexts, surface::kPriorSeen),
                 telling);
    Stream bits(position_bits, 'p', "positions", position_blocks(),
                models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen), telling);
    TraceCoder coder{bits};
    PositionCodes<TraceCoder> positions(coder, format, block.vertices + block.unused_points);
    WalkLimits limits;
    limits.cells = static_cast<Id>(block.cells);
    limits.corners = static_cast<Id>(block.corners);
    limits.vertices = static_cast<Id>(block.vertices);
    limits.uniform_degree = static_cast<Id>(block.uniform_degree);
    limits.has_border = block.has_border;
    limits.grid_side = static_cast<double>(block.grid_side);
    limits.grid_count = block.grid_count;
    limits.mirrored = block.mirrored;
    limits.plausible = 1 << 20;
    TraceDriver driver(codes, positions, block, tets, telling);
    if (!(tets ? run<TetWalk<TraceDriver>>(driver, limits)
               : run<SurfaceWalk<TraceDriver>>(driver, limits)))
        return "the walk fails";
    for (Index i = 0; i < block.unused_points; ++i) {
        Stencil stencil;
        const Index v = block.vertices + i;
        if (v > 0) stencil.at[0] = static_cast<Id>(v - 1);
        if (!positions.next(stencil, {}, false)) return "an unused point fails";
        driver.tell_vertex(static_cast<Id>(v), stencil, kNone);
    }
    return codes.finished() && bits.finished() ? "" : "the streams are not at their end";
}

// --- the mesh ----------------------------------------------------------------------------------

void tell_array(const Array& values, std::string& out) {
    for (std::size_t i = 0; i < values.bytes.size(); i += size_of(values.scalar)) {
        std::string digits;  // most significant first
        for (std::size_t b = size_of(values.scalar); b-- > 0;)
            digits += hex(std::span(values.bytes).subspan(i + b, 1));
        out += " " + digits;
    }
}

void tell_strip(const std::vector<StripStep>& steps, std::string& out) {
    out += "\nthe strip: cell, or cell from exit entry, l for a link; then the next";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const StripStep& step = steps[i];
        out += (i % 8 == 0 ? "\n" : ", ") + std::to_string(step.cell);
        if (step.from != kNoIndex)
            out += " " + std::to_string(step.from) + " " + std::to_string(step.exit) + " " +
                   std::to_string(step.entry) + (step.link ? " l" : "");
    }
    out += "\n";
}

void tell_points_and_cells(const Mesh& mesh, std::string& out) {
    const bool narrow = mesh.positions.scalar == Scalar::f32;
    for (Index p = 0; p < mesh.point_count(); ++p) {
        out += "point " + std::to_string(p) + ":";
        for (std::size_t k = 0; k < 3; ++k)
            out += " " + (narrow ? number_text(mesh.positions.as<float>()[3 * p + k], true)
                                 : number_text(mesh.positions.as<double>()[3 * p + k]));
        out += "\n";
    }
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        out += "cell " + std::to_string(c) + ":";
        for (const Index i : mesh.cell(c)) out += " " + std::to_string(i);
        out += "\n";
    }
}

void tell_checksums(const Decoded& decoded, std::string& out) {
    const Mesh& mesh = decoded.mesh;
    ByteWriter strip, cells;
    for (const StripStep& step : decoded.steps)
        for (const std::uint64_t n :
             {step.cell, step.from, Index{step.exit}, Index{step.entry}, Index{step.link}})
            strip.u32(static_cast<std::uint32_t>(n));
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        cells.u32(static_cast<std::uint32_t>(mesh.cell(c).size()));
        for (const Index i : mesh.cell(c)) cells.u32(static_cast<std::uint32_t>(i));
    }
    const auto tell = [&](const char* what, std::span<const std::byte> bytes) {
        char text[16];
        std::snprintf(text, sizeof text, "%08X", crc32c(bytes));
        out += std::string("crc32c of ") + what + ": " + text + "\n";
    };
    out += "\nthe mesh, " + std::to_string(mesh.point_count()) + " points and " +
           std::to_string(mesh.cell_count()) + " cells\n";
    tell("the points' bytes", mesh.positions.bytes);
    tell("number of corners and corners of all cells, as u32", cells.bytes());
    tell("cell, from (NONE for a seed), exit, entry, link of all steps of the strip, as u32",
         strip.bytes());
}

void tell_mesh(const Decoded& decoded, Index most_cells, std::string& out) {
    const Mesh& mesh = decoded.mesh;
    if (mesh.cell_count() <= most_cells) {
        tell_strip(decoded.steps, out);
        out += "\nthe mesh\n";
        tell_points_and_cells(mesh, out);
    } else {
        tell_checksums(decoded, out);
    }
    for (const CompanionBlock& block : mesh.companions) {
        out += "companions of vtk_type " + std::to_string(block.vtk_type) + ", " +
               std::to_string(block.nodes_per_cell) + " nodes each, " +
               std::to_string(block.cell_count) + " cells:";
        for (const Index node : block.nodes) out += " " + std::to_string(node);
        if (!block.hosts.empty()) out += "; hosts";
        for (const Index host : block.hosts) out += " " + std::to_string(host);
        out += "\n";
    }
    for (const Attribute& a : mesh.attributes) {
        out += "attribute \"" + a.name + "\" on " + name_of(a.place) + ", " +
               std::to_string(a.values.arity) + " x " + name_of(a.values.scalar) + ", as bits:";
        tell_array(a.values, out);
        if (!a.index.empty()) out += "; index";
        for (const Index i : a.index) out += i == kNoIndex ? " -" : " " + std::to_string(i);
        out += "\n";
    }
    for (const TagName& n : mesh.tag_names)
        out += "name of \"" + n.attribute + "\", dimension " + std::to_string(n.dimension) +
               ", value " + std::to_string(n.value) + ": \"" + n.name + "\"\n";
    for (const Note& n : mesh.notes) out += "note \"" + n.key + "\": \"" + n.text + "\"\n";
}

}  // namespace

PositionFormat position_format_of(const Bytes& positions, const Head& head, const BlockHead& block,
                                  std::size_t& bits_at) {
    std::string untold;
    Fields fields(positions, untold);
    PositionFormat format = tell_position_head(fields, head, block);
    bits_at = positions.size() - fields.rest().size();
    return format;
}

Trace trace_of(std::span<const std::byte> file, const TraceLimits& limits) {
    Trace trace;
    std::string& out = trace.text;
    const auto broken = [&](const std::string& why) {
        out += "broken: " + why + "\n";
        return trace;
    };
    out = "0  " + hex(file.subspan(0, 5)) + "  magic, version\n";
    ByteReader in(file.subspan(5));
    Head head;
    BlockHead block;
    PositionFormat format;
    Bytes connectivity, positions;
    std::size_t bits_at = 0;
    for (;;) {
        const std::size_t at = file.size() - in.left();
        const Result<Section> section = read_section(in);
        if (!section) return broken(section.error().detail);
        const std::size_t end = file.size() - in.left();
        if (section->id == SectionId::end) {
            out += std::to_string(at) + "  00  end\n";
            break;
        }
        out += std::to_string(at) + "  " + hex(file.subspan(at, end - at - section->bytes.size())) +
               "  section " + name_of(section->id) + ", " + std::to_string(section->bytes.size()) +
               " bytes" +
               (section->packed ? ", unpacked " + std::to_string(section->raw_size) : "") + "\n";
        Bytes raw(section->bytes.begin(), section->bytes.end());
        if (section->packed) {
            out += "  packed: " + data_hex(raw) + "\n";
            Result<Bytes> unpacked = unpack(section->bytes, section->raw_size, at);
            if (!unpacked) return broken(unpacked.error().detail);
            raw = std::move(*unpacked);
        }
        Fields fields(raw, out);
        ByteReader again(raw);
        switch (section->id) {
            case SectionId::head:
                tell_head(fields);
                head = *read_head(again);
                break;
            case SectionId::block:
                tell_block(fields, head.kind == CellKind::tet);
                block = *read_block_head(again, head.kind);
                break;
            case SectionId::positions: {
                format = tell_position_head(fields, head, block);
                const auto rest = fields.rest();
                bits_at = raw.size() - rest.size();
                out += "  +" + std::to_string(bits_at) + "  " + data_hex(rest) + "  bits\n";
                positions = raw;
                break;
            }
            case SectionId::connectivity:
                connectivity = raw;
                [[fallthrough]];
            default:
                out += "  +0  " + data_hex(raw) + "\n";
        }
    }
    out +=
        "\nthe walk, as it is read from connectivity (c) and positions (p)\n"
        "  flags: context, class, bits of a run that starts here, answer\n"
        "  plain bits: how many, bits, value\n";
    const std::string wrong = tell_walk(head, block, connectivity, format,
                                        std::span(positions).subspan(bits_at), trace, limits);
    if (!wrong.empty()) return broken(wrong);
    DecodeOptions options;
    options.steps = true;
    const Result<Decoded> decoded = decode(file, options);
    if (!decoded) return broken(decoded.error().detail);
    tell_mesh(*decoded, limits.mesh_cells, out);
    trace.sound = true;
    return trace;
}

}  // namespace ravel::test
