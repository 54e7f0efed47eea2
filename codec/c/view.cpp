// Views of a mesh: its arrays as they lie in memory, its names and blocks.
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

#include "c/handle.h"

namespace ravel::c {
namespace {

ravel_array view_of(const Array& array) {
    return {array.count(), array.stride(), array.arity, static_cast<std::uint32_t>(array.scalar),
            array.bytes.empty() ? nullptr : array.bytes.data()};
}

ravel_array view_of(const std::vector<Index>& list, std::uint32_t arity) {
    if (list.empty() || arity == 0) return {0, 8, arity, RAVEL_U64, nullptr};
    return {list.size() / arity, std::uint64_t{8} * arity, arity, RAVEL_U64, list.data()};
}

// One field of every step; a bool is a byte, 0 or 1.
template <class Field>
ravel_array column_of(const std::vector<StripStep>& steps, Field StripStep::*field) {
    static_assert(!std::is_same_v<Field, bool> || sizeof(bool) == 1);
    const std::uint32_t scalar = sizeof(Field) == 8   ? RAVEL_U64
                                 : sizeof(Field) == 4 ? RAVEL_U32
                                                      : RAVEL_U8;
    return {steps.size(), sizeof(StripStep), 1, scalar,
            steps.empty() ? nullptr : &(steps[0].*field)};
}

ravel_text text_of(const std::string& text) {
    return {text.c_str(), text.size()};
}

// The caller asked for number `which` of `count`.
int none_such(ravel_error* error, const char* what, std::uint64_t which, std::uint64_t count) {
    return fail(error, RAVEL_BAD_ARGUMENT,
                std::string(what) + " " + std::to_string(which) + " of " + std::to_string(count),
                which);
}

int null_argument(ravel_error* error) {
    return fail(error, RAVEL_BAD_ARGUMENT, "an argument is NULL that must not be");
}

int find_array(const ravel_mesh& handle, int part, std::uint64_t which, ravel_array& out,
               ravel_error* error) {
    const Mesh& mesh = handle.mesh;
    const bool of_block = part == RAVEL_COMPANION_NODES || part == RAVEL_COMPANION_HOSTS;
    const bool of_attribute = part == RAVEL_ATTRIBUTE_VALUES || part == RAVEL_ATTRIBUTE_INDEX;
    if (of_block && which >= mesh.companions.size())
        return none_such(error, "companion block", which, mesh.companions.size());
    if (of_attribute && which >= mesh.attributes.size())
        return none_such(error, "attribute", which, mesh.attributes.size());
    if (!of_block && !of_attribute && which != 0) return none_such(error, "array", which, 1);
    switch (part) {
        case RAVEL_POSITIONS:
            out = view_of(mesh.positions);
            break;
        case RAVEL_CORNERS:
            out = view_of(mesh.corners, mesh.kind == CellKind::tet ? 4 : 1);
            break;
        case RAVEL_CORNER_BEGIN:
            out = view_of(mesh.corner_begin, 1);
            break;
        case RAVEL_COMPANION_NODES:
            out = view_of(mesh.companions[which].nodes, mesh.companions[which].nodes_per_cell);
            break;
        case RAVEL_COMPANION_HOSTS:
            out = view_of(mesh.companions[which].hosts, 1);
            break;
        case RAVEL_ATTRIBUTE_VALUES:
            out = view_of(mesh.attributes[which].values);
            break;
        case RAVEL_ATTRIBUTE_INDEX:
            out = view_of(mesh.attributes[which].index, 1);
            break;
        case RAVEL_STRIP_CELL:
            out = column_of(handle.steps, &StripStep::cell);
            break;
        case RAVEL_STRIP_FROM:
            out = column_of(handle.steps, &StripStep::from);
            break;
        case RAVEL_STRIP_EXIT:
            out = column_of(handle.steps, &StripStep::exit);
            break;
        case RAVEL_STRIP_ENTRY:
            out = column_of(handle.steps, &StripStep::entry);
            break;
        case RAVEL_STRIP_LINK:
            out = column_of(handle.steps, &StripStep::link);
            break;
        case RAVEL_STRIP_POSITION:
            return fail(error, RAVEL_BAD_ARGUMENT,
                        "RAVEL_STRIP_POSITION can be copied, not viewed");
        default:
            return none_such(error, "part", static_cast<std::uint64_t>(part), 13);
    }
    return RAVEL_DONE;
}

}  // namespace
}  // namespace ravel::c

using namespace ravel;
using namespace ravel::c;

extern "C" {

void ravel_summary_init(ravel_summary* summary, std::size_t struct_size) {
    initialise(summary, struct_size, ravel_summary{});
}

int ravel_mesh_summary(const ravel_mesh* mesh, ravel_summary* summary, ravel_error* error) {
    if (mesh == nullptr || summary == nullptr) return null_argument(error);
    ravel_summary s{};
    s.kind = static_cast<std::uint32_t>(mesh->mesh.kind);
    s.points = mesh->mesh.point_count();
    s.cells = mesh->mesh.cell_count();
    s.corners = mesh->mesh.corners.size();
    s.companion_blocks = mesh->mesh.companions.size();
    s.attributes = mesh->mesh.attributes.size();
    s.position_scalar = static_cast<std::uint32_t>(mesh->mesh.positions.scalar);
    give_fields(s, summary);
    return RAVEL_DONE;
}

int ravel_mesh_array(const ravel_mesh* mesh, int part, uint64_t which, ravel_array* array,
                     ravel_error* error) {
    if (mesh == nullptr || array == nullptr) return null_argument(error);
    *array = {};
    return guarded(error, [&] { return find_array(*mesh, part, which, *array, error); });
}

int ravel_mesh_companion(const ravel_mesh* mesh, uint64_t block, ravel_companion* companion,
                         ravel_error* error) {
    if (mesh == nullptr || companion == nullptr) return null_argument(error);
    const auto& blocks = mesh->mesh.companions;
    if (block >= blocks.size())
        return guarded(error,
                       [&] { return none_such(error, "companion block", block, blocks.size()); });
    const CompanionBlock& b = blocks[block];
    *companion = {b.vtk_type, b.nodes_per_cell, b.cell_count, b.hosts.empty() ? 0u : 1u, 0};
    return RAVEL_DONE;
}

int ravel_mesh_attribute(const ravel_mesh* mesh, uint64_t number, ravel_attribute* attribute,
                         ravel_error* error) {
    if (mesh == nullptr || attribute == nullptr) return null_argument(error);
    const auto& all = mesh->mesh.attributes;
    if (number >= all.size())
        return guarded(error, [&] { return none_such(error, "attribute", number, all.size()); });
    const Attribute& a = all[number];
    *attribute = {text_of(a.name),
                  a.values.count(),
                  static_cast<std::uint32_t>(a.place),
                  static_cast<std::uint32_t>(a.values.scalar),
                  a.values.arity,
                  a.index.empty() ? 0u : 1u,
                  static_cast<std::uint32_t>(a.references.size()),
                  0};
    return RAVEL_DONE;
}

int64_t ravel_mesh_find_attribute(const ravel_mesh* mesh, int place, const char* name) {
    if (mesh == nullptr || name == nullptr) return -1;
    const auto& all = mesh->mesh.attributes;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (static_cast<int>(all[i].place) == place && all[i].name == name)
            return static_cast<std::int64_t>(i);
    return -1;
}

int ravel_mesh_reference(const ravel_mesh* mesh, uint64_t attribute, uint32_t number,
                         ravel_reference* reference, ravel_error* error) {
    if (mesh == nullptr || reference == nullptr) return null_argument(error);
    const auto& all = mesh->mesh.attributes;
    return guarded(error, [&]() -> int {
        if (attribute >= all.size()) return none_such(error, "attribute", attribute, all.size());
        const auto& references = all[attribute].references;
        if (number >= references.size())
            return none_such(error, "reference", number, references.size());
        const Reference& r = references[number];
        *reference = {r.component, static_cast<std::uint32_t>(r.place), r.base};
        return RAVEL_DONE;
    });
}

uint64_t ravel_mesh_tag_names(const ravel_mesh* mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.tag_names.size();
}

int ravel_mesh_tag_name(const ravel_mesh* mesh, uint64_t number, ravel_tag_name* name,
                        ravel_error* error) {
    if (mesh == nullptr || name == nullptr) return null_argument(error);
    const auto& all = mesh->mesh.tag_names;
    if (number >= all.size())
        return guarded(error, [&] { return none_such(error, "tag name", number, all.size()); });
    const TagName& n = all[number];
    *name = {text_of(n.attribute), text_of(n.name), n.value, n.dimension, 0};
    return RAVEL_DONE;
}

uint64_t ravel_mesh_notes(const ravel_mesh* mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.notes.size();
}

int ravel_mesh_note(const ravel_mesh* mesh, uint64_t number, ravel_note* note, ravel_error* error) {
    if (mesh == nullptr || note == nullptr) return null_argument(error);
    const auto& all = mesh->mesh.notes;
    if (number >= all.size())
        return guarded(error, [&] { return none_such(error, "note", number, all.size()); });
    *note = {text_of(all[number].key), text_of(all[number].text)};
    return RAVEL_DONE;
}
}
