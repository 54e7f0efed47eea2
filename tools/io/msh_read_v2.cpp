// Nodes and elements of MSH 2.2.
#include "io/attributes.h"
#include "io/gmsh_types.h"
#include "io/msh_stream.h"

namespace ravel::io {

namespace {

constexpr std::size_t kMostTags = 64;

// The tags of one position (physical, geometrical, ...) of all elements; not all have all.
struct TagColumn {
    std::vector<std::int32_t> values;
    std::vector<Index> index;
};

struct ElementReader {
    MshInput& in;
    const TagLookup& lookup;
    MshFile& file;
    std::vector<TagColumn> columns;
    std::vector<Index> nodes, ordered;

    // One element behind its tag, its type and its number of tags.
    Status read(std::int64_t tag, const GmshType& type, std::size_t tags) {
        if (tag < 0) return in.fault("element " + std::to_string(tag) + " has a negative tag");
        const Index element = file.cells.count();
        if (columns.size() < tags) columns.resize(tags);
        for (std::size_t t = 0; t < tags; ++t) {
            std::int32_t value = 0;
            if (!in.get(value)) return in.missing("a tag of an element");
            columns[t].index.resize(element, kNoIndex);
            columns[t].index.push_back(columns[t].values.size());
            columns[t].values.push_back(value);
        }
        nodes.resize(type.nodes);
        for (Index& node : nodes) {
            std::int64_t node_tag = 0;
            if (!in.get_as<std::int32_t>(node_tag)) return in.missing("a node of an element");
            node = node_tag < 0 ? kNoIndex : lookup.find(static_cast<Index>(node_tag));
            if (node == kNoIndex) {
                return in.fault("element " + std::to_string(tag) + " uses node " +
                                std::to_string(node_tag) + ", which is not there");
            }
        }
        ordered = nodes;
        for (std::size_t i = 0; i < type.order.size(); ++i) ordered[i] = nodes[type.order[i]];
        file.cells.add(type.vtk, ordered);
        file.element_tags.push_back(static_cast<Index>(tag));
        file.gmsh_order = file.gmsh_order || (type.vtk >= 70 && type.vtk <= 74);
        return Done{};
    }

    void finish() {
        for (std::size_t t = 0; t < columns.size(); ++t) {
            TagColumn& column = columns[t];
            column.index.resize(file.cells.count(), kNoIndex);
            if (column.values.size() == column.index.size()) column.index.clear();
            file.element_columns.push_back(
                {gmsh_tag_name(t), array_of(column.values, 1), std::move(column.index)});
        }
    }
};

Result<const GmshType*> known_type(MshInput& in, std::int64_t type) {
    const GmshType* known = find_gmsh_type(type);
    if (!known) {
        return in.fault("elements of Gmsh type " + std::to_string(type) + " are not supported");
    }
    return known;
}

Status check_tag_count(MshInput& in, std::int64_t tags) {
    if (tags >= 0 && tags <= static_cast<std::int64_t>(kMostTags)) return Done{};
    return in.fault("an element has " + std::to_string(tags) + " tags; 0 to 64 can be");
}

}  // namespace

Status read_nodes_v2(MshInput& in, MshFile& file) {
    Index count = 0;
    if (!in.text.read(count)) return in.text.expected("the number of nodes");
    if (in.binary) in.text.next_line();
    if (!in.has_room(count, 28, 4)) {
        return in.fault(std::to_string(count) +
                        " nodes are announced, more than the file can hold");
    }
    std::vector<double> reals;
    reals.reserve(3 * count);
    for (Index i = 0; i < count; ++i) {
        std::int64_t tag = 0;
        if (!in.get_as<std::int32_t>(tag)) return in.missing("the tag of a node");
        if (tag < 0) return in.fault("a node has the negative tag " + std::to_string(tag));
        file.node_tags.push_back(static_cast<Index>(tag));
        for (int k = 0; k < 3; ++k) {
            double value = 0;
            if (!in.get(value)) return in.missing("a coordinate");
            reals.push_back(value);
        }
    }
    file.positions = array_of(reals, 3);
    return Done{};
}

Status read_elements_v2(MshInput& in, const TagLookup& nodes, MshFile& file) {
    Index count = 0;
    if (!in.text.read(count)) return in.text.expected("the number of elements");
    if (in.binary) in.text.next_line();
    if (!in.has_room(count, 8, 4)) {
        return in.fault(std::to_string(count) +
                        " elements are announced, more than the file can hold");
    }
    ElementReader reader{in, nodes, file, {}, {}, {}};
    while (file.cells.count() < count) {
        std::int64_t tag = 0, type = 0, follow = 1, tags = 0;
        // Text has tag, type and tag count on each line; binary a header for a run of elements.
        if (!in.binary && !in.get(tag)) return in.missing("the tag of an element");
        if (!in.get_as<std::int32_t>(type)) return in.missing("the type of an element");
        if (in.binary && !in.get_as<std::int32_t>(follow)) {
            return in.missing("a number of elements");
        }
        if (!in.get_as<std::int32_t>(tags)) return in.missing("the number of an element's tags");
        const Result<const GmshType*> known = known_type(in, type);
        if (!known) return known.error();
        if (Status status = check_tag_count(in, tags); !status) return status;
        if (follow < 1 || static_cast<Index>(follow) > count - file.cells.count()) {
            return in.fault("a run of " + std::to_string(follow) +
                            " elements does not fit the announced " + std::to_string(count));
        }
        for (std::int64_t i = 0; i < follow; ++i) {
            if (in.binary && !in.get_as<std::int32_t>(tag)) {
                return in.missing("the tag of an element");
            }
            Status status = reader.read(tag, **known, static_cast<std::size_t>(tags));
            if (!status) return status;
        }
    }
    reader.finish();
    return Done{};
}

}  // namespace ravel::io
