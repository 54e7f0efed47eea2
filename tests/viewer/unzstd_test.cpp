// The web decoder's reader of Zstandard frames beside libzstd.
#include <zstd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <vector>

struct OwnContext;
extern "C" {
std::size_t own_findFrameCompressedSize(const void* from, std::size_t size);
std::size_t own_decompressDCtx(OwnContext* context, void* to, std::size_t capacity,
                               const void* from, std::size_t size);
OwnContext* own_createDCtx();
std::size_t own_freeDCtx(OwnContext* context);
unsigned own_isError(std::size_t code);
}

namespace {

using Bytes = std::vector<std::uint8_t>;
using Random = std::mt19937;

// A byte more than nothing, so that no pointer is null.
template <class F>
std::size_t unpack(const Bytes& frame, Bytes& out, std::size_t size, const F& work) {
    out.assign(size + 1, 0);
    const std::size_t got = work(out.data(), size, frame.data(), frame.size());
    out.resize(size);
    return got;
}
std::size_t own(const Bytes& frame, Bytes& out, std::size_t size) {
    OwnContext* const context = own_createDCtx();
    const std::size_t got = unpack(
        frame, out, size, [&](auto... words) { return own_decompressDCtx(context, words...); });
    own_freeDCtx(context);
    return got;
}
std::size_t theirs(const Bytes& frame, Bytes& out, std::size_t size) {
    return unpack(frame, out, size, [](auto... words) { return ZSTD_decompress(words...); });
}

Bytes pack(const Bytes& data, int level, Random& random) {
    ZSTD_CCtx* const context = ZSTD_createCCtx();
    ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, static_cast<int>(random() % 2));
    ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, static_cast<int>(random() % 2));
    if (random() % 4 == 0)
        ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, 10 + static_cast<int>(random() % 8));
    Bytes frame(ZSTD_compressBound(data.size()));
    const std::size_t size =
        ZSTD_compress2(context, frame.data(), frame.size(), data.data(), data.size());
    ZSTD_freeCCtx(context);
    REQUIRE_FALSE(ZSTD_isError(size));
    frame.resize(size);
    frame.shrink_to_fit();
    return frame;
}

// Runs, few symbols, many symbols, skewed ones, far and near repetitions: every kind of block,
// literal and table.
std::vector<Bytes> samples(Random& random) {
    std::vector<Bytes> all;
    for (const std::size_t size :
         {0, 1, 2, 3, 5, 17, 100, 255, 256, 257, 1000, 5000, 65535, 131072, 131073, 400000})
        for (int kind = 0; kind < 6; ++kind) {
            Bytes data(size);
            const auto most = 1 + static_cast<unsigned>(random() % 255);
            for (std::uint8_t& x : data) {
                const auto any = static_cast<unsigned>(random());
                x = static_cast<std::uint8_t>(kind == 0   ? 0
                                              : kind == 1 ? any % most
                                              : kind == 2
                                                  ? (any % 16 > 0 ? 'a' : 'b' + any / 16 % 5)
                                              : kind == 3 ? any
                                              : kind == 4 ? any & any >> 8 & any >> 16
                                                          : any % 7 * 31);
            }
            for (std::size_t i = 1000; kind == 3 && i < size; ++i)
                if (random() % 500 > 0) data[i] = data[i - 997];
            for (std::size_t i = 64; kind == 5 && i < size; ++i)
                if (random() % 3 > 0) data[i] = data[i - 1 - random() % 63];
            all.push_back(std::move(data));
        }
    return all;
}

}  // namespace

TEST_CASE("frames of every level come out as they went in", "[viewer]") {
    Random random(1);
    for (const Bytes& data : samples(random))
        for (const int level : {-5, 1, 3, 9, 19}) {
            const Bytes frame = pack(data, level, random);
            Bytes out;
            REQUIRE(own_findFrameCompressedSize(frame.data(), frame.size()) == frame.size());
            REQUIRE(own(frame, out, data.size()) == data.size());
            REQUIRE(out == data);
            if (!data.empty()) REQUIRE(own_isError(own(frame, out, data.size() - 1)));
        }
}

TEST_CASE("broken frames are refused, or come out as libzstd has them", "[viewer]") {
    Random random(2);
    int broken = 0, refused_alone = 0, accepted = 0;
    for (const Bytes& data : samples(random)) {
        if (data.size() > 5000) continue;
        for (const int level : {1, 19}) {
            const Bytes frame = pack(data, level, random);
            for (int i = 0; i < 60; ++i) {
                Bytes copy = frame;
                if (i % 3 == 0) copy.resize(random() % frame.size());
                for (auto k = i % 3 == 0 ? 0 : 1 + random() % 3; k > 0; --k)
                    copy[random() % copy.size()] = static_cast<std::uint8_t>(random());
                copy.shrink_to_fit();
                const bool whole =
                    ZSTD_findFrameCompressedSize(copy.data(), copy.size()) == copy.size();
                REQUIRE((own_findFrameCompressedSize(copy.data(), copy.size()) == copy.size()) ==
                        whole);
                if (!whole) continue;  // codec/entropy asks this first
                Bytes ours, others;
                const std::size_t our_size = own(copy, ours, data.size());
                const std::size_t other_size = theirs(copy, others, data.size());
                ++broken;
                // libzstd's fast loops do not ask whether a Huffman stream ends where it must.
                if (own_isError(our_size)) {
                    refused_alone += !ZSTD_isError(other_size);
                    continue;
                }
                ++accepted;
                REQUIRE(our_size == other_size);
                REQUIRE(ours == others);
            }
        }
    }
    CHECK(accepted > 100);
    CHECK(refused_alone < broken / 10);
}
