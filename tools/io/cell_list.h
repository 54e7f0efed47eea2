// The cells of a volume file in file order with their data, and how they map on a Mesh: tets (or
// polygons where there are none) become its cells, all others its companions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ravel/mesh.h"
#include "ravel/result.h"

namespace ravel::io {

struct CellList {
    std::vector<std::uint16_t> types;  // VTK's numbers
    std::vector<Index> begin{0};
    std::vector<Index> nodes;  // VTK's order

    Index count() const { return types.size(); }
    std::span<const Index> cell(Index c) const {
        return {nodes.data() + begin[c], nodes.data() + begin[c + 1]};
    }
    void add(std::uint16_t type, std::span<const Index> cell_nodes) {
        types.push_back(type);
        nodes.insert(nodes.end(), cell_nodes.begin(), cell_nodes.end());
        begin.push_back(nodes.size());
    }
};

// Values on the cells of a list; `index` as in Attribute: empty, or kNoIndex where a cell has none.
struct CellData {
    std::string name;
    Array values;
    std::vector<Index> index;
    // The attributes it was joined from; where one side has none, the other stands alone.
    const Attribute* on_cells = nullptr;
    const Attribute* on_companions = nullptr;
};

// tet where there is a tet, quadratic or not.
CellKind kind_of(const CellList& list);

// The list's cells in the order that a Mesh has them: its cells first, then the companions.
std::vector<Index> mesh_order(const CellList& list);

// Sets kind, corners and companions of `mesh` and adds the data as attributes of cells and of
// companions. A side where no cell has a value gets no attribute.
void split_cells(const CellList& list, std::vector<CellData> data, Mesh& mesh);

// The mesh's cells and then its companions; edge nodes of quadratic tets go back to their tets.
// The error is `unwritable`: edge nodes that do not fit the tets.
Result<CellList> join_cells(const Mesh& mesh, const std::string& path);

// All attributes of cells and companions, those of one name and type joined. One tuple per present
// element.
std::vector<CellData> join_cell_data(const Mesh& mesh);

}  // namespace ravel::io
