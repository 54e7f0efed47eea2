// The subdivided mesh with one Hamiltonian strip per component: what the paper makes of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel {

// Cells in strip order, oriented as in the complex: cell i goes to cell i + 1 across its facet
// exit[i].
struct Materialised {
    Mesh mesh;                  // points of the original first, then the new ones
    std::vector<Index> parent;  // cell -> cell of the original mesh
    std::vector<Index> first;   // components + 1: cells of component k are [first[k], first[k + 1])
    std::vector<std::uint8_t> closed;  // component -> 1 where its last cell goes to its first
    std::vector<std::uint32_t>
        exit;  // local facet to the next cell; ~0 at the end of an open strip
    Index added_cells = 0;
    Index added_points = 0;
};

// Every link becomes a split of its two cells. Cell attributes come from the parents; point
// attributes of floats are blended and others copied; corner attributes, companions and numbers of
// cells are left out. Fails only on a strip that is none (see check.h). Linear in the output.
Result<Materialised> materialise(const Mesh& mesh, const Complex& complex, const Strip& strip);

// The certificate: every cell once, each sharing a facet (by points) with the next, counts right.
// Linear.
Status check_materialised(const Mesh& original, const Materialised& result);

}  // namespace ravel
