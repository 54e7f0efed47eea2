// Ravel itself, by its public interface alone.
#include <algorithm>

#include "compare/contender.h"

namespace ravel::compare {
namespace {

std::string refuses(const Input&) {
    return {};
}

Result<Packed> encode_ours(const Input& input) {
    auto encoded = ravel::encode(input.mesh, input.options);
    if (!encoded) return encoded.error();
    auto info = inspect(encoded->bytes);
    if (!info) return info.error();
    Packed packed;
    packed.connectivity_bytes = packed.geometry_bytes = packed.attribute_bytes = 0;
    for (const SectionInfo& section : info->sections) {
        constexpr const char* kConnectivity[] = {"connectivity", "repairs", "strip", "order"};
        const bool connectivity = std::find(std::begin(kConnectivity), std::end(kConnectivity),
                                            section.name) != std::end(kConnectivity);
        if (connectivity)
            *packed.connectivity_bytes += section.bytes;
        else if (section.name == "positions")
            *packed.geometry_bytes += section.bytes;
        else
            *packed.attribute_bytes += section.bytes;
    }
    packed.connectivity_ideal_bytes = encoded->connectivity_ideal_bytes;
    packed.bytes = std::move(encoded->bytes);
    packed.order = std::move(encoded->order);
    packed.bound = encoded->position_bound;
    packed.attribute_bounds = std::move(encoded->attribute_bounds);
    return packed;
}

Result<Mesh> decode_ours(std::span<const std::byte> bytes, const Input&) {
    auto decoded = ravel::decode(bytes);
    if (!decoded) return decoded.error();
    return std::move(decoded->mesh);
}

Verdict check_ours(const Input& input, const Packed& packed, const Mesh& decoded) {
    const Comparison found =
        compare_meshes(input.mesh, decoded, packed.order, packed.bound, packed.attribute_bounds);
    Verdict verdict;
    verdict.max_error = found.max_error;
    if (found.connectivity_equal) verdict.connectivity_kept = kept_word(input.mesh.kind);
    if (!found.equal) verdict.note = "differs: " + found.difference;
    return verdict;
}

}  // namespace

Contender ours() {
    return {"ravel", "", refuses, encode_ours, decode_ours, check_ours};
}

}  // namespace ravel::compare
