// Bytes out and bounded bytes in. Integers are little-endian; a varint holds seven bits a byte,
// least significant first, the high bit set on all but the last byte, in the shortest form only.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ravel/result.h"

namespace ravel {

using Bytes = std::vector<std::byte>;

inline std::uint64_t zigzag(std::int64_t v) {
    return (static_cast<std::uint64_t>(v) << 1) ^ static_cast<std::uint64_t>(v >> 63);
}
inline std::int64_t unzigzag(std::uint64_t v) {
    return static_cast<std::int64_t>(v >> 1) ^ -static_cast<std::int64_t>(v & 1);
}

inline std::size_t varint_size(std::uint64_t v) {
    return v < 128 ? 1 : (static_cast<std::size_t>(std::bit_width(v)) + 6) / 7;
}

class ByteWriter {
  public:
    void u8(std::uint8_t v) { bytes_.push_back(std::byte{v}); }
    void u32(std::uint32_t v) {
        for (int i = 0; i < 4; ++i) u8(static_cast<std::uint8_t>(v >> (8 * i)));
    }
    void u64(std::uint64_t v) {
        for (int i = 0; i < 8; ++i) u8(static_cast<std::uint8_t>(v >> (8 * i)));
    }
    void f64(double v) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &v, sizeof bits);
        u64(bits);
    }
    void varint(std::uint64_t v) {
        for (; v >= 0x80; v >>= 7) u8(static_cast<std::uint8_t>(v | 0x80));
        u8(static_cast<std::uint8_t>(v));
    }
    void text(std::string_view s) {
        varint(s.size());
        raw(std::as_bytes(std::span(s.data(), s.size())));
    }
    void raw(std::span<const std::byte> b) {
        const std::size_t start = bytes_.size();
        bytes_.resize(start + b.size());
        if (!b.empty()) std::memcpy(bytes_.data() + start, b.data(), b.size());
    }

    std::size_t size() const { return bytes_.size(); }
    const Bytes& bytes() const { return bytes_; }
    Bytes take() { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

// Reads never pass the end: past it they return zeros and `ok()` turns false for good, so a parser
// may read a group of fields and check once, before it uses any of them.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes, std::uint64_t offset = 0)
        : bytes_(bytes), offset_(offset) {}

    bool ok() const { return ok_; }
    std::size_t left() const { return bytes_.size() - position_; }
    // Offset in the file, for error messages.
    std::uint64_t at() const { return offset_ + position_; }

    std::uint8_t u8() {
        if (position_ >= bytes_.size()) return fail();
        return static_cast<std::uint8_t>(bytes_[position_++]);
    }
    std::uint32_t u32() {
        std::uint32_t v = 0;
        for (int i = 0; i < 4; ++i) v |= std::uint32_t{u8()} << (8 * i);
        return v;
    }
    std::uint64_t u64() {
        std::uint64_t v = 0;
        for (int i = 0; i < 8; ++i) v |= std::uint64_t{u8()} << (8 * i);
        return v;
    }
    double f64() {
        const std::uint64_t bits = u64();
        double v = 0;
        std::memcpy(&v, &bits, sizeof v);
        return v;
    }
    std::uint64_t varint() {
        std::uint64_t v = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            const std::uint8_t b = u8();
            if (!ok_) return 0;
            if (shift == 63 && b > 1) return fail();
            v |= std::uint64_t{b & 0x7Fu} << shift;
            if (b < 0x80) {
                if (b == 0 && shift > 0) return fail();  // not the shortest form
                return v;
            }
        }
        return fail();
    }
    std::span<const std::byte> raw(std::uint64_t count) {
        if (count > left()) {
            fail();
            return {};
        }
        const auto part = bytes_.subspan(position_, static_cast<std::size_t>(count));
        position_ += static_cast<std::size_t>(count);
        return part;
    }
    std::string text() {
        const auto part = raw(varint());
        return {reinterpret_cast<const char*>(part.data()), part.size()};
    }

  private:
    std::uint8_t fail() {
        ok_ = false;
        position_ = bytes_.size();
        return 0;
    }

    std::span<const std::byte> bytes_;
    std::uint64_t offset_ = 0;
    std::size_t position_ = 0;
    bool ok_ = true;
};

}  // namespace ravel
