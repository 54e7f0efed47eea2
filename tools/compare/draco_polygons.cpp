#include "compare/draco_polygons.h"

#include <draco/mesh/corner_table.h>
#include <draco/mesh/mesh_misc_functions.h>

#include <algorithm>
#include <array>
#include <map>

#include "compare/grid.h"

namespace ravel::compare {
namespace {

constexpr const char* kMarkName = "added_edges";

int add_positions(draco::Mesh& result, const Mesh& mesh, bool double_positions, bool flat) {
    const auto type = double_positions ? draco::DT_FLOAT64 : draco::DT_FLOAT32;
    const auto points = static_cast<std::uint32_t>(mesh.point_count());
    draco::GeometryAttribute description;
    description.Init(draco::GeometryAttribute::POSITION, nullptr, 3, type, false,
                     (double_positions ? 8 : 4) * 3, 0);
    const int id = result.AddAttribute(description, false, points);
    for (std::uint32_t p = 0; p < points; ++p) {
        std::array<double, 3> wide{};
        std::array<float, 3> narrow{};
        for (int k = 0; k < 3 && !flat; ++k) {
            wide[static_cast<std::size_t>(k)] = coordinate(mesh, p, k);
            narrow[static_cast<std::size_t>(k)] =
                static_cast<float>(wide[static_cast<std::size_t>(k)]);
        }
        const void* value =
            double_positions ? static_cast<const void*>(wide.data()) : narrow.data();
        result.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(p), value);
    }
    return id;
}

int add_marks(draco::Mesh& result) {
    draco::GeometryAttribute description;
    description.Init(draco::GeometryAttribute::GENERIC, nullptr, 1, draco::DT_UINT8, false, 1, 0);
    const int id = result.AddAttribute(description, false, 2);
    for (const std::uint8_t mark : {std::uint8_t{0}, std::uint8_t{1}})
        result.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(mark), &mark);
    auto metadata = std::make_unique<draco::AttributeMetadata>();
    metadata->AddEntryString("name", kMarkName);
    result.AddAttributeMetadata(id, std::move(metadata));
    return id;
}

const draco::PointAttribute* marks_of(const draco::Mesh& mesh) {
    const draco::GeometryMetadata* metadata = mesh.GetMetadata();
    if (!metadata) return nullptr;
    const auto* found = metadata->GetAttributeMetadataByStringEntry("name", kMarkName);
    return found ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(found->att_unique_id()))
                 : nullptr;
}

struct Merger {
    const draco::Mesh& mesh;
    const draco::PointAttribute& positions;
    const draco::PointAttribute& marks;
    const draco::CornerTable& table;
    std::vector<bool> visited;

    std::uint32_t place(draco::PointIndex point) const {
        return positions.mapped_index(point).value();
    }
    bool marked(draco::PointIndex point) const {
        std::uint8_t mark = 0;
        marks.GetMappedValue(point, &mark);
        return mark != 0;
    }
    // The sides of the polygon that triangle `first` is part of: place -> place.
    std::map<std::uint32_t, std::uint32_t> sides(std::uint32_t first) {
        std::map<std::uint32_t, std::uint32_t> next;
        std::vector<std::uint32_t> pending{first};
        while (!pending.empty()) {
            const draco::FaceIndex face(pending.back());
            pending.pop_back();
            if (visited[face.value()]) continue;
            visited[face.value()] = true;
            const draco::Mesh::Face& points = mesh.face(face);
            for (std::uint32_t c = 0; c < 3; ++c) {
                const draco::CornerIndex across = table.Opposite(table.FirstCorner(face) + c);
                const bool inner = across != draco::kInvalidCornerIndex &&
                                   (marked(points[c]) || marked(mesh.CornerToPointId(across)));
                if (inner)
                    pending.push_back(table.Face(across).value());
                else
                    next.insert({place(points[(c + 1) % 3]), place(points[(c + 2) % 3])});
            }
        }
        return next;
    }
};

void add_polygon(Mesh& mesh, const std::map<std::uint32_t, std::uint32_t>& next) {
    if (next.empty()) return;
    std::uint32_t at = next.begin()->first;
    for (std::size_t i = 0; i < next.size(); ++i) {
        mesh.corners.push_back(at);
        const auto side = next.find(at);
        if (side == next.end()) break;
        at = side->second;
        if (at == next.begin()->first) break;
    }
    mesh.corner_begin.push_back(mesh.corners.size());
}

}  // namespace

std::unique_ptr<draco::Mesh> draco_mesh_of(const Mesh& mesh, bool double_positions, bool mark_edges,
                                           bool flat) {
    std::uint32_t triangles = 0;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const std::size_t degree = mesh.cell(c).size();
        if (degree >= 3) triangles += static_cast<std::uint32_t>(degree - 2);
    }
    auto result = std::make_unique<draco::Mesh>();
    result->SetNumFaces(triangles);
    result->set_num_points(3 * triangles);
    const int positions = add_positions(*result, mesh, double_positions, flat);
    const int marks = mark_edges ? add_marks(*result) : -1;
    std::uint32_t triangle = 0;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = mesh.cell(c);
        for (std::size_t t = 1; t + 1 < cell.size(); ++t, ++triangle) {
            const std::array<Index, 3> corners{cell[0], cell[t], cell[t + 1]};
            draco::Mesh::Face face;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const draco::PointIndex point(3 * triangle + k);
                face[k] = point;
                result->attribute(positions)->SetPointMapEntry(
                    point, draco::AttributeValueIndex(static_cast<std::uint32_t>(corners[k])));
                // All but the last triangle of a fan have an added edge opposite their second
                // corner, all but the first one opposite their third. Draco's own reader marks
                // both: where cells start alike, a vertex has the same mark all around.
                const bool added = (k == 1 && t + 2 < cell.size()) || (k == 2 && t > 1);
                if (marks >= 0)
                    result->attribute(marks)->SetPointMapEntry(
                        point, draco::AttributeValueIndex(added ? 1 : 0));
            }
            result->SetFace(draco::FaceIndex(triangle), face);
        }
    }
    result->DeduplicatePointIds();
    return result;
}

Mesh mesh_of_draco(const draco::Mesh& source) {
    Mesh mesh;
    mesh.corner_begin.push_back(0);
    const draco::PointAttribute* positions =
        source.GetNamedAttribute(draco::GeometryAttribute::POSITION);
    if (!positions) return mesh;
    const bool wide = positions->data_type() == draco::DT_FLOAT64;
    mesh.positions = make_array(wide ? Scalar::f64 : Scalar::f32, 3, positions->size());
    for (std::uint32_t i = 0; i < positions->size(); ++i) {
        std::byte* value = mesh.positions.bytes.data() + i * mesh.positions.stride();
        positions->GetValue(draco::AttributeValueIndex(i), value);
    }
    const draco::PointAttribute* marks = marks_of(source);
    if (!marks) {
        for (std::uint32_t f = 0; f < source.num_faces(); ++f) {
            for (const draco::PointIndex& point : source.face(draco::FaceIndex(f)))
                mesh.corners.push_back(positions->mapped_index(point).value());
            mesh.corner_begin.push_back(mesh.corners.size());
        }
        return mesh;
    }
    const auto table = draco::CreateCornerTableFromPositionAttribute(&source);
    if (!table) return mesh;
    Merger merger{source, *positions, *marks, *table, std::vector<bool>(source.num_faces(), false)};
    for (std::uint32_t f = 0; f < source.num_faces(); ++f)
        if (!merger.visited[f]) add_polygon(mesh, merger.sides(f));
    return mesh;
}

}  // namespace ravel::compare
