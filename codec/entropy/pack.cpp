#include "entropy/pack.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>

namespace ravel {
namespace {

struct FreeContext {
    void operator()(ZSTD_CCtx* c) const { ZSTD_freeCCtx(c); }
    void operator()(ZSTD_DCtx* c) const { ZSTD_freeDCtx(c); }
};

}  // namespace

Bytes pack(std::span<const std::byte> raw, int level) {
    const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
    Bytes packed(ZSTD_compressBound(raw.size()));
    if (!context) return {};
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_contentSizeFlag, 0);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 0);
    const std::size_t size =
        ZSTD_compress2(context.get(), packed.data(), packed.size(), raw.data(), raw.size());
    if (ZSTD_isError(size)) return {};
    packed.resize(size);
    return packed;
}

Result<Bytes> unpack(std::span<const std::byte> packed, std::uint64_t raw_size, std::uint64_t at) {
    // One frame and nothing else: the library would also take several, skippable ones and old
    // formats.
    constexpr std::array<std::byte, 4> kFrame{std::byte{0x28}, std::byte{0xB5}, std::byte{0x2F},
                                              std::byte{0xFD}};
    if (packed.size() < kFrame.size() ||
        !std::equal(kFrame.begin(), kFrame.end(), packed.begin()) ||
        ZSTD_findFrameCompressedSize(packed.data(), packed.size()) != packed.size())
        return Error{Code::corrupt, at, "a packed section is not one zstd frame"};
    const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
    if (!context) return Error{Code::limit_exceeded, at, "out of memory while unpacking a section"};
    Bytes raw(static_cast<std::size_t>(raw_size));
    const std::size_t size =
        ZSTD_decompressDCtx(context.get(), raw.data(), raw.size(), packed.data(), packed.size());
    if (ZSTD_isError(size))
        return Error{Code::corrupt, at, "a packed section is broken: zstd can't unpack it"};
    if (size != raw.size())
        return Error{Code::corrupt, at, "a packed section holds fewer bytes than its header says"};
    return raw;
}

// A block of zstd holds at most 128 KiB and takes at least 4 bytes (a run of one byte).
std::uint64_t most_unpacked(std::uint64_t packed) {
    constexpr std::uint64_t kBlock = 128 * 1024;
    const std::uint64_t blocks = packed / 4 + 1;
    return blocks > (~std::uint64_t{0}) / kBlock ? ~std::uint64_t{0} : blocks * kBlock;
}

}  // namespace ravel
