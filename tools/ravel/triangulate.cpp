#include "ravel/triangulate.h"

#include <cstring>

namespace ravel::tool {
namespace {

// The attribute of new elements, each of which takes the value of the old element it names.
Attribute regather(const Attribute& old, const std::vector<Index>& source) {
    Attribute gathered{old.name, old.place, {}, {}, old.references};
    if (!old.index.empty()) {
        gathered.values = old.values;
        gathered.index.reserve(source.size());
        for (Index i : source) gathered.index.push_back(old.index[i]);
        return gathered;
    }
    gathered.values = make_array(old.values.scalar, old.values.arity, source.size());
    const std::size_t stride = old.values.stride();
    for (std::size_t i = 0; i < source.size(); ++i)
        std::memcpy(gathered.values.bytes.data() + i * stride,
                    old.values.bytes.data() + source[i] * stride, stride);
    return gathered;
}

}  // namespace

Mesh triangulate(const Mesh& mesh) {
    if (mesh.kind != CellKind::polygon) return mesh;
    Mesh result;
    result.kind = mesh.kind;
    result.positions = mesh.positions;
    result.companions = mesh.companions;
    result.tag_names = mesh.tag_names;
    result.notes = mesh.notes;
    std::vector<Index> old_cell, old_corner;
    if (!mesh.corner_begin.empty()) result.corner_begin.push_back(0);
    const auto end_cell = [&](Index cell) {
        old_cell.push_back(cell);
        result.corner_begin.push_back(old_corner.size());
    };
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const Index begin = mesh.corner_begin[c], degree = mesh.corner_begin[c + 1] - begin;
        if (degree < 3) {
            for (Index i = 0; i < degree; ++i) old_corner.push_back(begin + i);
            end_cell(c);
        }
        for (Index i = 1; i + 1 < degree; ++i) {
            old_corner.insert(old_corner.end(), {begin, begin + i, begin + i + 1});
            end_cell(c);
        }
    }
    result.corners.reserve(old_corner.size());
    for (Index corner : old_corner) result.corners.push_back(mesh.corners[corner]);
    for (const Attribute& attribute : mesh.attributes) {
        if (attribute.place == Place::cell)
            result.attributes.push_back(regather(attribute, old_cell));
        else if (attribute.place == Place::corner)
            result.attributes.push_back(regather(attribute, old_corner));
        else
            result.attributes.push_back(attribute);
        // Numbers of cells stay those of the polygons, which are no cells any more.
        std::erase_if(result.attributes.back().references,
                      [](const Reference& reference) { return reference.place == Place::cell; });
    }
    return result;
}

}  // namespace ravel::tool
