// Any bytes into the decoder. The mutator takes files apart, changes a section's unpacked bytes and
// fits the checksum, so that most inputs get as far as the walk.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "support/file_parts.h"

namespace {

std::span<const std::byte> view(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const std::byte*>(data), size};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ravel::DecodeOptions options;
    options.memory_limit = std::uint64_t{64} << 20;
    const std::string found = ravel::test::unsafe(view(data, size), options);
    if (!found.empty()) {
        std::fprintf(stderr, "%s\n", found.c_str());
        std::abort();
    }
    return 0;
}

#ifdef RAVEL_LIBFUZZER
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
    auto parts = ravel::test::take_apart(view(data, size));
    if (!parts || parts->empty() || seed % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
    const std::size_t at = seed / 16 % parts->size();
    if (seed % 64 == 1) {
        parts->erase(parts->begin() + static_cast<std::ptrdiff_t>(at));
    } else {
        ravel::Bytes& raw = (*parts)[at].raw;
        const std::size_t old = raw.size();
        raw.resize(old + 64);
        raw.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(raw.data()), old, raw.size()));
    }
    const ravel::Bytes file = ravel::test::put_together(*parts);
    if (file.size() > max_size) return size;
    std::memcpy(data, file.data(), file.size());
    return file.size();
}
#endif
