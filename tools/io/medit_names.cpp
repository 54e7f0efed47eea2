// Which sections of a MEDIT mesh name vertices or cells by their numbers.
#include "io/medit_sections.h"
#include "io/text_reader.h"

namespace ravel::io {

namespace {

struct Named {
    std::string_view keyword;
    MeditNames names;
};

// Edges and what is on them are companions, whose order does not change.
constexpr Named kNamed[] = {
    {"Corners", {"Vertices"}},
    {"RequiredVertices", {"Vertices"}},
    {"NormalAtVertices", {"Vertices"}},
    {"TangentAtVertices", {"Vertices"}},
    {"VertexOnGeometricVertex", {"Vertices"}},
    {"VertexOnGeometricEdge", {"Vertices"}},
    {"VertexOnGeometricTriangle", {"Vertices"}},
    {"VertexOnGeometricQuadrilateral", {"Vertices"}},
    {"VerticesOnGeometricVertices", {"Vertices"}},
    {"VerticesOnGeometricEdges", {"Vertices"}},
    {"VerticesOnGeometricTriangles", {"Vertices"}},
    {"VerticesOnGeometricQuadrilaterals", {"Vertices"}},
    {"VertexOnSupportVertex", {"Vertices"}},
    {"VertexOnSupportEdge", {"Vertices"}},
    {"VertexOnSupportTriangle", {"Vertices"}},
    {"VertexOnSupportQuadrilateral", {"Vertices"}},
    {"VertexOnSupportTetrahedron", {"Vertices"}},
    {"VertexOnSupportPentahedron", {"Vertices"}},
    {"VertexOnSupportHexahedron", {"Vertices"}},
    {"RequiredTriangles", {"Triangles"}},
    {"RequiredQuadrilaterals", {"Quadrilaterals"}},
    {"RequiredTetrahedra", {"Tetrahedra"}},
    {"TriangleOnGeometricTriangle", {"Triangles"}},
    {"TriangleOnGeometricQuadrilateral", {"Triangles"}},
    {"QuadrilateralOnGeometricTriangle", {"Quadrilaterals"}},
    {"QuadrilateralOnGeometricQuadrilateral", {"Quadrilaterals"}},
    {"CrackedTriangles", {"Triangles", 2}},
    {"CrackedQuadrilaterals", {"Quadrilaterals", 2}},
    {"EquivalentTriangles", {"Triangles", 2}},
    {"EquivalentQuadrilaterals", {"Quadrilaterals", 2}},
    {"NormalAtTriangleVertices", {"Triangles", 1, 3, true}},
    {"NormalAtQuadrilateralVertices", {"Quadrilaterals", 1, 4, true}},
};

// Cells of higher order than those that are read as cells: HexahedraQ2, TrianglesP3 and so on.
bool is_higher_order(std::string_view keyword) {
    if (keyword.size() < 3 || keyword.back() < '2' || keyword.back() > '4') return false;
    const char family = keyword[keyword.size() - 2];
    return family == 'P' || family == 'Q';
}

}  // namespace

std::optional<MeditNames> medit_names(std::string_view keyword, std::uint32_t arity) {
    for (const Named& named : kNamed)
        if (same_word(named.keyword, keyword) && arity >= named.names.columns + named.names.corners)
            return named.names;
    // Nodes and a reference.
    if (is_higher_order(keyword) && arity > 1) return MeditNames{"Vertices", arity - 1, arity};
    return std::nullopt;
}

}  // namespace ravel::io
