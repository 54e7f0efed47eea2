// What the decoder hands over to another language: fields one after the other, no padding.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/bytes.h"

namespace ravel::web {

// number: a double, little-endian; text: its size as a number, its bytes; array: its size in bytes
// as a number, then `put_array`'s words on where it is. Doubles hold every count and address
// exactly.
struct Reply {
    Bytes bytes;

    void raw(const void* data, std::size_t size) {
        const std::size_t start = bytes.size();
        bytes.resize(start + size);
        if (size > 0) std::memcpy(bytes.data() + start, data, size);
    }
    void number(double x) { raw(&x, sizeof x); }
    void text(std::string_view s) {
        number(static_cast<double>(s.size()));
        raw(s.data(), s.size());
    }
    void array(const void* data, std::size_t size);
};

// In WebAssembly the address, for the page reads the module's memory; in a file the bytes.
void put_array(Reply& reply, const void* data, std::size_t size);

inline void Reply::array(const void* data, std::size_t size) {
    number(static_cast<double>(size));
    put_array(*this, data, size);
}

}  // namespace ravel::web
