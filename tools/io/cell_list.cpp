#include "io/cell_list.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "io/attributes.h"
#include "io/left_out.h"
#include "io/vtk_cells.h"

namespace ravel::io {

namespace {

bool is_tet(std::uint16_t type) {
    return type == kVtkTet || type == kVtkQuadraticTet;
}
bool is_polygon(std::uint16_t type) {
    return type == kVtkTriangle || type == kVtkQuad || type == kVtkPolygon || type == kVtkPixel;
}

bool is_main(CellKind kind, std::uint16_t type) {
    return kind == CellKind::tet ? is_tet(type) : is_polygon(type);
}

void add_companion(Mesh& mesh, std::uint16_t type, std::span<const Index> nodes) {
    if (mesh.companions.empty() || mesh.companions.back().vtk_type != type ||
        mesh.companions.back().nodes_per_cell != nodes.size()) {
        mesh.companions.push_back({type, static_cast<std::uint32_t>(nodes.size()), 0, {}, {}});
    }
    CompanionBlock& block = mesh.companions.back();
    block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
    ++block.cell_count;
}

void add_polygon(Mesh& mesh, std::uint16_t type, std::span<const Index> nodes) {
    mesh.corners.insert(mesh.corners.end(), nodes.begin(), nodes.end());
    // A pixel's nodes go row by row, a quad's go round.
    if (type == kVtkPixel) std::swap(mesh.corners.end()[-1], mesh.corners.end()[-2]);
    mesh.corner_begin.push_back(mesh.corners.size());
}

// Collects the tuples of one side in mesh order.
struct Side {
    Array values;
    std::vector<Index> index;
    Index present = 0;

    void add(const CellData& data, Index element) {
        const Index tuple = data.index.empty() ? element : data.index[element];
        if (tuple == kNoIndex) {
            index.push_back(kNoIndex);
            return;
        }
        const auto from =
            data.values.bytes.begin() + static_cast<std::ptrdiff_t>(tuple * data.values.stride());
        values.bytes.insert(values.bytes.end(), from,
                            from + static_cast<std::ptrdiff_t>(data.values.stride()));
        index.push_back(present++);
    }
};

void add_side(Mesh& mesh, const CellData& data, Place place, Side side, Index host_count) {
    if (side.present == 0) return;
    if (side.present == side.index.size()) {
        side.index.clear();
        // Edge nodes of quadratic tets are no cells of the file; their tuples are fillers.
        side.values.bytes.resize(side.values.bytes.size() + host_count * side.values.stride());
    } else {
        side.index.insert(side.index.end(), host_count, kNoIndex);
    }
    add_attribute(mesh, data.name, place, std::move(side.values), std::move(side.index));
}

const CompanionBlock* host_block(const Mesh& mesh) {
    for (const CompanionBlock& block : mesh.companions) {
        if (!block.hosts.empty()) return &block;
    }
    return nullptr;
}

// Appends the tuples of an attribute; companions of `mesh` that are edge nodes are skipped.
void append_values(const Mesh& mesh, const Attribute* attribute, Place place, CellData& data) {
    Index present = data.values.count();
    const auto add = [&](Index element) {
        Index tuple = kNoIndex;
        if (attribute) tuple = attribute->index.empty() ? element : attribute->index[element];
        if (tuple == kNoIndex) {
            data.index.push_back(kNoIndex);
            return;
        }
        const auto from = attribute->values.bytes.begin() +
                          static_cast<std::ptrdiff_t>(tuple * attribute->values.stride());
        data.values.bytes.insert(data.values.bytes.end(), from,
                                 from + static_cast<std::ptrdiff_t>(attribute->values.stride()));
        data.index.push_back(present++);
    };
    if (place == Place::cell) {
        for (Index c = 0; c < mesh.cell_count(); ++c) add(c);
        return;
    }
    Index element = 0;
    for (const CompanionBlock& block : mesh.companions) {
        for (Index i = 0; i < block.cell_count; ++i, ++element) {
            if (block.hosts.empty()) add(element);
        }
    }
}

}  // namespace

CellKind kind_of(const CellList& list) {
    return std::any_of(list.types.begin(), list.types.end(), is_tet) ? CellKind::tet
                                                                     : CellKind::polygon;
}

std::vector<Index> mesh_order(const CellList& list) {
    const CellKind kind = kind_of(list);
    std::vector<Index> order;
    order.reserve(list.count());
    for (const bool main : {true, false}) {
        for (Index c = 0; c < list.count(); ++c) {
            if (is_main(kind, list.types[c]) == main) order.push_back(c);
        }
    }
    return order;
}

void split_cells(const CellList& list, std::vector<CellData> data, Mesh& mesh) {
    mesh.kind = kind_of(list);
    if (mesh.kind == CellKind::polygon) mesh.corner_begin.push_back(0);
    CompanionBlock edge_nodes{kVtkQuadraticTet, 6, 0, {}, {}};
    for (Index c = 0; c < list.count(); ++c) {
        const std::uint16_t type = list.types[c];
        const std::span<const Index> nodes = list.cell(c);
        if (!is_main(mesh.kind, type)) {
            add_companion(mesh, type, nodes);
        } else if (mesh.kind == CellKind::polygon) {
            add_polygon(mesh, type, nodes);
        } else {
            if (type == kVtkQuadraticTet) {
                edge_nodes.nodes.insert(edge_nodes.nodes.end(), nodes.begin() + 4, nodes.end());
                edge_nodes.hosts.push_back(mesh.corners.size() / 4);
            }
            mesh.corners.insert(mesh.corners.end(), nodes.begin(), nodes.begin() + 4);
        }
    }
    edge_nodes.cell_count = edge_nodes.hosts.size();
    const Index hosts = edge_nodes.cell_count;
    if (hosts != 0) mesh.companions.push_back(std::move(edge_nodes));

    for (CellData& values : data) {
        Side cells{{values.values.scalar, values.values.arity, {}}, {}, 0};
        Side companions = cells;
        for (Index c = 0; c < list.count(); ++c) {
            (is_main(mesh.kind, list.types[c]) ? cells : companions).add(values, c);
        }
        if (cells.present + companions.present == 0) {
            // Values on nothing are still a name: keep them, on the cells.
            add_attribute(mesh, values.name, Place::cell, std::move(cells.values),
                          std::move(cells.index));
            continue;
        }
        add_side(mesh, values, Place::cell, std::move(cells), 0);
        add_side(mesh, values, Place::companion, std::move(companions), hosts);
        values.values.bytes = {};
    }
}

Result<CellList> join_cells(const Mesh& mesh, const std::string& path) {
    const CompanionBlock* edges = host_block(mesh);
    std::vector<Index> edges_of(edges ? mesh.cell_count() : 0, kNoIndex);
    for (const CompanionBlock& block : mesh.companions) {
        if (block.hosts.empty()) continue;
        if (&block != edges || mesh.kind != CellKind::tet || block.nodes_per_cell != 6 ||
            block.vtk_type != kVtkQuadraticTet) {
            return cannot_hold(path, "edge nodes other than one block of six per quadratic tet");
        }
        for (Index i = 0; i < block.hosts.size(); ++i) {
            if (block.hosts[i] >= edges_of.size() || edges_of[block.hosts[i]] != kNoIndex) {
                return cannot_hold(path, "two sets of edge nodes for one tet");
            }
            edges_of[block.hosts[i]] = i;
        }
    }
    CellList list;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const std::span<const Index> cell = mesh.cell(c);
        if (mesh.kind == CellKind::polygon) {
            list.add(cell.size() == 3   ? kVtkTriangle
                     : cell.size() == 4 ? kVtkQuad
                                        : kVtkPolygon,
                     cell);
        } else if (edges && edges_of[c] != kNoIndex) {
            std::array<Index, 10> nodes{};
            std::copy(cell.begin(), cell.end(), nodes.begin());
            std::copy_n(edges->nodes.begin() + static_cast<std::ptrdiff_t>(6 * edges_of[c]), 6,
                        nodes.begin() + 4);
            list.add(kVtkQuadraticTet, nodes);
        } else {
            list.add(kVtkTet, cell);
        }
    }
    for (const CompanionBlock& block : mesh.companions) {
        if (!block.hosts.empty()) continue;
        for (Index i = 0; i < block.cell_count; ++i) {
            list.add(
                block.vtk_type,
                std::span(block.nodes).subspan(i * block.nodes_per_cell, block.nodes_per_cell));
        }
    }
    return list;
}

std::vector<CellData> join_cell_data(const Mesh& mesh) {
    std::vector<CellData> joined;
    for (const Attribute& attribute : mesh.attributes) {
        const bool on_cells = attribute.place == Place::cell;
        if (!on_cells && attribute.place != Place::companion) continue;
        // The first of its name that has this side still free is its other half.
        const auto partner = std::find_if(joined.begin(), joined.end(), [&](const CellData& data) {
            return data.name == attribute.name && data.values.scalar == attribute.values.scalar &&
                   data.values.arity == attribute.values.arity &&
                   (on_cells ? data.on_cells : data.on_companions) == nullptr;
        });
        CellData fresh{attribute.name, {attribute.values.scalar, attribute.values.arity, {}}, {}};
        CellData& data = partner == joined.end() ? joined.emplace_back(std::move(fresh)) : *partner;
        (on_cells ? data.on_cells : data.on_companions) = &attribute;
    }
    for (CellData& data : joined) {
        append_values(mesh, data.on_cells, Place::cell, data);
        append_values(mesh, data.on_companions, Place::companion, data);
        if (data.values.count() == data.index.size()) data.index.clear();
    }
    return joined;
}

}  // namespace ravel::io
