#include "io/left_out.h"

#include <algorithm>

namespace ravel::io {

LeftOut::LeftOut(const Mesh& mesh, std::string format)
    : mesh_(mesh),
      format_(std::move(format)),
      attributes_(mesh.attributes.size()),
      blocks_(mesh.companions.size()),
      tag_names_(mesh.tag_names.size()),
      notes_(mesh.notes.size()) {}

void LeftOut::take(const Attribute* attribute) {
    if (attribute)
        attributes_[static_cast<std::size_t>(attribute - mesh_.attributes.data())] = true;
}

void LeftOut::take_block(std::size_t companion_block) {
    blocks_[companion_block] = true;
}

void LeftOut::take_tag_names(std::string_view attribute) {
    for (std::size_t i = 0; i < tag_names_.size(); ++i)
        if (mesh_.tag_names[i].attribute == attribute) tag_names_[i] = true;
}

void LeftOut::take_notes(std::string_view key) {
    for (std::size_t i = 0; i < notes_.size(); ++i)
        if (mesh_.notes[i].key == key) notes_[i] = true;
}

void LeftOut::say(std::string sentence) {
    said_.push_back(std::move(sentence));
}

void LeftOut::report(std::vector<std::string>* sentences) const {
    if (!sentences) return;
    const std::string no_place = " has no place in " + format_;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const CompanionBlock& block = mesh_.companions[b];
        if (!blocks_[b] && block.cell_count != 0)
            sentences->push_back("companion block " + std::to_string(b) + " (" +
                                 std::to_string(block.cell_count) + " cells of VTK type " +
                                 std::to_string(block.vtk_type) + ")" + no_place);
    }
    for (std::size_t a = 0; a < attributes_.size(); ++a)
        if (!attributes_[a])
            sentences->push_back(std::string(name_of(mesh_.attributes[a].place)) + " attribute \"" +
                                 mesh_.attributes[a].name + "\"" + no_place);
    // Names of a tag are many; one sentence for all of them is enough.
    std::vector<std::string> tags;
    for (std::size_t i = 0; i < tag_names_.size(); ++i)
        if (!tag_names_[i]) tags.push_back(mesh_.tag_names[i].attribute);
    std::sort(tags.begin(), tags.end());
    tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
    for (const std::string& tag : tags)
        sentences->push_back("the names of \"" + tag + "\" have no place in " + format_);
    for (std::size_t n = 0; n < notes_.size(); ++n)
        if (!notes_[n]) sentences->push_back("note \"" + mesh_.notes[n].key + "\"" + no_place);
    sentences->insert(sentences->end(), said_.begin(), said_.end());
}

Error cannot_hold(const std::string& path, const std::string& sentence) {
    return {Code::unwritable, 0, path + ": " + sentence};
}

}  // namespace ravel::io
