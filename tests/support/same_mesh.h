// Are two meshes the same in every field and every bit? For tests of files.
#pragma once

#include <algorithm>
#include <string>

#include "ravel/mesh.h"

namespace ravel::test {

inline bool same_array(const Array& a, const Array& b) {
    return a.scalar == b.scalar && a.arity == b.arity && a.bytes == b.bytes;
}

inline bool same_reference(const Reference& a, const Reference& b) {
    return a.component == b.component && a.place == b.place && a.base == b.base;
}

// Empty when they are the same, else what differs first.
inline std::string difference(const Mesh& a, const Mesh& b) {
    if (a.kind != b.kind) return "kind";
    if (a.positions.scalar != b.positions.scalar) return "type of positions";
    if (!same_array(a.positions, b.positions)) return "positions";
    if (a.corner_begin != b.corner_begin) return "corner_begin";
    if (a.corners != b.corners) return "corners";
    if (a.companions.size() != b.companions.size()) return "number of companion blocks";
    for (std::size_t i = 0; i < a.companions.size(); ++i) {
        const CompanionBlock &x = a.companions[i], &y = b.companions[i];
        if (x.vtk_type != y.vtk_type || x.nodes_per_cell != y.nodes_per_cell ||
            x.cell_count != y.cell_count || x.nodes != y.nodes || x.hosts != y.hosts)
            return "companion block " + std::to_string(i);
    }
    if (a.attributes.size() != b.attributes.size()) return "number of attributes";
    for (std::size_t i = 0; i < a.attributes.size(); ++i) {
        const Attribute &x = a.attributes[i], &y = b.attributes[i];
        if (x.name != y.name || x.place != y.place || !same_array(x.values, y.values) ||
            x.index != y.index ||
            !std::equal(x.references.begin(), x.references.end(), y.references.begin(),
                        y.references.end(), same_reference))
            return "attribute " + x.name + " / " + y.name;
    }
    const auto same_tag = [](const TagName& x, const TagName& y) {
        return x.attribute == y.attribute && x.dimension == y.dimension && x.value == y.value &&
               x.name == y.name;
    };
    if (!std::equal(a.tag_names.begin(), a.tag_names.end(), b.tag_names.begin(), b.tag_names.end(),
                    same_tag))
        return "tag names";
    const auto same_note = [](const Note& x, const Note& y) {
        return x.key == y.key && x.text == y.text;
    };
    if (!std::equal(a.notes.begin(), a.notes.end(), b.notes.begin(), b.notes.end(), same_note))
        return "notes";
    return {};
}

inline bool same_file_mesh(const Mesh& a, const Mesh& b) {
    return difference(a, b).empty();
}

}  // namespace ravel::test
