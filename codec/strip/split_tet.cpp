// The split of two tets at a shared face [DiazGopi2005, 3.3]: a new vertex m at the face's
// centroid; each tet becomes three, P_x for each other facet x, with corner x replaced by m. P_x
// and P_y share the facet that holds m, the apex and the third corner z; the strip uses two of
// these three facets, so of the three vertices of the shared face one serves both tets: there the
// strips are toggled.
// Cost: constant.
#include <array>

#include "strip/split.h"

namespace ravel {
namespace {

// A tet seen from the shared face: its corners are facets and corners at once.
struct Side {
    Id link = kNone;              // facet, and apex corner
    std::array<Id, 3> corner{};   // of the shared face, in the same order in both tets
    std::array<bool, 3> strip{};  // the facet opposite that corner is on the strip
    std::array<Id, 3> piece{};    // first facet of P_x

    int strips() const { return strip[0] + strip[1] + strip[2]; }
    // The facet at vertex z can be used by the strip's route through the pieces.
    bool allows(std::size_t z) const { return strips() < 2 || strip[z]; }
    // The vertex whose facet the route leaves out; 3 for the ring of a singleton.
    std::size_t left_out(std::size_t toggled) const {
        if (strips() == 0) return 3;
        for (std::size_t r = 0; r < 3; ++r)
            if (!strip[r] && r != toggled) return r;
        return 3;
    }
};

Side look(const SplitMesh& mesh, Id link) {
    Side side;
    side.link = link;
    std::size_t n = 0;
    for (Id c = mesh.first[mesh.cell_of[link]]; c < mesh.first[mesh.cell_of[link] + 1]; ++c)
        if (c != link) side.corner[n++] = c;
    return side;
}

void split(SplitMesh& mesh, Side& side, Id centre) {
    const Id cell = mesh.cell_of[side.link], base = mesh.first[cell];
    for (std::size_t x = 0; x < 3; ++x) {
        std::array<Id, 4> vertices{};
        for (Id i = 0; i < 4; ++i)
            vertices[i] = base + i == side.corner[x] ? centre : mesh.vertex[base + i];
        side.piece[x] = mesh.first[add_cell(mesh, vertices, mesh.parent[cell])];
        take_over(mesh, side.corner[x], side.piece[x] + (side.corner[x] - base));
    }
    for (std::size_t x = 0; x < 3; ++x)
        for (std::size_t y = x + 1; y < 3; ++y)
            glue(mesh, side.piece[x] + (side.corner[y] - base),
                 side.piece[y] + (side.corner[x] - base));
}

}  // namespace

bool split_tets(SplitMesh& mesh, Id link) {
    Side a = look(mesh, link), b = look(mesh, mesh.twin[link]);
    const std::array<Id, 3> unordered = b.corner;
    for (std::size_t x = 0; x < 3; ++x)
        for (const Id corner : unordered)
            if (mesh.vertex[corner] == mesh.vertex[a.corner[x]]) b.corner[x] = corner;
    for (Side* side : {&a, &b})
        for (std::size_t x = 0; x < 3; ++x)
            side->strip[x] = mesh.role[side->corner[x]] == FacetRole::strip;
    std::size_t z = 0;
    while (z < 2 && !(a.allows(z) && b.allows(z))) ++z;

    const std::array<Blend, 3> parts{{{mesh.vertex[a.corner[0]], 1.0 / 3},
                                      {mesh.vertex[a.corner[1]], 1.0 / 3},
                                      {mesh.vertex[a.corner[2]], 1.0 / 3}}};
    const Id centre = add_vertex(mesh, parts);
    for (Side* side : {&a, &b}) {
        const Id base = mesh.first[mesh.cell_of[side->link]];
        const std::size_t out = side->left_out(z);
        split(mesh, *side, centre);
        for (std::size_t v = 0; v < 3; ++v) {
            if (v == z || v == out) continue;
            const std::size_t x = (v + 1) % 3, y = (v + 2) % 3;
            set_role(mesh, side->piece[x] + (side->corner[y] - base), FacetRole::strip);
        }
    }
    const Id apex_a = a.link & 3, apex_b = b.link & 3;
    for (std::size_t x = 0; x < 3; ++x) {
        glue(mesh, a.piece[x] + apex_a, b.piece[x] + apex_b);
        if (x != z) set_role(mesh, a.piece[x] + apex_a, FacetRole::strip);
    }
    return true;
}

}  // namespace ravel
