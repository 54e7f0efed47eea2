// Whom vertices echo. The neighbours of a new vertex had partners beside the one it may echo, so
// that is looked for among those tied to them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/point3.h"
#include "mesh/stencil.h"
#include "mesh/ties.h"
#include "predict/echoes.h"

namespace ravel {

class EchoPartners {
  public:
    void reserve(std::size_t vertices) {
        partner_.reserve(vertices);
        is_taken_.reserve(vertices);
        ties_.reserve(vertices);
    }
    // After each vertex: which one it echoes, if any. `stencil`: none of one that was not guessed.
    void add(const Stencil* stencil, Id partner, std::size_t echo) {
        const auto v = static_cast<Id>(partner_.size());
        partner_.push_back({partner, static_cast<std::uint32_t>(echo)});
        is_taken_.push_back(0);
        if (partner != kNone) is_taken_[partner] = 1;
        ties_.add_vertex();
        if (stencil == nullptr || stencil->configuration == Configuration::edge) return;
        for (const Id n : neighbours_of(*stencil))
            if (n != kNone) ties_.tie(v, n);
    }

    struct Near {
        Id vertex = kNone;
        double distance = 0;      // the sum over the axes
        std::uint32_t times = 0;  // how many partners it is tied to
        std::size_t echo = 0;
    };
    // Of those that are tied to most partners of the neighbours, that are none themselves and that
    // no vertex has echoed yet: the nearest to where the echo of the first partner has the guess.
    Near nearest(const Stencil& stencil, const Point3& guess, const std::vector<Echo>& echoes,
                 const std::vector<Point3>& values) const {
        std::array<Id, 2> partners{kNone, kNone};
        std::size_t count = 0;
        Near best;
        for (const Id n : neighbours_of(stencil)) {
            if (n == kNone || partner_[n].vertex == kNone) continue;
            if (count == 0) best.echo = partner_[n].echo;
            if (partner_[n].echo == best.echo) partners[count++] = partner_[n].vertex;
        }
        if (count == 0) return best;
        const Point3 p = echoes[best.echo].back(guess);
        std::array<Id, 2 * kLooked> found;
        std::size_t firsts = 0;  // found by the first partner
        for (std::size_t i = 0; i < count; ++i)
            ties_.each(partners[i], kLooked, [&](Id v) {
                if (is_taken_[v] != 0 || v == partners[0] || v == partners[1]) return;
                std::uint32_t times = 1;
                if (i == 0) found[firsts++] = v;
                for (std::size_t k = 0; i == 1 && k < firsts; ++k) times += found[k] == v;
                if (times < best.times) return;
                const Point3& q = values[v];
                const double d =
                    std::abs(q[0] - p[0]) + std::abs(q[1] - p[1]) + std::abs(q[2] - p[2]);
                if (times > best.times || d < best.distance) best = {v, d, times, best.echo};
            });
        return best;
    }

  private:
    static constexpr std::size_t kLooked = 8;  // ties of a partner

    struct Partner {
        Id vertex;
        std::uint32_t echo;
    };
    std::vector<Partner> partner_;
    std::vector<std::uint8_t> is_taken_;
    Ties ties_;
};

}  // namespace ravel
