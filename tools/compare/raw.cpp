// General compressors: zstd -19 and xz -9 on the raw arrays, and xz -9 on grid numbers and on byte
// planes of their differences.
#include "compare/raw.h"

#include <lzma.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ravel::compare {
namespace {

constexpr int kZstdLevel = 19;
constexpr std::uint32_t kXzLevel = 9;

Error failed(const char* what) {
    return {Code::corrupt, 0, what};
}

Result<std::vector<std::byte>> pack_zstd(std::span<const std::byte> raw) {
    std::vector<std::byte> packed(ZSTD_compressBound(raw.size()));
    const std::size_t size =
        ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), kZstdLevel);
    if (ZSTD_isError(size)) return failed("zstd failed");
    packed.resize(size);
    return packed;
}

Result<std::vector<std::byte>> unpack_zstd(std::span<const std::byte> packed) {
    const auto size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
        return failed("no zstd frame");
    std::vector<std::byte> raw(size);
    const std::size_t got = ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size());
    if (ZSTD_isError(got) || got != raw.size()) return failed("zstd failed");
    return raw;
}

Result<std::vector<std::byte>> pack_xz(std::span<const std::byte> raw) {
    std::vector<std::byte> packed(lzma_stream_buffer_bound(raw.size()));
    std::size_t size = 0;
    const lzma_ret result = lzma_easy_buffer_encode(
        kXzLevel, LZMA_CHECK_CRC32, nullptr, reinterpret_cast<const std::uint8_t*>(raw.data()),
        raw.size(), reinterpret_cast<std::uint8_t*>(packed.data()), &size, packed.size());
    if (result != LZMA_OK) return failed("xz failed");
    packed.resize(size);
    return packed;
}

Result<std::vector<std::byte>> unpack_xz(std::span<const std::byte> packed, std::size_t raw_size) {
    std::vector<std::byte> raw(raw_size);
    std::uint64_t memory = ~std::uint64_t{0};
    std::size_t in = 0, out = 0;
    const lzma_ret result = lzma_stream_buffer_decode(
        &memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &in,
        packed.size(), reinterpret_cast<std::uint8_t*>(raw.data()), &out, raw.size());
    if (result != LZMA_OK || out != raw_size) return failed("xz failed");
    return raw;
}

template <Layout layout>
std::string refuses(const Input& input) {
    if (input.mesh.point_count() > 0xffffffffu) return "more points than 32 bits count";
    if (layout != Layout::raw && input.grid && !all_finite(input.mesh))
        return "positions that are no numbers have no place on a grid";
    return {};
}

Packed with_bytes(std::vector<std::byte> bytes) {
    Packed packed;
    packed.bytes = std::move(bytes);
    return packed;
}

Result<Packed> encode_zstd(const Input& input) {
    auto bytes = pack_zstd(arrays_of(input, Layout::raw));
    if (!bytes) return bytes.error();
    return with_bytes(std::move(*bytes));
}

template <Layout layout>
Result<Packed> encode_xz(const Input& input) {
    auto bytes = pack_xz(arrays_of(input, layout));
    if (!bytes) return bytes.error();
    return with_bytes(std::move(*bytes));
}

Result<Mesh> decode_zstd(std::span<const std::byte> bytes, const Input& input) {
    auto raw = unpack_zstd(bytes);
    if (!raw) return raw.error();
    return mesh_of_arrays(*raw, input, Layout::raw);
}

template <Layout layout>
Result<Mesh> decode_xz(std::span<const std::byte> bytes, const Input& input) {
    auto raw = unpack_xz(bytes, arrays_size(input, layout));
    if (!raw) return raw.error();
    return mesh_of_arrays(*raw, input, layout);
}

template <Layout layout>
Verdict check_raw(const Input& input, const Packed&, const Mesh& decoded) {
    Verdict verdict;
    const Mesh& mesh = input.mesh;
    if (mesh.corners != decoded.corners || mesh.corner_begin != decoded.corner_begin ||
        mesh.point_count() != decoded.point_count()) {
        verdict.note = "came back different";
        return verdict;
    }
    verdict.connectivity_kept = kept_word(mesh.kind);
    if (!input.grid || layout == Layout::raw) {
        if (mesh.positions.bytes != decoded.positions.bytes) verdict.note = "positions differ";
        return verdict;
    }
    for (Index p = 0; p < mesh.point_count(); ++p)
        for (int k = 0; k < 3; ++k)
            verdict.max_error = std::max(
                verdict.max_error, std::fabs(coordinate(mesh, p, k) - coordinate(decoded, p, k)));
    return verdict;
}

}  // namespace

Contender raw_zstd() {
    return {"zstd",
            "-19, raw arrays, exact positions",
            refuses<Layout::raw>,
            encode_zstd,
            decode_zstd,
            check_raw<Layout::raw>};
}
Contender raw_xz() {
    return {"xz",
            "-9, raw arrays, exact positions",
            refuses<Layout::raw>,
            encode_xz<Layout::raw>,
            decode_xz<Layout::raw>,
            check_raw<Layout::raw>};
}
Contender grid_xz() {
    return {"xz-grid",
            "-9, arrays with positions on the grid",
            refuses<Layout::plain>,
            encode_xz<Layout::plain>,
            decode_xz<Layout::plain>,
            check_raw<Layout::plain>};
}
Contender delta_xz() {
    return {"delta-xz",
            "-9, byte planes of differences",
            refuses<Layout::planes>,
            encode_xz<Layout::planes>,
            decode_xz<Layout::planes>,
            check_raw<Layout::planes>};
}

}  // namespace ravel::compare
