// What codec/entropy calls of libzstd. In the module unzstd.cpp answers for the reader's half, in a
// fifth of the library's size; the writer's half is dropped by the linker.
#pragma once

#include <cstddef>

using ZSTD_CCtx = struct ZSTD_CCtx_s;
using ZSTD_DCtx = struct ZSTD_DCtx_s;
enum ZSTD_cParameter {
    ZSTD_c_compressionLevel = 100,
    ZSTD_c_contentSizeFlag = 200,
    ZSTD_c_checksumFlag = 201,
};

extern "C" {
std::size_t ZSTD_findFrameCompressedSize(const void* from, std::size_t size);
ZSTD_DCtx* ZSTD_createDCtx();
std::size_t ZSTD_freeDCtx(ZSTD_DCtx* context);
std::size_t ZSTD_decompressDCtx(ZSTD_DCtx* context, void* to, std::size_t capacity,
                                const void* from, std::size_t size);
unsigned ZSTD_isError(std::size_t code);

ZSTD_CCtx* ZSTD_createCCtx();
std::size_t ZSTD_freeCCtx(ZSTD_CCtx* context);
std::size_t ZSTD_compressBound(std::size_t size);
std::size_t ZSTD_CCtx_setParameter(ZSTD_CCtx* context, ZSTD_cParameter parameter, int value);
std::size_t ZSTD_compress2(ZSTD_CCtx* context, void* to, std::size_t capacity, const void* from,
                           std::size_t size);
}
