#include "support/small_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <utility>

namespace ravel::test {
namespace {

void set_points(Mesh& mesh, const std::vector<Point>& points) {
    mesh.positions = make_array(Scalar::f64, 3, points.size());
    if (!points.empty())
        std::memcpy(mesh.positions.bytes.data(), points.data(), points.size() * sizeof(Point));
}

// Numerical Recipes' quick generator: its high bits are good enough for soups.
struct Random {
    std::uint32_t state;
    std::uint32_t below(std::uint32_t n) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::uint32_t>((std::uint64_t{state} * n) >> 32);
    }
};

Mesh cube() {
    return polygon_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

Mesh tetrahedron_surface() {
    return polygon_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

// Joins the midpoints of the edges: every face becomes a smaller one, every vertex a face.
Mesh rectified(const Mesh& mesh) {
    const auto old = mesh.positions.as<double>();
    std::vector<Point> points;
    std::map<std::pair<Index, Index>, Index> middle;
    const auto mid = [&](Index a, Index b) {
        const auto [at, fresh] = middle.try_emplace(std::minmax(a, b), points.size());
        if (fresh)
            points.push_back({(old[3 * a] + old[3 * b]) / 2, (old[3 * a + 1] + old[3 * b + 1]) / 2,
                              (old[3 * a + 2] + old[3 * b + 2]) / 2});
        return at->second;
    };
    std::vector<std::vector<Index>> cells;
    std::map<Index, std::map<Index, Index>>
        around;  // vertex -> midpoint -> next midpoint round the vertex
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const auto q = mesh.cell(c);
        std::vector<Index> inner;
        for (std::size_t i = 0; i < q.size(); ++i) {
            const Index next = mid(q[i], q[(i + 1) % q.size()]);
            inner.push_back(next);
            around[q[i]][next] = mid(q[(i + q.size() - 1) % q.size()], q[i]);
        }
        cells.push_back(inner);
    }
    for (const auto& [vertex, ring] : around) {
        std::vector<Index> face;
        Index at = ring.begin()->first;
        do {
            face.push_back(at);
            at = ring.at(at);
        } while (at != face.front());
        cells.push_back(face);
    }
    return polygon_mesh(points, cells);
}

// Cuts off the vertices of a closed surface at thirds: a truncated solid, hexagons from triangles.
Mesh truncated(const Mesh& mesh) {
    const auto old = mesh.positions.as<double>();
    std::vector<Point> points;
    std::map<std::pair<Index, Index>, Index> third;  // near the first of the pair
    const auto cut = [&](Index a, Index b) {
        const auto [at, fresh] = third.try_emplace(std::pair(a, b), points.size());
        if (fresh) {
            Point p{};
            for (std::size_t k = 0; k < 3; ++k) p[k] = (2 * old[3 * a + k] + old[3 * b + k]) / 3;
            points.push_back(p);
        }
        return at->second;
    };
    std::vector<std::vector<Index>> cells;
    std::map<Index, std::map<Index, Index>> around;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const auto q = mesh.cell(c);
        std::vector<Index> face;
        for (std::size_t i = 0; i < q.size(); ++i) {
            const Index a = q[i], b = q[(i + 1) % q.size()], z = q[(i + q.size() - 1) % q.size()];
            face.push_back(cut(a, b));
            face.push_back(cut(b, a));
            around[a][cut(a, b)] = cut(a, z);
        }
        cells.push_back(face);
    }
    for (const auto& [vertex, ring] : around) {
        std::vector<Index> face;
        Index at = ring.begin()->first;
        do {
            face.push_back(at);
            at = ring.at(at);
        } while (at != face.front());
        cells.push_back(face);
    }
    return polygon_mesh(points, cells);
}

}  // namespace

Mesh polygon_mesh(const std::vector<Point>& points, const std::vector<std::vector<Index>>& cells) {
    Mesh mesh;
    set_points(mesh, points);
    mesh.corner_begin.push_back(0);
    for (const std::vector<Index>& cell : cells) {
        mesh.corners.insert(mesh.corners.end(), cell.begin(), cell.end());
        mesh.corner_begin.push_back(mesh.corners.size());
    }
    return mesh;
}

Mesh tet_mesh(const std::vector<Point>& points, const std::vector<std::array<Index, 4>>& cells) {
    Mesh mesh;
    mesh.kind = CellKind::tet;
    set_points(mesh, points);
    for (const auto& cell : cells)
        mesh.corners.insert(mesh.corners.end(), cell.begin(), cell.end());
    return mesh;
}

Mesh quad_grid(Index columns, Index rows) {
    std::vector<Point> points;
    std::vector<std::vector<Index>> cells;
    for (Index y = 0; y <= rows; ++y)
        for (Index x = 0; x <= columns; ++x) points.push_back({double(x), double(y), 0});
    for (Index y = 0; y < rows; ++y)
        for (Index x = 0; x < columns; ++x) {
            const Index a = y * (columns + 1) + x;
            cells.push_back({a, a + 1, a + columns + 2, a + columns + 1});
        }
    return polygon_mesh(points, cells);
}

Mesh quad_torus(Index columns, Index rows) {
    std::vector<Point> points;
    std::vector<std::vector<Index>> cells;
    for (Index y = 0; y < rows; ++y)
        for (Index x = 0; x < columns; ++x) {
            const double u = 2 * std::numbers::pi * double(x) / double(columns);
            const double v = 2 * std::numbers::pi * double(y) / double(rows);
            points.push_back(
                {(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)});
            const Index x1 = (x + 1) % columns, y1 = (y + 1) % rows;
            cells.push_back(
                {y * columns + x, y * columns + x1, y1 * columns + x1, y1 * columns + x});
        }
    return polygon_mesh(points, cells);
}

Mesh moebius_band(Index length) {
    std::vector<Point> points;
    std::vector<std::vector<Index>> cells;
    for (Index x = 0; x < length; ++x)
        for (const double side : {-1.0, 1.0}) {
            const double u = 2 * std::numbers::pi * double(x) / double(length);
            const double r = 4 + side * std::cos(u / 2);
            points.push_back({r * std::cos(u), r * std::sin(u), side * std::sin(u / 2)});
        }
    for (Index x = 0; x + 1 < length; ++x)
        cells.push_back({2 * x, 2 * x + 2, 2 * x + 3, 2 * x + 1});
    cells.push_back({2 * length - 2, 1, 0, 2 * length - 1});
    return polygon_mesh(points, cells);
}

Mesh triangle_fan(Index triangles) {
    std::vector<Point> points{{0, 0, 0}};
    std::vector<std::vector<Index>> cells;
    for (Index i = 0; i < triangles; ++i) {
        const double u = 2 * std::numbers::pi * double(i) / double(triangles);
        points.push_back({std::cos(u), std::sin(u), 0});
        cells.push_back({0, 1 + i, 1 + (i + 1) % triangles});
    }
    return polygon_mesh(points, cells);
}

Mesh honeycomb(Index columns, Index rows) {
    std::vector<Point> points;
    std::map<std::pair<long, long>, Index> at;  // on a grid that every corner falls on
    std::vector<std::vector<Index>> cells;
    const std::array<std::pair<long, long>, 6> ring{
        {{1, 0}, {2, 1}, {2, 3}, {1, 4}, {0, 3}, {0, 1}}};
    for (Index y = 0; y < rows; ++y)
        for (Index x = 0; x < columns; ++x) {
            std::vector<Index> cell;
            for (const auto& [dx, dy] : ring) {
                const long px = long(2 * x + y % 2) + dx, py = long(3 * y) + dy;
                const auto [where, fresh] = at.try_emplace({px, py}, points.size());
                if (fresh) points.push_back({double(px), double(py) * 0.57735, 0});
                cell.push_back(where->second);
            }
            cells.push_back(cell);
        }
    return polygon_mesh(points, cells);
}

Mesh tet_box(Index nx, Index ny, Index nz) {
    std::vector<Point> points;
    std::vector<std::array<Index, 4>> cells;
    for (Index z = 0; z <= nz; ++z)
        for (Index y = 0; y <= ny; ++y)
            for (Index x = 0; x <= nx; ++x) points.push_back({double(x), double(y), double(z)});
    const std::array<Index, 3> step{1, nx + 1, (nx + 1) * (ny + 1)};
    constexpr std::array<std::array<std::size_t, 3>, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (Index z = 0; z < nz; ++z)
        for (Index y = 0; y < ny; ++y)
            for (Index x = 0; x < nx; ++x)
                for (std::size_t i = 0; i < 6; ++i) {
                    std::array<Index, 4> tet{};
                    tet[0] = z * step[2] + y * step[1] + x;
                    for (std::size_t k = 0; k < 3; ++k) tet[k + 1] = tet[k] + step[orders[i][k]];
                    // Even orders are right-handed.
                    if (i == 1 || i == 2 || i == 5) std::swap(tet[2], tet[3]);
                    cells.push_back(tet);
                }
    return tet_mesh(points, cells);
}

Mesh random_soup(CellKind kind, Index points, Index cells, std::uint32_t seed) {
    Random random{seed * 2654435761u + 1};
    std::vector<Point> where;
    for (Index i = 0; i < points; ++i)
        where.push_back(
            {double(random.below(100)), double(random.below(100)), double(random.below(100))});
    const auto any = [&] { return Index{random.below(static_cast<std::uint32_t>(points))}; };
    if (kind == CellKind::tet) {
        std::vector<std::array<Index, 4>> tets;
        for (Index c = 0; c < cells; ++c) tets.push_back({any(), any(), any(), any()});
        return tet_mesh(where, tets);
    }
    std::vector<std::vector<Index>> polygons;
    for (Index c = 0; c < cells; ++c) {
        std::vector<Index> polygon(1 + random.below(7));
        for (Index& p : polygon) p = any();
        polygons.push_back(polygon);
    }
    return polygon_mesh(where, polygons);
}

Mesh with_holes(const Mesh& mesh, std::uint32_t percent, std::uint32_t seed) {
    Random random{seed * 2654435761u + 7};
    Mesh holed = mesh;
    holed.corners.clear();
    if (mesh.kind == CellKind::polygon) holed.corner_begin.assign(1, 0);
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        if (random.below(100) < percent) continue;
        const auto cell = mesh.cell(c);
        holed.corners.insert(holed.corners.end(), cell.begin(), cell.end());
        if (mesh.kind == CellKind::polygon) holed.corner_begin.push_back(holed.corners.size());
    }
    return holed;
}

std::vector<NamedMesh> small_meshes() {
    std::vector<NamedMesh> all;
    const auto clean = [&](const std::string& name, Mesh mesh) {
        all.push_back({name, std::move(mesh), true});
    };
    const auto dirty = [&](const std::string& name, Mesh mesh) {
        all.push_back({name, std::move(mesh), false});
    };
    const std::vector<Point> few{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                 {1, 1, 1}, {2, 0, 0}, {0, 2, 0}, {2, 2, 1}};

    clean("no polygon at all", Mesh{});
    clean("no tet at all", tet_mesh({}, {}));
    clean("one quad", quad_grid(1, 1));
    clean("one tet", tet_mesh(few, {{0, 1, 2, 3}}));
    clean("two quads", quad_grid(2, 1));
    clean("two tets", tet_mesh(few, {{0, 1, 2, 3}, {4, 2, 1, 3}}));
    clean("quad grid 5 x 4", quad_grid(5, 4));
    clean("quad grid 7 x 5", quad_grid(7, 5));
    clean("quad comb 40 x 1", quad_grid(40, 1));
    clean("quad torus 6 x 5", quad_torus(6, 5));
    clean("quad torus 3 x 3", quad_torus(3, 3));
    clean("cube", cube());
    clean("tetrahedron", tetrahedron_surface());
    clean("cuboctahedron", rectified(cube()));
    clean("truncated cuboctahedron's kin", rectified(rectified(cube())));
    clean("truncated tetrahedron", truncated(tetrahedron_surface()));
    clean("truncated octahedron", truncated(rectified(tetrahedron_surface())));
    clean("truncated truncated cube", truncated(truncated(cube())));
    clean("triangle fan", triangle_fan(7));
    clean("honeycomb 6 x 6", honeycomb(6, 6));
    clean("honeycomb 1 x 3", honeycomb(1, 3));
    clean("tet box 1 x 1 x 1", tet_box(1, 1, 1));
    clean("tet box 4 x 3 x 2", tet_box(4, 3, 2));
    clean("star of one tet and four",
          tet_mesh({{0, 0, 0},
                    {1, 0, 0},
                    {0, 1, 0},
                    {0, 0, 1},
                    {1, 1, 1},
                    {-1, .3, .3},
                    {.3, -1, .3},
                    {.3, .3, -1}},
                   {{0, 1, 2, 3}, {4, 2, 1, 3}, {5, 0, 2, 3}, {6, 1, 0, 3}, {7, 0, 1, 2}}));
    clean("hexagon with six triangles", polygon_mesh({{2, 0, 0},
                                                      {1, 2, 0},
                                                      {-1, 2, 0},
                                                      {-2, 0, 0},
                                                      {-1, -2, 0},
                                                      {1, -2, 0},
                                                      {3, 2, 0},
                                                      {0, 4, 0},
                                                      {-3, 2, 0},
                                                      {-3, -2, 0},
                                                      {0, -4, 0},
                                                      {3, -2, 0}},
                                                     {{0, 1, 2, 3, 4, 5},
                                                      {1, 0, 6},
                                                      {2, 1, 7},
                                                      {3, 2, 8},
                                                      {4, 3, 9},
                                                      {5, 4, 10},
                                                      {0, 5, 11}}));
    clean("quads around a triangle",
          polygon_mesh({{0, 0, 0},
                        {1, 0, 0},
                        {0, 1, 0},
                        {0, -1, 0},
                        {1, -1, 0},
                        {2, 1, 0},
                        {1, 2, 0},
                        {-1, 1, 0},
                        {-1, 0, 0}},
                       {{0, 1, 2}, {1, 0, 3, 4}, {2, 1, 5, 6}, {0, 2, 7, 8}}));
    dirty("pillow of two quads", polygon_mesh(few, {{0, 1, 4, 2}, {2, 4, 1, 0}}));
    dirty("three quads with four neighbours each",
          polygon_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                       {{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 4, 2, 1}}));
    dirty("pillow of two tets", tet_mesh(few, {{0, 1, 2, 3}, {0, 2, 1, 3}}));
    dirty("moebius band", moebius_band(9));
    dirty("pinched vertex", polygon_mesh(few, {{0, 1, 2}, {0, 5, 7}, {0, 7, 6}}));
    dirty("three triangles on an edge",
          polygon_mesh(few, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 5}}));
    dirty("three tets on a face",
          tet_mesh(few, {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 7}, {1, 2, 3, 7}}));
    dirty("repeated cells", polygon_mesh(few, {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {1, 5, 7, 2}}));
    dirty("two-gons and one-gons",
          polygon_mesh(few, {{0, 1}, {1, 0}, {0, 1, 2}, {3}, {2, 1}, {1, 2, 4}}));
    dirty("chain of two-gons",
          polygon_mesh(few, {{0, 1}, {1, 0}, {0, 1}, {1, 0}, {0, 1, 2}, {1, 0, 3}}));
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const std::string number = std::to_string(seed);
        dirty("polygon soup " + number,
              random_soup(CellKind::polygon, 6 + 2 * seed, 40 + 20 * seed, seed));
        dirty("tet soup " + number, random_soup(CellKind::tet, 6 + seed, 40 + 20 * seed, seed));
        dirty("holed grid " + number, with_holes(quad_grid(12, 12), 10 + 8 * seed, seed));
        dirty("holed honeycomb " + number, with_holes(honeycomb(10, 10), 10 + 8 * seed, seed));
        dirty("holed solid " + number,
              with_holes(truncated(truncated(cube())), 5 + 5 * seed, seed));
        dirty("holed box " + number, with_holes(tet_box(5, 4, 4), 10 + 8 * seed, seed));
    }
    return all;
}

}  // namespace ravel::test
