#include "decoder/describe.h"

#include <cstring>

#include "decoder/surface.h"

namespace ravel::web {
namespace {

// The first half of the vector's own memory, as 32-bit numbers.
void put_narrow(std::vector<Index>& indices, Reply& reply) {
    auto* out = reinterpret_cast<std::byte*>(indices.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        // Reads index i before anything at or behind it is written.
        const auto narrow = static_cast<std::uint32_t>(indices[i]);
        std::memcpy(out + 4 * i, &narrow, 4);
    }
    reply.array(out, 4 * indices.size());
}

void put(const Array& array, Reply& reply) {
    reply.number(static_cast<double>(array.scalar));
    reply.number(array.arity);
    reply.array(array.bytes.data(), array.bytes.size());
}

template <class Field>
void put_steps(const std::vector<StripStep>& steps, std::vector<Bytes>& more, Reply& reply,
               const Field& field) {
    Bytes& list = more.emplace_back(4 * steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto value = static_cast<std::uint32_t>(field(steps[i]));
        std::memcpy(list.data() + 4 * i, &value, 4);
    }
    reply.array(list.data(), list.size());
}

template <class T>
void put_moved(const std::vector<T>& list, std::vector<Bytes>& more, Reply& reply) {
    Bytes& bytes = more.emplace_back(sizeof(T) * list.size());
    if (!list.empty()) std::memcpy(bytes.data(), list.data(), bytes.size());
    reply.array(bytes.data(), bytes.size());
}

void put_attribute(Attribute& attribute, Reply& reply) {
    reply.text(attribute.name);
    reply.text(name_of(attribute.place));
    put(attribute.values, reply);
    reply.number(attribute.index.empty() ? 0 : 1);
    put_narrow(attribute.index, reply);
    reply.number(static_cast<double>(attribute.references.size()));
    for (const Reference& reference : attribute.references) {
        reply.number(reference.component);
        reply.text(name_of(reference.place));
        reply.number(static_cast<double>(reference.base));
    }
}

}  // namespace

void describe(const Error& error, Reply& reply) {
    reply.text(name_of(error.code));
    reply.number(static_cast<double>(error.at));
    reply.text(error.detail);
}

void describe(const FileInfo& info, Reply& reply) {
    reply.text({});
    reply.text(name_of(info.kind));
    reply.text(name_of(info.position_scalar));
    for (const double x :
         {static_cast<double>(info.version), static_cast<double>(info.points),
          static_cast<double>(info.cells), static_cast<double>(info.corners),
          static_cast<double>(info.companions), static_cast<double>(info.components),
          static_cast<double>(info.links), static_cast<double>(info.lossless_positions),
          static_cast<double>(info.keeps_order), static_cast<double>(info.position_bits),
          info.grid_step, info.position_bound, info.position_error,
          static_cast<double>(info.file_bytes), static_cast<double>(info.header_bytes)})
        reply.number(x);
    reply.number(static_cast<double>(info.sections.size()));
    for (const SectionInfo& section : info.sections) {
        reply.text(section.name);
        reply.number(static_cast<double>(section.bytes));
        reply.number(static_cast<double>(section.raw_bytes));
    }
    reply.number(static_cast<double>(info.attributes.size()));
    for (const auto& attribute : info.attributes) {
        reply.text(attribute.name);
        reply.text(name_of(attribute.place));
        reply.text(name_of(attribute.scalar));
        reply.number(attribute.arity);
    }
}

void describe(Decoded& decoded, const Wanted& wanted, std::vector<Bytes>& more, Reply& reply) {
    Mesh& mesh = decoded.mesh;
    reply.text({});
    reply.text(name_of(mesh.kind));
    reply.number(static_cast<double>(mesh.cell_count()));
    put(mesh.positions, reply);
    put_narrow(mesh.corners, reply);
    put_narrow(mesh.corner_begin, reply);
    reply.number(static_cast<double>(mesh.companions.size()));
    for (CompanionBlock& block : mesh.companions) {
        reply.number(block.vtk_type);
        reply.number(block.nodes_per_cell);
        reply.number(static_cast<double>(block.cell_count));
        put_narrow(block.nodes, reply);
        put_narrow(block.hosts, reply);
    }
    reply.number(static_cast<double>(mesh.attributes.size()));
    for (Attribute& attribute : mesh.attributes) put_attribute(attribute, reply);
    reply.number(static_cast<double>(mesh.tag_names.size()));
    for (const TagName& tag : mesh.tag_names) {
        reply.text(tag.attribute);
        reply.number(tag.dimension);
        reply.number(static_cast<double>(tag.value));
        reply.text(tag.name);
    }
    reply.number(static_cast<double>(mesh.notes.size()));
    for (const Note& note : mesh.notes) {
        reply.text(note.key);
        reply.text(note.text);
    }
    reply.number(wanted.strip ? 1 : 0);
    if (wanted.strip) {
        const auto& steps = decoded.steps;
        put_steps(steps, more, reply, [](const StripStep& s) { return s.cell; });
        put_steps(steps, more, reply, [](const StripStep& s) { return s.from; });
        put_steps(steps, more, reply, [](const StripStep& s) { return s.exit; });
        put_steps(steps, more, reply, [](const StripStep& s) { return s.entry; });
        put_steps(steps, more, reply, [](const StripStep& s) { return s.link; });
    }
    decoded.steps = std::vector<StripStep>();
    const bool surface = wanted.surface && mesh.kind == CellKind::tet;
    reply.number(surface ? 1 : 0);
    if (!surface) return;
    const auto* corners = reinterpret_cast<const std::uint32_t*>(mesh.corners.data());
    const Surface boundary = boundary_of({corners, mesh.corners.size()});
    put_moved(boundary.points, more, reply);
    put_moved(boundary.facets, more, reply);
}

}  // namespace ravel::web
