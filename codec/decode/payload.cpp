#include "decode/payload.h"

namespace ravel {
namespace {

Status corrupt(const ByteReader& in, const char* why) {
    return Error{Code::corrupt, in.at(), why};
}

Status check_end(const ByteReader& in) {
    if (!in.ok()) return corrupt(in, "a section ends before its data do");
    if (in.left() != 0) return corrupt(in, "a section is longer than its data");
    return Done{};
}

}  // namespace

Status read_names(ByteReader& in, Mesh& mesh) {
    const std::uint64_t names = in.varint();
    if (names > in.left() / 4) return corrupt(in, "more names than there are bytes");
    mesh.tag_names.reserve(names);
    for (std::uint64_t i = 0; i < names && in.ok(); ++i) {
        TagName name;
        name.attribute = in.text();
        const std::int64_t dimension = unzigzag(in.varint());
        if (dimension < -1 || dimension > 3)
            return corrupt(in, "a name of a dimension that does not exist");
        name.dimension = static_cast<std::int32_t>(dimension);
        name.value = unzigzag(in.varint());
        name.name = in.text();
        mesh.tag_names.push_back(std::move(name));
    }
    const std::uint64_t notes = in.varint();
    if (notes > in.left() / 2) return corrupt(in, "more notes than there are bytes");
    mesh.notes.reserve(notes);
    for (std::uint64_t i = 0; i < notes && in.ok(); ++i) {
        Note note;
        note.key = in.text();
        note.text = in.text();
        mesh.notes.push_back(std::move(note));
    }
    return check_end(in);
}

}  // namespace ravel
