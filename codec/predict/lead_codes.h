// Which earlier vertex leads each vertex where parts repeat, on either side: `Coder` writes or
// reads flags. Of a part that several others may lead, its first vertex that is no seed tells
// which; so does one from where on the leader went another way.
#pragma once

#include <cstdint>
#include <vector>

#include "predict/leads.h"
#include "predict/residual_context.h"

namespace ravel {

template <class Coder>
class LeadCodes {
  public:
    // `leads`: for the writer, per vertex the place of its leader in its list, where that is told.
    LeadCodes(Coder& coder, std::size_t vertices, const std::vector<std::uint8_t>* leads)
        : coder_(coder), courses_(vertices), leads_(leads) {}

    // The leader of vertex v, or kNone. `known`: both sides know the vertex. False: what no encoder
    // writes.
    bool next(const Stencil& stencil, Id v, const std::vector<Point3>& values, bool known,
              Id& leader) {
        courses_.enter(stencil, v);
        if (courses_.in_seed()) {
            leader = seeds_.leader(courses_, stencil, v);
            return true;
        }
        leader = courses_.led_by(stencil, v);
        if (leader != kNone) return true;
        LeadList list(courses_, stencil, v);
        if (list.size() == 0) return true;
        std::size_t place = leads_ == nullptr || list.size() == 1 ? 0 : (*leads_)[v];
        if (list.size() > 1 && !known) place = code(list, place);
        if (place >= list.size()) return false;
        list.sort(values, place + 1);
        leader = list[place];
        courses_.lead(leader, v);
        return true;
    }
    bool in_seed() const { return courses_.in_seed(); }
    // After a seed: how far off its guess was.
    void missed(Id v, const Point3& by) { seeds_.missed(courses_, v, by); }
    // After each vertex.
    void insert(Id v) { courses_.insert(v); }

  private:
    // The first of the list, or else how many of the others are more alike.
    std::size_t code(const LeadList& list, std::size_t place) {
        const bool first =
            coder_.flag(ResidualContexts::lead.at(list.goes_on(), history_), place == 0);
        history_ = (history_ << 1 | (first ? 1u : 0u)) & 7;
        if (first) return 0;
        const std::size_t more = list.goes_on() ? 1 : 0;  // of the list before the others
        const std::size_t rank = place - more;
        std::uint32_t node = 1;
        for (int bit = 3; bit >= 0; --bit) {
            const bool yes =
                coder_.flag(ResidualContexts::lead_place.at(node), (rank >> bit & 1) != 0);
            node = node << 1 | (yes ? 1u : 0u);
        }
        return node - 16 + more;
    }

    Coder& coder_;
    Courses courses_;
    SeedLeads seeds_;
    const std::vector<std::uint8_t>* leads_;
    std::uint32_t history_ = 0;
};

}  // namespace ravel
