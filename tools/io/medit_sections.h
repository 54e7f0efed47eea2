// The sections of a MEDIT mesh that hold cells.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace ravel::io {

enum class MeditUse : std::uint8_t { tet, polygon, other };

struct MeditSection {
    std::string_view keyword;
    std::uint16_t vtk_type;
    std::uint32_t nodes;
    MeditUse use;
};

inline constexpr std::uint16_t kQuadraticTet = 24;
inline constexpr std::string_view kMeditDimension = "medit:dimension";  // a note; absent means 3

// The order of the nodes is VTK's: quadratic tetrahedra have the middles of the edges 01 12 20 03
// 13 23 after their corners.
inline constexpr MeditSection kMeditSections[] = {
    {"Edges", 3, 2, MeditUse::other},
    {"Triangles", 5, 3, MeditUse::polygon},
    {"Quadrilaterals", 9, 4, MeditUse::polygon},
    {"Tetrahedra", 10, 4, MeditUse::tet},
    {"Hexahedra", 12, 8, MeditUse::other},
    {"Prisms", 13, 6, MeditUse::other},
    {"Pyramids", 14, 5, MeditUse::other},
    {"EdgesP2", 21, 3, MeditUse::other},
    {"TrianglesP2", 22, 6, MeditUse::other},
    {"TetrahedraP2", kQuadraticTet, 10, MeditUse::tet},
};

// nullptr when the keyword (in any case) names no section of cells.
const MeditSection* medit_section(std::string_view keyword);

// A section about the mesh whose numbers name vertices or cells, each from 1 on in its own section.
struct MeditNames {
    std::string_view section;   // that of what is named
    std::uint32_t columns = 1;  // how many numbers of a row name something; they come first
    std::uint32_t whole = 2;    // how many are integers; reals follow
    bool corners = false;       // the second number is a corner of the cell that the first names
};

// nullopt when the numbers of a section with rows of this length name nothing whose order changes.
std::optional<MeditNames> medit_names(std::string_view keyword, std::uint32_t arity);

// A few sections are just numbers, without a count before them.
bool medit_has_count(std::string_view keyword);

}  // namespace ravel::io
