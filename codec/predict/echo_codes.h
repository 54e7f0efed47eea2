// Vertices that stand where an earlier one stood, once mirrored or moved. The earlier vertex is
// looked for beside those that the neighbours echo, or else near the place from which the guess
// would have come, and one flag says whether the new one is told by it. On either side: `Coder`
// writes or reads flags.
#pragma once

#include <algorithm>
#include <vector>

#include "predict/echo_partners.h"
#include "predict/position_format.h"
#include "predict/residual_context.h"
#include "predict/vertex_index.h"

namespace ravel {

template <class Coder>
class EchoCodes {
  public:
    EchoCodes(Coder& coder, const PositionFormat& format, std::size_t vertices)
        : coder_(coder), format_(format), index_(format.cube_bits, vertices) {}

    void reserve(std::size_t vertices) {
        index_.reserve(vertices);
        partners_.reserve(vertices);
    }
    // Once per vertex: where it stands, or that an earlier one stands there.
    void insert(const Point3& value) { index_.insert(value); }
    void skip() { index_.skip(); }
    // Before that: which vertex it echoes, if any (see EchoPartners).
    void add_partner(const Stencil* stencil, Id partner = kNone) {
        partners_.add(stencil, partner, last_);
    }

    // What the vertex beside the partners of the neighbours says of the new one, or, where that
    // lies far off or there is none, the nearest one that an echo leads to, if there is any.
    Earlier find(const Stencil& stencil, const Point3& guess, const std::vector<Point3>& values,
                 const std::vector<Point3>& exact) {
        const EchoPartners::Near tied = partners_.nearest(stencil, guess, format_.echoes, values);
        times_ = tied.times;
        Earlier found;
        if (tied.vertex == kNone || !(tied.distance < index_.side() / 4))
            found = find_by_place(guess, values);
        if (tied.vertex != kNone) {
            if (found.vertex != kNone && found.distance < tied.distance / 8) {
                times_ = 0;
            } else {
                found.vertex = tied.vertex;
                found.distance = tied.distance;
                found.echo = tied.echo;
            }
        }
        if (found.vertex != kNone) carry_over(found, values[found.vertex], exact);
        return found;
    }
    // Is the vertex told by what was found? `better`: the writer's answer.
    bool is_told(const Earlier& found, bool better) {
        const bool told = coder_.flag(context_of(found), better);
        history_ = (history_ << 1 | (told ? 1u : 0u)) & 7;
        if (told) last_ = found.echo;
        return told;
    }
    // What that flag takes beyond what it takes to say no, for a writer.
    double price(const Earlier& found) const {
        const Context context = context_of(found);
        return coder_.cost(context, true) - coder_.cost(context, false);
    }
    // After each look, whether anything was found or not.
    void looked(bool told) { without_ = told ? 0 : without_ + 1; }

    // Does it stand where the earlier one stands?
    bool stays(const Earlier& found) const { return format_.echoes[found.echo] == Echo{}; }

  private:
    // Vertices without an echo until the echoes are looked at in turn, and less and less often.
    static constexpr std::uint64_t kPatience = 8, kWeary = 64, kWearier = 256;

    // The echo that served last is enough while it leads close by; after a while without any the
    // others are looked at in turn, one a vertex; then nothing is looked at but at one vertex in
    // two, and at last in eight.
    Earlier find_by_place(const Point3& guess, const std::vector<Point3>& values) const {
        Earlier found;
        const std::uint64_t stride = without_ < kWeary ? 1 : without_ < kWearier ? 2 : 8;
        if (values.size() % stride != 0) return found;
        const auto look = [&](std::size_t e) {
            const auto near = index_.nearest(format_.echoes[e].back(guess), values);
            if (near.vertex == kNone || (found.vertex != kNone && near.distance >= found.distance))
                return;
            found.vertex = near.vertex;
            found.distance = near.distance;
            found.echo = e;
        };
        look(last_);
        const bool close = found.vertex != kNone &&
                           found.distance < index_.side() / ((history_ & 1) != 0 ? 4 : 16);
        const std::size_t count = format_.echoes.size();
        const std::size_t turn = values.size() / stride % count;
        for (std::size_t e = 0; e < count && !close; ++e)
            if (e != last_ && (without_ < kPatience || e == turn)) look(e);
        return found;
    }
    Context context_of(const Earlier& found) const {
        return ResidualContexts::echo.at(width_of(found.distance), history_, times_);
    }

    void carry_over(Earlier& found, const Point3& value, const std::vector<Point3>& exact) const {
        const Echo& echo = format_.echoes[found.echo];
        const std::int64_t most = format_.most();
        found.copies = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto whole = static_cast<std::int64_t>(value[k]);
            const auto offset = static_cast<double>(echo.offset[k]);
            found.whole[k] = std::clamp(
                echo.mirrored[k] ? echo.offset[k] - whole : echo.offset[k] + whole, -most, most);
            if (offset == 0)
                found.value[k] = echo.mirrored[k] ? mirrored(value[k]) : value[k];
            else
                found.value[k] = echo.mirrored[k] ? offset - value[k] : offset + value[k];
            if (!format_.keeps_exact()) continue;
            const double x = exact[found.vertex][k];
            found.exact[k] = echo.mirrored[k] ? mirrored(x) : x;
        }
    }
    double mirrored(double x) const { return x == 0 && !format_.numbers.has_minus_zero ? 0 : -x; }

    Coder& coder_;
    const PositionFormat& format_;
    VertexIndex index_;
    EchoPartners partners_;
    std::size_t last_ = 0;  // the echo that told a vertex last
    std::uint64_t without_ = 0;
    std::uint32_t history_ = 0;  // the last three answers
    std::uint32_t times_ = 0;    // how many partners what was found is tied to
};

}  // namespace ravel
