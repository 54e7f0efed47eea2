// Nodes and elements of MSH 4.1: both come in blocks of one entity.
#include "io/attributes.h"
#include "io/gmsh_types.h"
#include "io/msh_stream.h"

namespace ravel::io {

namespace {

struct Totals {
    std::uint64_t blocks = 0, count = 0;
};

Result<Totals> read_totals(MshInput& in, const std::string& what) {
    Totals totals;
    std::uint64_t least = 0, most = 0;
    if (!in.get(totals.blocks) || !in.get(totals.count) || !in.get(least) || !in.get(most)) {
        return in.missing("the numbers of blocks and of " + what);
    }
    if (!in.has_room(totals.count, 16, 2) || !in.has_room(totals.blocks, 20, 4)) {
        return in.fault(std::to_string(totals.blocks) + " blocks of " +
                        std::to_string(totals.count) + ' ' + what +
                        " are announced, more than the file can hold");
    }
    return totals;
}

struct Block {
    std::int32_t dimension = 0, entity = 0, third = 0;  // parametric or not, or the element type
    std::uint64_t count = 0;
};

Result<Block> read_block(MshInput& in, std::uint64_t left, const std::string& what) {
    Block block;
    if (!in.get(block.dimension) || !in.get(block.entity) || !in.get(block.third) ||
        !in.get(block.count)) {
        return in.missing("the head of a block of " + what);
    }
    if (block.dimension < 0 || block.dimension > 3) {
        return in.fault("a block of " + what + " has dimension " + std::to_string(block.dimension));
    }
    if (block.count > left) {
        return in.fault("a block of " + std::to_string(block.count) + ' ' + what +
                        " goes beyond the announced total");
    }
    return block;
}

bool valid_tag(std::uint64_t tag) {
    return tag <= std::uint64_t{1} << 62;
}

Status read_node_block(MshInput& in, const Block& block, MshFile& file,
                       std::vector<double>& reals) {
    for (std::uint64_t i = 0; i < block.count; ++i) {
        std::uint64_t tag = 0;
        if (!in.get(tag)) return in.missing("the tag of a node");
        if (!valid_tag(tag)) return in.fault("a node's tag is too large");
        file.node_tags.push_back(tag);
        file.node_dimensions.push_back(block.dimension);
        file.node_entities.push_back(block.entity);
    }
    for (std::uint64_t i = 0; i < block.count; ++i) {
        for (int k = 0; k < 3; ++k) {
            double value = 0;
            if (!in.get(value)) return in.missing("a coordinate");
            reals.push_back(value);
        }
        if (block.third == 0) {
            file.parametric_index.push_back(kNoIndex);
            continue;
        }
        file.parametric_index.push_back(file.parametric.size() / 3);
        for (int k = 0; k < 3; ++k) {
            double value = 0;
            if (k < block.dimension && !in.get(value)) return in.missing("a parametric coordinate");
            file.parametric.push_back(value);
        }
    }
    return Done{};
}

}  // namespace

Status read_nodes_v4(MshInput& in, MshFile& file) {
    const Result<Totals> totals = read_totals(in, "nodes");
    if (!totals) return totals.error();
    std::vector<double> reals;
    for (std::uint64_t b = 0; b < totals->blocks; ++b) {
        const Result<Block> block = read_block(in, totals->count - file.node_tags.size(), "nodes");
        if (!block) return block.error();
        if (block->third != 0 && block->third != 1) {
            return in.fault("a block of nodes is parametric (1) or not (0), not " +
                            std::to_string(block->third));
        }
        Status status = read_node_block(in, *block, file, reals);
        if (!status) return status;
    }
    if (file.node_tags.size() != totals->count) {
        return in.fault("the blocks have " + std::to_string(file.node_tags.size()) +
                        " nodes, but " + std::to_string(totals->count) + " are announced");
    }
    file.positions = array_of(reals, 3);
    return Done{};
}

Status read_elements_v4(MshInput& in, const TagLookup& lookup, MshFile& file) {
    const Result<Totals> totals = read_totals(in, "elements");
    if (!totals) return totals.error();
    std::vector<Index> nodes, ordered;
    for (std::uint64_t b = 0; b < totals->blocks; ++b) {
        const Result<Block> block = read_block(in, totals->count - file.cells.count(), "elements");
        if (!block) return block.error();
        const GmshType* type = find_gmsh_type(block->third);
        if (!type) {
            return in.fault("elements of Gmsh type " + std::to_string(block->third) +
                            " are not supported");
        }
        file.gmsh_order =
            file.gmsh_order || (block->count != 0 && type->vtk >= 70 && type->vtk <= 74);
        for (std::uint64_t i = 0; i < block->count; ++i) {
            std::uint64_t tag = 0;
            if (!in.get(tag)) return in.missing("the tag of an element");
            if (!valid_tag(tag)) return in.fault("an element's tag is too large");
            nodes.resize(type->nodes);
            for (Index& node : nodes) {
                std::uint64_t node_tag = 0;
                if (!in.get(node_tag)) return in.missing("a node of an element");
                node = lookup.find(node_tag);
                if (node == kNoIndex) {
                    return in.fault("element " + std::to_string(tag) + " uses node " +
                                    std::to_string(node_tag) + ", which is not there");
                }
            }
            ordered = nodes;
            for (std::size_t k = 0; k < type->order.size(); ++k) ordered[k] = nodes[type->order[k]];
            file.cells.add(type->vtk, ordered);
            file.element_tags.push_back(tag);
            file.element_dimensions.push_back(block->dimension);
            file.element_entities.push_back(block->entity);
        }
    }
    if (file.cells.count() != totals->count) {
        return in.fault("the blocks have " + std::to_string(file.cells.count()) +
                        " elements, but " + std::to_string(totals->count) + " are announced");
    }
    return Done{};
}

}  // namespace ravel::io
