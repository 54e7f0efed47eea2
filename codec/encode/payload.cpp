#include "encode/payload.h"

namespace ravel {
Bytes write_names(const Mesh& mesh) {
    ByteWriter out;
    out.varint(mesh.tag_names.size());
    for (const TagName& name : mesh.tag_names) {
        out.text(name.attribute);
        out.varint(zigzag(name.dimension));
        out.varint(zigzag(name.value));
        out.text(name.name);
    }
    out.varint(mesh.notes.size());
    for (const Note& note : mesh.notes) {
        out.text(note.key);
        out.text(note.text);
    }
    return out.take();
}

}  // namespace ravel
