// Finite state entropy and Huffman coding as Zstandard has them (RFC 8878, 4.1 and 4.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ravel::web {

using Byte = std::uint8_t;

// Bytes from front to back. What is asked for past the end is 0 and remembered.
struct Input {
    const Byte* at;
    const Byte* end;
    bool short_of = false;

    std::size_t left() const { return static_cast<std::size_t>(end - at); }
    std::uint32_t take(int count) {  // little-endian, at most four
        std::uint32_t value = 0;
        for (int i = 0; i < count; ++i) {
            if (at == end) short_of = true;
            value |= static_cast<std::uint32_t>(at == end ? 0 : *at++) << (8 * i);
        }
        return value;
    }
    Input part(std::size_t size) {
        if (size > left()) short_of = true, size = left();
        at += size;
        return {at - size, at};
    }
};

// Bits from back to front: the highest 1 of the last byte marks where they start. Bits past the
// start of the bytes are 0; `left` is then negative.
struct BitsBack {
    const Byte* bytes;
    std::size_t size;
    std::int64_t left;

    explicit BitsBack(Input in) : bytes(in.at), size(in.left()), left(-1) {
        if (size > 0 && bytes[size - 1] != 0)
            left = static_cast<std::int64_t>(8 * size) - 1 - __builtin_clz(bytes[size - 1]) + 24;
    }
    std::uint64_t look(int count) const {  // at most 32
        const std::int64_t start = left - count;
        if (start < 0)
            return left <= 0 ? 0 : BitsBack(*this).look_at(0, static_cast<int>(left)) << -start;
        return look_at(start, count);
    }
    std::uint32_t take(int count) {
        const std::uint64_t value = look(count);
        left -= count;
        return static_cast<std::uint32_t>(value);
    }

  private:
    std::uint64_t look_at(std::int64_t start, int count) const {
        const auto first = static_cast<std::size_t>(start >> 3);
        std::uint64_t word = 0;
        if (first + 8 <= size)
            std::memcpy(&word, bytes + first, 8);
        else
            std::memcpy(&word, bytes + first, size - first);
        return word >> (start & 7) & ((std::uint64_t{1} << count) - 1);
    }
};

struct FseTable {
    struct Entry {
        Byte symbol, bits;
        std::uint16_t base;
    };
    int log = -1;  // -1: there is none
    Entry entries[512];

    // Reads the probabilities of symbols up to `last`. False where they are none.
    bool read(Input& in, int most_log, int last);
    void build(const std::int16_t* counts, int symbols, int table_log);
    void build_one(Byte symbol);  // nothing but this symbol
};

struct FseState {
    const FseTable& table;
    std::uint32_t state;
    FseState(const FseTable& of, BitsBack& bits) : table(of), state(bits.take(of.log)) {}
    Byte symbol() const { return table.entries[state].symbol; }
    void next(BitsBack& bits) {
        const FseTable::Entry entry = table.entries[state];
        state = entry.base + bits.take(entry.bits);
    }
};

struct HuffmanTable {
    static constexpr int kMostBits = 12;
    struct Entry {
        Byte symbol, bits;
    };
    int log = 0;  // 0: there is none
    Entry entries[1 << kMostBits];

    bool read(Input& in);
    // One stream of bits into [to, to + size); false where they do not end together.
    bool decode(Input in, Byte* to, std::size_t size) const;
};

}  // namespace ravel::web
