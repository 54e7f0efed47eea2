#include "spec/twist.h"

#include <map>
#include <stdexcept>

#include "decode/walk_driver.h"
#include "entropy/flag_encoder.h"
#include "spec/context_names.h"
#include "spec/tell_fields.h"
#include "support/file_parts.h"
#include "walk/copies.h"
#include "walk/fold_walk.h"
#include "walk/priors.h"
#include "walk/surface_walk.h"
#include "walk/tet_walk.h"

namespace ravel::test {
namespace {

struct Opened {
    Head head;
    BlockHead block;
    Bytes connectivity, positions;
    PositionFormat format;
    std::size_t bits_at = 0;
};

Opened opened(const Bytes& file) {
    Opened o;
    const auto parts = take_apart(file);
    for (const FilePart& part : *parts) {
        ByteReader in(part.raw);
        if (part.id == SectionId::head) o.head = *read_head(in);
        if (part.id == SectionId::block) o.block = *read_block_head(in, o.head.kind);
        if (part.id == SectionId::connectivity) o.connectivity = part.raw;
        if (part.id == SectionId::positions) o.positions = part.raw;
    }
    if (o.block.has_precedents) throw std::runtime_error("a walk by precedents is not twisted");
    o.format = position_format_of(o.positions, o.head, o.block, o.bits_at);
    return o;
}

std::string block_of(const std::vector<NamedBlock>& blocks, Context context) {
    const std::string name = name_of_context(blocks, context);
    return name.substr(0, name.find('('));
}

// Answers from the file up to the twist, and writes down what was answered.
class TwistDriver {
  public:
    TwistDriver(const Opened& file, const Twist& twist)
        : file_(file),
          twist_(twist),
          tets_(file.head.kind == CellKind::tet),
          in_(file.connectivity),
          position_bits_(std::span(file.positions).subspan(file.bits_at)),
          coder_{position_bits_},
          positions_(coder_, file.format, file.block.vertices + file.block.unused_points),
          copies_(file.head.kind, file.block.has_copies ? file.block.vertices : 0),
          models_(tets_ ? models_of(tet::kPriors, tet::kContexts, tet::kPriorSeen)
                        : models_of(surface::kPriors, surface::kContexts, surface::kPriorSeen)) {}

    bool flag(Context context, bool) {
        const std::string block = block_of(tets_ ? tet_blocks() : surface_blocks(), context);
        const Question question{block, asked_[block]++, *walked};
        if (const auto answer = twist_.flag ? twist_.flag(question) : std::nullopt) {
            twisted_ = true;
            return write(context, *answer);
        }
        return write(context, read(context));
    }
    std::uint64_t number(Context base, std::uint64_t) {
        const std::string block = block_of(tets_ ? tet_blocks() : surface_blocks(), base);
        const Question question{block, asked_[block]++, *walked};
        const auto answer = twist_.number ? twist_.number(question) : std::nullopt;
        if (answer) {
            twisted_ = true;
            const int n = static_cast<int>(std::bit_width(*answer + 1));
            for (int i = 1; i < n; ++i) write(base + static_cast<Context>(i) - 1, true);
            write(base + static_cast<Context>(n) - 1, false);
            out_.plain(*answer + 1, n - 1);
            return *answer;
        }
        Context n = 1;
        while (n < 64 && write(base + n - 1, read(base + n - 1))) ++n;
        const std::uint64_t low = twisted_ ? 0 : in_.plain(static_cast<int>(n) - 1);
        out_.plain(low, static_cast<int>(n) - 1);
        return (std::uint64_t{1} << (n - 1) | low) - 1;
    }
    bool failed() const { return bad_; }

    void begin_cell(Id) {}
    void new_vertex(Id v, Id, const Stencil& stencil) {
        const Id of = file_.block.has_copies ? copies_.next(*this, v, stencil, kNone) : kNone;
        if (of == v) {
            bad_ = true;
        } else if (of != kNone) {
            positions_.copy(of);
        } else {
            bad_ = !positions_.next(stencil, {}) || bad_;
        }
        if (!bad_)
            places_.push_back(place_of(positions_.format(), positions_.values().back()));
        else
            places_.push_back({});
    }
    const Point3& place(Id v) const { return places_[v]; }
    void end_cell(Id) {
        if (file_.block.has_flips)
            last_flip_ = flag((tets_ ? tet::kFlip : surface::kFlip).at(last_flip_), false);
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

    Bytes codes() const { return out_.finish(); }
    bool twisted() const { return twisted_; }

    const Walked* walked = nullptr;

  private:
    bool read(Context context) {
        FlagModel model = models_[context];
        return twisted_ ? model.likely() : in_.flag(model);
    }
    bool write(Context context, bool yes) {
        out_.flag(models_[context], yes);
        return yes;
    }

    const Opened& file_;
    const Twist& twist_;
    const bool tets_;
    FlagDecoder in_, position_bits_;
    ReadingCoder coder_;
    PositionCodes<ReadingCoder> positions_;
    Copies copies_;
    std::vector<FlagModel> models_;
    FlagEncoder out_;
    std::map<std::string, int> asked_;
    std::vector<Point3> places_;
    bool last_flip_ = false, bad_ = false, twisted_ = false;
};

template <class Walk>
bool goes_through(TwistDriver& driver, const WalkLimits& limits) {
    Walk walk(driver, limits);
    driver.walked = &walk.walked();
    return walk.run();
}

struct ForcingCoder {
    static constexpr bool kWrites = true;
    const std::vector<std::pair<std::string, bool>>& forced;
    FlagEncoder out;
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen));

    bool flag(Context context, bool truth) {
        const std::string block = block_of(position_blocks(), context);
        for (const auto& [name, answer] : forced)
            if (name == block) truth = answer;
        out.flag(models[context], truth);
        return truth;
    }
    double cost(Context context, bool truth) const { return models[context].cost(truth); }
    std::uint64_t plain(std::uint64_t truth, int count) {
        out.plain(truth, count);
        return count == 0 ? 0 : truth & (~std::uint64_t{0} >> (64 - count));
    }
    std::uint64_t rice(std::uint64_t truth, int count) {
        out.rice(truth, count);
        return truth;
    }
};

}  // namespace

Bytes with_twisted_walk(const Bytes& file, const Twist& twist) {
    const Opened o = opened(file);
    TwistDriver driver(o, twist);
    WalkLimits limits;
    limits.cells = static_cast<Id>(o.block.cells);
    limits.corners = static_cast<Id>(o.block.corners);
    limits.vertices = static_cast<Id>(o.block.vertices);
    limits.uniform_degree = static_cast<Id>(o.block.uniform_degree);
    limits.has_border = o.block.has_border;
    limits.grid_side = static_cast<double>(o.block.grid_side);
    limits.grid_count = o.block.grid_count;
    limits.shape_step = static_cast<double>(o.block.shape_step);
    limits.mirrored = o.block.mirrored;
    limits.leaders_move = o.block.leaders_move;
    limits.plausible = 1 << 20;
    if (o.block.by_folds               ? goes_through<FoldWalk<TwistDriver>>(driver, limits)
        : o.head.kind == CellKind::tet ? goes_through<TetWalk<TwistDriver>>(driver, limits)
                                       : goes_through<SurfaceWalk<TwistDriver>>(driver, limits))
        throw std::runtime_error("a twisted walk goes through");
    if (!driver.twisted()) throw std::runtime_error("a walk that was not twisted fails");
    return with_section(file, SectionId::connectivity, [&](Bytes& raw) { raw = driver.codes(); });
}

Bytes with_positions(const Bytes& file, const Positions& positions) {
    Opened o = opened(file);
    Bytes section(o.positions.begin(),
                  o.positions.begin() + static_cast<std::ptrdiff_t>(o.bits_at));
    if (positions.change) positions.change(section);
    if (o.block.has_precedents) throw std::runtime_error("a walk by precedents is not twisted");
    o.format = position_format_of(section, o.head, o.block, o.bits_at);
    ForcingCoder coder{positions.forced, {}};
    PositionCodes<ForcingCoder> codes(coder, o.format, o.block.vertices + o.block.unused_points);
    bool sane = true;
    for (Id v = 0; sane && v < positions.truth.size(); ++v) {
        Stencil stencil;
        for (Id k = 0; k < 3 && k < v; ++k) stencil.at[k] = v - 1 - k;
        stencil.variant = static_cast<std::uint8_t>(std::min<Id>(v % 4, 2));
        if (v % 4 == 3) stencil = stencil_of(Configuration::quad_fourth, {v - 3, v - 1, v - 2});
        sane = codes.next(stencil, positions.truth[v]);
    }
    if (sane) throw std::runtime_error("positions without fault");
    const Bytes bits = coder.out.finish();
    section.insert(section.end(), bits.begin(), bits.end());
    return with_section(file, SectionId::positions, [&](Bytes& raw) { raw = section; });
}

}  // namespace ravel::test
