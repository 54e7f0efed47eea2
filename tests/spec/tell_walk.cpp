// The streams are read by a plain reader of bits that follows chapter 4 of spec/format.md to the
// letter; walks and predictors are those of codec/.
#include "spec/tell_walk.h"

#include <optional>

#include "base/rice_code.h"
#include "entropy/flag_model.h"
#include "entropy/priors.h"
#include "predict/edge_points.h"
#include "predict/priors.h"
#include "predict/residual_models.h"
#include "spec/context_names.h"
#include "spec/tell_fields.h"
#include "walk/copies.h"
#include "walk/fold_walk.h"
#include "walk/precedents.h"
#include "walk/priors.h"
#include "walk/surface_walk.h"
#include "walk/tet_walk.h"

namespace ravel::test {
namespace {

std::string id_text(Id id) {
    return id == kNone ? "-" : std::to_string(id);
}

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

    std::vector<FlagModel>& models() { return models_; }
    bool flag(const FlagModel& asked) {
        return flag(static_cast<Context>(&asked - models_.data()));
    }
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
        const std::uint64_t value = bits(count);
        if (count > 0)
            telling_.flag("    " + std::string(1, letter_) + " plain(" + std::to_string(count) +
                          ")  " + bits_ + "  " + std::to_string(value));
        return value;
    }
    std::uint64_t rice(int count) {
        bits_.clear();
        const int rest = count;
        std::uint64_t zeros = 0;
        while (zeros < kRiceEscape && bit() == 0) ++zeros;
        std::uint64_t value = zeros << count;
        if (zeros == kRiceEscape) count = static_cast<int>(bits(6));
        value += bits(count);
        telling_.flag("    " + std::string(1, letter_) + " rice(" + std::to_string(rest) + ")  " +
                      bits_ + "  " + std::to_string(value));
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
    std::uint64_t bits(int count) {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) value = value << 1 | bit();
        return value;
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
    std::uint64_t rice(std::uint64_t, int count) { return in.rice(count); }
};

constexpr const char* kConfigurationName[] = {
    "seed",    "quad_third", "quad_fourth", "quad_corner", "triangle",
    "polygon", "tet",        "border",      "led",         "edge"};

class TraceDriver {
  public:
    TraceDriver(Stream& codes, PositionCodes<TraceCoder>& positions, const BlockHead& block,
                bool tets, Telling& telling)
        : codes_(codes),
          positions_(positions),
          block_(block),
          tets_(tets),
          telling_(telling),
          copies_(tets ? CellKind::tet : CellKind::polygon, block.has_copies ? block.vertices : 0) {
        if (block.has_precedents) precedents_.emplace(block.cells, block.corners);
    }

    bool flag(Context context, bool) {
        if (!precedents_) return codes_.flag(context);
        return precedents_->flag(codes_.models(), context, false,
                                 [&](FlagModel& model, bool) { return codes_.flag(model); });
    }
    std::uint64_t number(Context base, std::uint64_t) {
        int n = 1;
        while (n < 64 && flag(base + static_cast<Context>(n) - 1, false)) ++n;
        return (std::uint64_t{1} << (n - 1) | codes_.plain(n - 1)) - 1;
    }
    bool failed() const { return bad_ || codes_.exhausted(); }

    void begin_cell(Id gate) {
        if (precedents_) precedents_->begin_cell(gate == kNone);
        telling_.cell("cell " + std::to_string(cells_++) +
                      (gate == kNone ? ": seed" : ": gate " + id_text(gate)) + "\n");
    }
    void new_vertex(Id v, Id, const Stencil& stencil) {
        const Id of = block_.has_copies ? copies_.next(*this, v, stencil, kNone) : kNone;
        bad_ = bad_ || of == v;
        if (bad_) return;
        points_.push_back(of == kNone ? static_cast<Id>(own_.size()) : points_[of]);
        if (of == kNone) own_.push_back(v);
        if (of != kNone)
            positions_.copy(of);
        else
            bad_ = !positions_.next(stencil, {});
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
        text += "]";
        for (std::size_t e = 0; e < 3; ++e)
            if (stencil.borders >> e & 1) text += ", border " + std::to_string(e);
        text += ", value";
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
        if (!tets_) return;
        std::array<Index, 4> corners{};
        for (Id i = 0; i < 4; ++i) corners[i] = points_[walked->vertex[walked->begin(cell) + i]];
        if (last_flip_) std::swap(corners[2], corners[3]);
        corners_.insert(corners_.end(), corners.begin(), corners.end());
    }
    EdgePoints edges() const {
        return block_.has_edge_points ? edge_points_of(corners_, own_) : EdgePoints{};
    }

    Id degree() const { return 0; }
    bool zips(Id) const { return false; }
    bool is_new(Id) const { return false; }
    Id gap(Id, bool&) const { return kNone; }
    bool apex_is(Id) const { return false; }
    Id apex() const { return kNone; }
    bool is_new_near(const Point3&, double) const { return false; }
    bool glues(Id) const { return false; }
    bool meets(Id) const { return true; }
    bool border(Id) const { return false; }

    const Walked* walked = nullptr;

  private:
    Stream& codes_;
    PositionCodes<TraceCoder>& positions_;
    const BlockHead& block_;
    const bool tets_;
    Telling& telling_;
    std::vector<Point3> places_;
    std::vector<Id> points_, own_;  // per vertex; per point
    std::vector<Index> corners_;    // of tets, points
    Copies copies_;
    std::optional<Precedents> precedents_;
    std::uint64_t cells_ = 0;
    bool last_flip_ = false, bad_ = false;
};

template <class Walk>
bool run(TraceDriver& driver, const WalkLimits& limits) {
    Walk walk(driver, limits);
    driver.walked = &walk.walked();
    return walk.run() && !driver.failed();
}

}  // namespace

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
    Stream bits(
        position_bits, 'p', "positions", position_blocks(),
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen)),
        telling);
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
    limits.leaders_move = block.leaders_move;
    limits.shape_step = static_cast<double>(block.shape_step);
    limits.plausible = 1 << 20;
    TraceDriver driver(codes, positions, block, tets, telling);
    if (!(!tets            ? run<SurfaceWalk<TraceDriver>>(driver, limits)
          : block.by_folds ? run<FoldWalk<TraceDriver>>(driver, limits)
                           : run<TetWalk<TraceDriver>>(driver, limits)))
        return "the walk fails";
    const EdgePoints edges = driver.edges();
    for (Index i = 0; i < block.unused_points; ++i) {
        const Index v = block.vertices + i;
        const Stencil stencil = stencil_of_unused(edges, i, block.vertices);
        if (!positions.next(stencil, {})) return "an unused point fails";
        driver.tell_vertex(static_cast<Id>(v), stencil, kNone);
    }
    return codes.finished() && bits.finished() ? "" : "the streams are not at their end";
}

}  // namespace ravel::test
