// From a Mesh to a Gmsh file: attributes with Gmsh's names become tags again, others data sections.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "io/attributes.h"
#include "io/gmsh_types.h"
#include "io/msh_stream.h"
#include "io/vtk_cells.h"

namespace ravel::io {

namespace {

using EntityKey = std::pair<std::int32_t, std::int32_t>;  // dimension and tag

// What the cell data with Gmsh's names say; nullptr where the mesh has none of them.
struct ElementTags {
    const CellData* physical = nullptr;
    const CellData* geometrical = nullptr;
    const CellData* dimension = nullptr;
    const CellData* element = nullptr;
};

std::int32_t i32_at(const CellData* data, Index c, std::int32_t otherwise) {
    if (!data) return otherwise;
    const Index tuple = data->index.empty() ? c : data->index[c];
    return tuple == kNoIndex ? otherwise : data->values.as<std::int32_t>()[tuple];
}

bool has_value(const CellData* data, Index c) {
    return data && (data->index.empty() || data->index[c] != kNoIndex);
}

bool is_column(const CellData& data, Scalar scalar) {
    return data.values.scalar == scalar && data.values.arity == 1;
}

const CellData* find_column(const std::vector<CellData>& all, const std::string& name,
                            Scalar scalar = Scalar::i32) {
    for (const CellData& data : all) {
        if (data.name == name && is_column(data, scalar)) return &data;
    }
    return nullptr;
}

const Attribute* find_nodal(const Mesh& mesh, const char* name, Scalar scalar,
                            std::uint32_t arity) {
    const Attribute* found = find_attribute(mesh, Place::point, name);
    return found && found->values.scalar == scalar && found->values.arity == arity ? found
                                                                                   : nullptr;
}

struct Building {
    const Mesh& mesh;
    MshFile file;
    LeftOut& left_out;
    std::vector<CellData> cell_data;
    std::set<const CellData*> used;

    void take(const CellData* data) {
        if (!data) return;
        used.insert(data);
        left_out.take(data->on_cells);
        left_out.take(data->on_companions);
    }
};

// Tags to write for nodes or elements: those kept if they can be tags, else 1, 2, 3 and so on.
bool good_tags(std::span<const std::int64_t> tags) {
    std::vector<std::int64_t> sorted(tags.begin(), tags.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() &&
           (sorted.empty() || sorted.front() >= 0);
}

std::vector<Index> counted(Index count) {
    std::vector<Index> tags(count);
    for (Index i = 0; i < count; ++i) tags[i] = i + 1;
    return tags;
}

// The corners of each cell as they were in the file, for $ElementNodeData. The cells are the first
// of the list; edge nodes of quadratic tets go with the corners.
void restore_corners(Building& b) {
    const Attribute* attribute = find_attribute(b.mesh, Place::corner, kGmshCorner);
    if (!attribute || attribute->values.scalar != Scalar::u8 || attribute->values.arity != 1 ||
        !attribute->index.empty()) {
        return;
    }
    constexpr std::uint8_t kEdgeOf[4][4] = {{0, 0, 2, 3}, {0, 0, 1, 4}, {2, 1, 0, 5}, {3, 4, 5, 0}};
    bool turned = false;
    Index first = 0;
    for (Index c = 0; c < b.mesh.cell_count(); ++c) {
        const std::size_t size = b.mesh.cell(c).size();
        const auto to = attribute->values.as<std::uint8_t>().subspan(first, size);
        first += size;
        std::vector<std::uint8_t> sorted(to.begin(), to.end()), usual(size);
        for (std::size_t k = 0; k < size; ++k) usual[k] = static_cast<std::uint8_t>(k);
        if (std::equal(to.begin(), to.end(), usual.begin())) continue;
        std::sort(sorted.begin(), sorted.end());
        if (sorted != usual) continue;
        turned = true;
        const std::span<const Index> cell = b.file.cells.cell(c);
        const std::vector<Index> nodes(cell.begin(), cell.end());
        Index* const out = b.file.cells.nodes.data() + b.file.cells.begin[c];
        for (std::size_t k = 0; k < size; ++k) out[to[k]] = nodes[k];
        for (std::size_t i = 0; nodes.size() == 10 && i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                out[4 + kEdgeOf[to[i]][to[j]]] = nodes[4 + kEdgeOf[i][j]];
            }
        }
    }
    if (turned) b.left_out.say("cells begin with the corner that $ElementNodeData begins with");
    b.left_out.take(attribute);
}

void build_nodes(Building& b) {
    const Index count = b.mesh.point_count();
    b.file.positions = b.mesh.positions;
    b.file.node_tags = counted(count);
    const Attribute* tags = find_nodal(b.mesh, kGmshNode, Scalar::i64, 1);
    if (tags && tags->index.empty() && good_tags(tags->values.as<std::int64_t>())) {
        const std::span<const std::int64_t> kept = tags->values.as<std::int64_t>();
        b.file.node_tags.assign(kept.begin(), kept.end());
        b.left_out.take(tags);
    }
    b.file.node_dimensions.assign(count, dimension_of(b.mesh.kind));
    b.file.node_entities.assign(count, kDefaultEntity);
    b.file.parametric_index.assign(count, kNoIndex);
    if (!b.file.version_4) return;
    const Attribute* dimension = find_nodal(b.mesh, kGmshEntityDimension, Scalar::i32, 1);
    const Attribute* entity = find_nodal(b.mesh, kGmshEntityTag, Scalar::i32, 1);
    const auto in_range = [](std::int32_t d) { return d >= 0 && d <= 3; };
    if (dimension && entity && dimension->index.empty() && entity->index.empty()) {
        const std::span<const std::int32_t> d = dimension->values.as<std::int32_t>();
        const std::span<const std::int32_t> e = entity->values.as<std::int32_t>();
        if (std::all_of(d.begin(), d.end(), in_range)) {
            b.file.node_dimensions.assign(d.begin(), d.end());
            b.file.node_entities.assign(e.begin(), e.end());
            b.left_out.take(dimension);
            b.left_out.take(entity);
        }
    }
    const Attribute* parametric = find_nodal(b.mesh, kGmshParametric, Scalar::f64, 3);
    if (parametric) {
        const std::span<const double> values = parametric->values.as<double>();
        b.file.parametric.assign(values.begin(), values.end());
        for (Index i = 0; i < count; ++i) b.file.parametric_index[i] = tuple_of(*parametric, i);
        b.left_out.take(parametric);
    }
}

void build_element_tags(Building& b, const CellData* kept) {
    const Index count = b.file.cells.count();
    b.file.element_tags = counted(count);
    if (!kept || !kept->index.empty()) return;
    const std::span<const std::int64_t> tags = kept->values.as<std::int64_t>();
    if (std::any_of(tags.begin(), tags.end(), [](std::int64_t tag) { return tag < 0; })) return;
    b.file.element_tags.assign(tags.begin(), tags.end());
    b.take(kept);
}

// The tags of version 2 are a prefix of physical, geometrical, third, ...
void build_columns_v2(Building& b) {
    std::vector<const CellData*> columns;
    for (std::size_t slot = 0; slot < 64; ++slot) {
        const CellData* column = find_column(b.cell_data, gmsh_tag_name(slot));
        if (!column && slot >= 2) break;
        columns.push_back(column);
    }
    while (!columns.empty() && !columns.back()) columns.pop_back();
    for (const CellData* column : columns) {
        b.take(column);
        b.file.element_columns.push_back(
            column ? *column
                   : CellData{"", make_array(Scalar::i32, 1, 0),
                              std::vector<Index>(b.file.cells.count(), kNoIndex)});
    }
}

// Where physical tags came without entities: one entity for each that elements name.
// False when one entity would need two physical tags.
bool derive_entities(const Building& b, const ElementTags& tags, MshEntities& entities) {
    std::map<EntityKey, std::pair<bool, std::int32_t>> physical;
    std::map<EntityKey, MshEntity> made;
    for (Index c = 0; c < b.file.cells.count(); ++c) {
        const EntityKey key{b.file.element_dimensions[c], b.file.element_entities[c]};
        const std::pair mine{has_value(tags.physical, c), i32_at(tags.physical, c, 0)};
        const auto [known, fresh] = physical.emplace(key, mine);
        if (!fresh && known->second != mine) return false;
        MshEntity& entity = made[key];
        if (fresh) {
            entity.tag = key.second;
            if (mine.first) entity.physical = {mine.second};
        }
        bool start = fresh;
        for (const Index node : b.file.cells.cell(c)) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double x = real_at(b.mesh.positions, 3 * node + k);
                if (start || x < entity.box[k]) entity.box[k] = x;
                if (start || x > entity.box[3 + k]) entity.box[3 + k] = x;
            }
            start = false;
        }
    }
    for (auto& [key, entity] : made) {
        entities[static_cast<std::size_t>(key.first)].push_back(std::move(entity));
    }
    return true;
}

// Do the entities give each element the physical tag that it has?
bool entities_agree(const Building& b, const ElementTags& tags) {
    std::map<EntityKey, std::int32_t> physical;
    for (std::int32_t d = 0; d < 4; ++d) {
        for (const MshEntity& entity : b.file.entities[static_cast<std::size_t>(d)]) {
            if (entity.physical.empty()) continue;
            physical.emplace(EntityKey{d, entity.tag}, entity.physical[0]);
        }
    }
    for (Index c = 0; c < b.file.cells.count(); ++c) {
        const auto found =
            physical.find({b.file.element_dimensions[c], b.file.element_entities[c]});
        if ((found != physical.end()) != has_value(tags.physical, c)) return false;
        if (found != physical.end() && found->second != i32_at(tags.physical, c, 0)) return false;
    }
    return true;
}

void build_elements_v4(Building& b, const ElementTags& tags) {
    b.file.element_dimensions.clear();
    b.file.element_entities.clear();
    for (Index c = 0; c < b.file.cells.count(); ++c) {
        const GmshType* type = gmsh_type_of(b.file.cells.types[c], b.file.cells.cell(c).size());
        const std::int32_t dimension = i32_at(tags.dimension, c, type->dimension);
        b.file.element_dimensions.push_back(
            dimension >= 0 && dimension <= 3 ? dimension : std::int32_t{type->dimension});
        b.file.element_entities.push_back(i32_at(tags.geometrical, c, kDefaultEntity));
    }
}

void read_entities_note(Building& b) {
    const Note* note = find_note(b.mesh, kGmshEntities);
    if (!note) return;
    MshInput in(TextReader(note->text, kGmshEntities, {'\0', false}));
    if (!read_entities(in, b.file.entities)) {
        b.file.entities = {};
        return;
    }
    b.file.has_entities = true;
    b.left_out.take_notes(kGmshEntities);
}

// Chooses the version and fills what it has for elements.
void build_elements(Building& b) {
    const ElementTags tags{find_column(b.cell_data, kGmshPhysical),
                           find_column(b.cell_data, kGmshGeometrical),
                           find_column(b.cell_data, kGmshElementDimension),
                           find_column(b.cell_data, kGmshElement, Scalar::i64)};
    const Note* version = find_note(b.mesh, kGmshVersion);
    b.file.version_4 = !version || !version->text.starts_with("2");
    b.left_out.take_notes(kGmshVersion);
    build_element_tags(b, tags.element);
    if (b.file.version_4) {
        build_elements_v4(b, tags);
        read_entities_note(b);
        bool agrees = true;
        if (b.file.has_entities) {
            agrees = entities_agree(b, tags);
        } else if (tags.physical) {
            agrees = derive_entities(b, tags, b.file.entities);
            b.file.has_entities = agrees;
            // Only version 2 can give the elements of one entity several physical tags.
            if (!agrees && !version) b.file.version_4 = false;
        }
        if (agrees) b.take(tags.physical);
    }
    if (b.file.version_4) {
        b.take(tags.geometrical);
        b.take(tags.dimension);
    } else {
        build_columns_v2(b);
    }
}

// The header kept for the `occurrence`-th data of this name.
std::string header_of(Building& b, const std::string& key, std::size_t occurrence) {
    for (const Note& note : b.mesh.notes) {
        if (note.key != key || occurrence-- != 0) continue;
        b.left_out.take_notes(key);
        return note.text;
    }
    return {};
}

// Data are doubles, and names stand on one line.
bool can_be_data(const std::string& name, const Array& values) {
    if (name.find('\n') != std::string::npos || values.arity == 0) return false;
    if (is_float(values.scalar) || size_of(values.scalar) < 8) return true;
    constexpr double kExact = 9007199254740992.0;
    for (std::size_t i = 0; i < values.count() * values.arity; ++i) {
        if (std::abs(real_at(values, i)) >= kExact) return false;
    }
    return true;
}

void add_data(Building& b, Place place, const std::string& name, const Array& values,
              std::span<const Index> index, const std::vector<Index>& tags) {
    const bool on_nodes = place == Place::point;
    MshData data{place, name, {}, {}, {values.scalar, values.arity, {}}};
    std::size_t occurrence = 0;
    for (const MshData& other : b.file.data) {
        occurrence += other.place == place && other.name == name;
    }
    data.header = header_of(b, (on_nodes ? kGmshNodeData : kGmshElementData) + name, occurrence);
    for (Index i = 0; i < tags.size(); ++i) {
        const Index tuple = index.empty() ? i : index[i];
        if (tuple == kNoIndex) continue;
        data.tags.push_back(tags[i]);
        const auto from =
            values.bytes.begin() + static_cast<std::ptrdiff_t>(tuple * values.stride());
        data.values.bytes.insert(data.values.bytes.end(), from,
                                 from + static_cast<std::ptrdiff_t>(values.stride()));
    }
    if (data.values.scalar != type_when_read(data.values, b.file.binary)) {
        b.file.types.push_back({on_nodes ? "NodeData" : "ElementData", data.values.scalar, name});
    }
    b.file.data.push_back(std::move(data));
}

bool is_node_tag(const std::string& name) {
    return name == kGmshNode || name == kGmshEntityDimension || name == kGmshEntityTag ||
           name == kGmshParametric;
}

void build_data(Building& b) {
    for (const Attribute& attribute : b.mesh.attributes) {
        if (attribute.place != Place::point || is_node_tag(attribute.name) ||
            !can_be_data(attribute.name, attribute.values)) {
            continue;
        }
        add_data(b, Place::point, attribute.name, attribute.values, attribute.index,
                 b.file.node_tags);
        b.left_out.take(&attribute);
    }
    for (const CellData& data : b.cell_data) {
        if (b.used.count(&data) || data.name == kGmshElement || data.name == kGmshPhysical ||
            !can_be_data(data.name, data.values)) {
            continue;
        }
        add_data(b, Place::cell, data.name, data.values, data.index, b.file.element_tags);
        b.take(&data);
    }
}

void build_sections(Building& b) {
    for (const Note& note : b.mesh.notes) {
        for (const bool binary : {false, true}) {
            const std::string kept = binary ? kGmshBinarySection : kGmshSection;
            if (!note.key.starts_with(kept)) continue;
            // Gmsh's own sections are other bytes in text than in binary files.
            const std::string name = note.key.substr(kept.size());
            if (has_binary_form(name) && binary != b.file.binary) continue;
            if (!can_be_section(name, note.text, b.file.binary)) continue;
            b.file.sections.push_back({name, note.text, binary});
            b.left_out.take_notes(note.key);
        }
    }
}

}  // namespace

Result<MshFile> mesh_to_msh(const Mesh& mesh, const std::string& path, bool binary,
                            LeftOut& left_out) {
    Result<CellList> cells = join_cells(mesh, path);
    if (!cells) return cells.error();
    const bool gmsh_order = find_note(mesh, kGmshNodeOrder) != nullptr;
    for (Index c = 0; c < cells->count(); ++c) {
        const std::uint16_t type = cells->types[c];
        const std::size_t size = cells->cell(c).size();
        if (!gmsh_type_of(type, size)) {
            return cannot_hold(path, "Gmsh has no element for a cell of VTK type " +
                                         std::to_string(type) + " with " + std::to_string(size) +
                                         " nodes");
        }
        if (!same_order_in_gmsh(type) && !gmsh_order) {
            return cannot_hold(path,
                               "higher-order cells whose nodes are in VTK's order can't be "
                               "written");
        }
    }
    for (std::size_t i = 0; i < mesh.companions.size(); ++i) left_out.take_block(i);
    left_out.take_notes(kGmshNodeOrder);
    Building b{mesh, {}, left_out, join_cell_data(mesh), {}};
    b.file.binary = binary;
    b.file.cells = std::move(*cells);
    restore_corners(b);
    build_elements(b);
    build_nodes(b);
    if (b.file.positions.scalar != type_when_read(b.file.positions, binary)) {
        b.file.types.push_back({"Nodes", b.file.positions.scalar, ""});
    }
    build_data(b);
    build_sections(b);
    for (const TagName& name : mesh.tag_names) {
        // A name stands on one line, up to the last quote of it.
        if (name.attribute == kGmshPhysical && name.dimension >= 0 &&
            name.name.find('\n') == std::string::npos) {
            b.file.names.push_back(name);
        }
    }
    left_out.take_tag_names(kGmshPhysical);
    return std::move(b.file);
}

}  // namespace ravel::io
