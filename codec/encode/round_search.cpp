#include "encode/round_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "encode/linear_system.h"
#include "encode/round_fit.h"

namespace ravel {
namespace {

using Triangle = std::array<Id, 3>;

// Triangles of the border that the walk met beside its gates, and those at each vertex.
struct Border {
    std::vector<Triangle> triangles;
    std::vector<std::size_t> first;  // per vertex
    std::vector<std::size_t> of;
    std::vector<Id> vertices;
    std::vector<Id> some;    // of them, one in
    std::size_t stride = 1;  // so many
    double size = 0;         // of their box
};

Border border_of(const WalkRecord& record, const std::vector<Point3>& places,
                 const std::vector<bool>& skip) {
    Border border;
    for (const Stencil& s : record.stencils)
        for (std::size_t e = 0; e < 3; ++e) {
            if ((s.borders >> e & 1) == 0) continue;
            const Triangle t{s.at[(e + 1) % 3], s.at[(e + 2) % 3], s.at[4 + e]};
            if (!skip[t[0]] && !skip[t[1]] && !skip[t[2]]) border.triangles.push_back(t);
        }
    border.first.assign(places.size() + 1, 0);
    for (const Triangle& t : border.triangles)
        for (const Id v : t) ++border.first[v + 1];
    Point3 low{}, high{};
    for (std::size_t v = 0; v < places.size(); ++v) {
        if (border.first[v + 1] > 0) {
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = border.vertices.empty() ? places[v][k] : std::min(low[k], places[v][k]);
                high[k] = border.vertices.empty() ? places[v][k] : std::max(high[k], places[v][k]);
            }
            border.vertices.push_back(static_cast<Id>(v));
        }
        border.first[v + 1] += border.first[v];
    }
    border.size = length(minus(high, low));
    constexpr std::size_t kSome = 2048;
    border.stride = border.vertices.size() / kSome + 1;
    for (std::size_t i = 0; i < border.vertices.size(); i += border.stride)
        border.some.push_back(border.vertices[i]);
    border.of.resize(3 * border.triangles.size());
    std::vector<std::size_t> next = border.first;
    for (std::size_t t = 0; t < border.triangles.size(); ++t)
        for (const Id v : border.triangles[t]) border.of[next[v]++] = t;
    return border;
}

struct Found {
    RoundFace face;
    std::size_t vertices = 0;  // that no face before has
};

class Search {
  public:
    Search(const Border& border, const std::vector<Point3>& places)
        : border_(border),
          places_(places),
          near_(std::max(1.0, std::ldexp(border.size, -15))),
          taken_(places.size(), false),
          met_(places.size(), false) {}

    std::vector<Found> run() {
        std::vector<Found> found;
        std::uint64_t random = 1;
        for (std::size_t seed = 0; seed < kSeeds; ++seed) {
            if (seed == kHopeless && found.empty()) break;
            random = random * 6364136223846793005u + 1442695040888963407u;
            const Triangle& start = border_.triangles[(random >> 33) % border_.triangles.size()];
            if (taken_[start[0]] && taken_[start[1]] && taken_[start[2]]) continue;
            Found best;
            for (const std::size_t vertices : {std::size_t{12}, kOfTorus})
                try_patch(start, vertices, best);
            if (!is_worth(best)) continue;
            const RoundShape shape = shape_of(best.face);
            for (const Id v : border_.vertices)
                if (holds(shape, places_[v])) taken_[v] = true;
            found.push_back(best);
        }
        return found;
    }

    // Of what lies on a face, nineteen in twenty lie less than 2^slack units off.
    int slack_of(const RoundFace& face) const {
        const RoundShape shape = shape_of(face);
        std::vector<double> off;
        for (const Id v : border_.some)
            if (holds(shape, places_[v]))
                off.push_back(std::abs(outside_of(shape, places_[v]).distance));
        if (off.empty()) return 0;
        const auto most = off.begin() + static_cast<std::ptrdiff_t>(off.size() * 19 / 20);
        std::nth_element(off.begin(), most, off.end());
        int bits = 0;
        std::frexp(*most, &bits);
        return std::clamp(bits, 0, kMostRoundSlack);
    }

  private:
    static constexpr std::size_t kSeeds = 48, kHopeless = 16, kOfTorus = 40;

    bool holds(const RoundShape& shape, const Point3& p) const {
        return std::abs(outside_of(shape, p).distance) < near_;
    }

    // About so many vertices around a triangle, about their mean; none if they lie in a plane.
    Patch patch_around(const Triangle& start, std::size_t vertices, Point3& mean) {
        std::vector<Id> reached(start.begin(), start.end());
        std::vector<std::size_t> triangles;
        for (const Id v : reached) met_[v] = true;
        for (std::size_t i = 0; i < reached.size() && reached.size() < vertices; ++i)
            for (std::size_t k = border_.first[reached[i]]; k < border_.first[reached[i] + 1];
                 ++k) {
                triangles.push_back(border_.of[k]);
                for (const Id v : border_.triangles[border_.of[k]])
                    if (!met_[v]) {
                        met_[v] = true;
                        reached.push_back(v);
                    }
            }
        for (const Id v : reached) met_[v] = false;
        std::sort(triangles.begin(), triangles.end());
        triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
        mean = {};
        for (const Id v : reached)
            for (std::size_t k = 0; k < 3; ++k)
                mean[k] += places_[v][k] / static_cast<double>(reached.size());
        Patch patch;
        Rows<3> spread{};
        for (const Id v : reached) {
            patch.points.push_back(minus(places_[v], mean));
            patch.size = std::max(patch.size, length(patch.points.back()));
            add_square(spread, patch.points.back());
        }
        const double flat = near_ * near_ * static_cast<double>(reached.size());
        if (reached.size() < kFewest || least_eigen(spread).value < flat) return {};
        for (const std::size_t t : triangles) {
            std::array<Point3, 3> p;
            for (std::size_t i = 0; i < 3; ++i)
                p[i] = minus(places_[border_.triangles[t][i]], mean);
            Point3 normal = cross(minus(p[1], p[0]), minus(p[2], p[0])), middle{};
            const double area = length(normal);
            if (!(area > 0)) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                normal[k] /= area;
                middle[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
            }
            patch.facets.push_back({middle, normal});
        }
        return patch;
    }

    void try_patch(const Triangle& start, std::size_t vertices, Found& best) {
        Point3 mean;
        const Patch patch = patch_around(start, vertices, mean);
        if (patch.points.empty()) return;
        for (RoundShape shape : rounds_near(patch)) {
            // Twelve points do not tell a torus.
            if (shape.kind == RoundKind::torus && vertices < kOfTorus) continue;
            if (!(refine(shape, patch.points, patch.size, 3) < 64 * near_) ||
                !(refine(shape, patch.points, patch.size, 16) < near_) ||
                !(shape.radius > 0 && shape.ring >= 0) || !spread_out(shape, mean, patch))
                continue;
            const Found found = rounded(shape, mean);
            // What is simpler is surer.
            if (found.vertices > best.vertices + best.vertices / 16) best = found;
        }
    }

    // Refits the shape to what lies on it while that becomes more. No: it is not much.
    bool spread_out(RoundShape& shape, const Point3& mean, const Patch& patch) const {
        constexpr int kRounds = 8;
        constexpr std::size_t kPoints = 256;
        std::size_t before = 0;
        double size = patch.size;
        for (int round = 0; round < kRounds; ++round) {
            const double reach = round < 3 ? 4 * near_ : near_;
            std::vector<Point3> on;
            for (const Id v : border_.some) {
                const Point3 p = minus(places_[v], mean);
                if (std::abs(outside_of(shape, p).distance) < reach) on.push_back(p);
            }
            // A piece that is round by chance has little beside it.
            if (on.size() < kFewest || on.size() * border_.stride < 2 * patch.points.size())
                return false;
            if (round > 3 && on.size() <= before) return true;
            before = on.size();
            const std::size_t stride = on.size() / kPoints + 1;
            std::vector<Point3> some;
            for (std::size_t i = 0; i < on.size(); i += stride) some.push_back(on[i]);
            for (const Point3& p : some) size = std::max(size, length(p));
            refine(shape, some, size, 8);
        }
        return true;
    }

    // As it is stored; no vertices if it can't be.
    Found rounded(const RoundShape& shape, const Point3& mean) const {
        Found found;
        const auto sixteenths = [](double x, std::int64_t& to) {
            const double y = std::nearbyint(16 * x);
            if (!(std::abs(y) < static_cast<double>(kMostRoundLength))) return false;
            to = static_cast<std::int64_t>(y);
            return true;
        };
        found.face.kind = shape.kind;
        bool fits = shape.radius > 0 && shape.ring >= 0 &&
                    sixteenths(shape.radius, found.face.radius) &&
                    sixteenths(shape.ring, found.face.ring);
        for (std::size_t k = 0; k < 3; ++k)
            fits = fits && sixteenths(shape.centre[k] + mean[k], found.face.centre[k]);
        if (!fits || found.face.radius == 0) return {};
        if (shape.kind != RoundKind::sphere) {
            if (!(length(shape.axis) > 0.5)) return {};
            found.face.axis = whole_axis(shape.axis);
        }
        const RoundShape stored = shape_of(found.face);
        for (const Id v : border_.some)
            if (!taken_[v] && holds(stored, places_[v])) found.vertices += border_.stride;
        return found;
    }

    // As long as is fine enough for the border's size; 1 if it goes along a coordinate axis.
    std::array<std::int64_t, 3> whole_axis(const Point3& axis) const {
        std::size_t most = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (std::abs(axis[k]) > std::abs(axis[most])) most = k;
        int bits = 0;
        std::frexp(border_.size / near_, &bits);
        const double scale = std::ldexp(1.0, std::clamp(bits + 3, 3, 50)) / axis[most];
        std::array<std::int64_t, 3> whole{};
        bool straight = true;
        for (std::size_t k = 0; k < 3; ++k) {
            whole[k] = static_cast<std::int64_t>(std::nearbyint(axis[k] * scale));
            straight = straight && (k == most || std::abs(axis[k]) * border_.size < near_ / 2);
        }
        if (straight) {
            whole = {};
            whole[most] = 1;
        }
        return whole;
    }

    // Are the bits that the face saves more than those it takes? How far a triangle's plane is off
    // a face at the next vertex is told by the radius and by how long its sides are.
    bool is_worth(const Found& found) const {
        if (found.vertices < kFewest) return false;
        const RoundShape shape = shape_of(found.face);
        double sides = 0, count = 0;
        for (const Triangle& t : border_.triangles) {
            if (!holds(shape, places_[t[0]]) || !holds(shape, places_[t[1]])) continue;
            const Point3 side = minus(places_[t[0]], places_[t[1]]);
            sides += dot(side, side);
            ++count;
        }
        if (count == 0) return false;
        const double off = std::min(sides / count / (2 * shape.radius) / near_, 0x1p60);
        const std::size_t saved = std::bit_width(static_cast<std::uint64_t>(off));
        // Of the vertices on it about half are told by it.
        return saved * found.vertices > 2 * kFaceBits;
    }

    static constexpr std::size_t kFewest = 10;     // points that no shape goes through by chance
    static constexpr std::size_t kFaceBits = 160;  // about what storing one takes
    const Border& border_;
    const std::vector<Point3>& places_;
    const double near_;
    std::vector<bool> taken_, met_;
};

}  // namespace

RoundFaceList find_round_faces(const WalkRecord& record, const std::vector<Point3>& places,
                               const std::vector<bool>& skip) {
    const Border border = border_of(record, places, skip);
    if (border.triangles.empty()) return {};
    Search search(border, places);
    std::vector<Found> found = search.run();
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.vertices > b.vertices; });
    RoundFaceList rounds;
    for (std::size_t i = 0; i < std::min(found.size(), kMostRoundFaces); ++i) {
        rounds.face[rounds.count++] = found[i].face;
        rounds.slack = std::max(rounds.slack, search.slack_of(found[i].face));
    }
    return rounds;
}

}  // namespace ravel
