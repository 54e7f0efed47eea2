#include "decoder/fse.h"

#include <bit>

namespace ravel::web {
namespace {

int log_of(std::uint32_t x) {
    return static_cast<int>(std::bit_width(x)) - 1;
}

}  // namespace

// Counts come in as few bits as what is left allows; after each 0, two bits tell how many more
// follow.
bool FseTable::read(Input& in, int most_log, int last) {
    // The bits run through the bytes from front to back, lowest first.
    std::size_t position = 0;
    const Byte* const bytes = in.at;
    const std::size_t bits_left = 8 * in.left();
    const auto look = [&](int count) {
        std::uint32_t value = 0;
        for (int i = 0; i < count; ++i) {
            const std::size_t bit = position + static_cast<std::size_t>(i);
            if (bit < bits_left)
                value |= static_cast<std::uint32_t>(bytes[bit / 8] >> (bit % 8) & 1) << i;
        }
        return value;
    };
    const int table_log = static_cast<int>(look(4)) + 5;
    position = 4;
    if (table_log > most_log) return false;
    std::int16_t counts[256];
    int symbol = 0, left = 1 << table_log;
    while (left > 0 && symbol <= last) {
        const int width = log_of(static_cast<std::uint32_t>(left) + 1) + 1;
        const std::uint32_t spare = (1u << width) - 2 - static_cast<std::uint32_t>(left);
        const std::uint32_t low = look(width - 1);
        std::uint32_t value = low;
        if (low < spare) {
            position += static_cast<std::size_t>(width) - 1;
        } else {
            value = look(width);
            position += static_cast<std::size_t>(width);
            if (value >= 1u << (width - 1)) value -= spare;
        }
        const int count = static_cast<int>(value) - 1;
        left -= count < 0 ? 1 : count;
        counts[symbol++] = static_cast<std::int16_t>(count);
        if (count != 0) continue;
        for (std::uint32_t more = 3; more == 3;) {
            more = look(2);
            position += 2;
            for (std::uint32_t i = 0; i < more; ++i) {
                if (symbol > last) return false;
                counts[symbol++] = 0;
            }
        }
    }
    if (left != 0 || position > bits_left) return false;
    in.at += (position + 7) / 8;
    build(counts, symbol, table_log);
    return true;
}

void FseTable::build(const std::int16_t* counts, int symbols, int table_log) {
    log = table_log;
    const std::uint32_t size = 1u << log, step = (size >> 1) + (size >> 3) + 3;
    std::uint16_t next[256];
    std::uint32_t high = size, at = 0;
    for (int s = 0; s < symbols; ++s) {
        next[s] = static_cast<std::uint16_t>(counts[s] < 0 ? 1 : counts[s]);
        if (counts[s] < 0) entries[--high].symbol = static_cast<Byte>(s);
    }
    for (int s = 0; s < symbols; ++s)
        for (int i = 0; i < counts[s]; ++i) {
            entries[at].symbol = static_cast<Byte>(s);
            do at = (at + step) & (size - 1);
            while (at >= high);
        }
    for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t state = next[entries[i].symbol]++;
        const int bits = log - log_of(state);
        entries[i].bits = static_cast<Byte>(bits);
        entries[i].base = static_cast<std::uint16_t>((state << bits) - size);
    }
}

void FseTable::build_one(Byte symbol) {
    log = 0;
    entries[0] = {symbol, 0, 0};
}

bool HuffmanTable::read(Input& in) {
    log = 0;
    Byte weights[256];
    int count = 0;
    const std::uint32_t head = in.take(1);
    if (head >= 128) {
        count = static_cast<int>(head) - 127;
        const Input nibbles = in.part((static_cast<std::size_t>(count) + 1) / 2);
        if (in.short_of) return false;
        for (int i = 0; i < count; ++i)
            weights[i] = i % 2 ? nibbles.at[i / 2] & 15 : nibbles.at[i / 2] >> 4;
    } else {
        Input part = in.part(head);
        FseTable table;
        if (in.short_of || !table.read(part, 6, 255)) return false;
        BitsBack bits(part);
        if (bits.left < 0) return false;
        // Two states take turns; what the last one stands for is told when the bits are used up.
        FseState states[2] = {{table, bits}, {table, bits}};
        if (bits.left < 0) return false;
        for (int turn = 0;; turn ^= 1) {
            if (count >= 254) return false;
            weights[count++] = states[turn].symbol();
            states[turn].next(bits);
            if (bits.left >= 0) continue;
            weights[count++] = states[turn ^ 1].symbol();
            break;
        }
    }
    // The last weight fills the sum up to a power of two.
    std::uint32_t sum = 0, first[kMostBits + 2] = {};
    for (int i = 0; i < count; ++i) {
        if (weights[i] > kMostBits) return false;
        sum += 1u << weights[i] >> 1;
    }
    if (sum == 0) return false;
    const int bits = log_of(sum) + 1;
    const std::uint32_t rest = (1u << bits) - sum;
    if (bits > kMostBits || !std::has_single_bit(rest)) return false;
    weights[count++] = static_cast<Byte>(log_of(rest) + 1);
    for (int i = 0; i < count; ++i) ++first[weights[i] + 1];
    if (first[2] < 2 || first[2] % 2 != 0) return false;
    // Longest codes first; a symbol of weight w fills 2^(w - 1) entries.
    std::uint32_t at = 0;
    for (int w = 1; w <= bits; ++w)
        for (int s = 0; s < count; ++s) {
            if (weights[s] != w) continue;
            for (std::uint32_t i = 0; i < 1u << w >> 1; ++i)
                entries[at++] = {static_cast<Byte>(s), static_cast<Byte>(bits + 1 - w)};
        }
    log = bits;
    return true;
}

bool HuffmanTable::decode(Input in, Byte* to, std::size_t size) const {
    BitsBack bits(in);
    for (std::size_t i = 0; i < size; ++i) {
        const Entry entry = entries[bits.look(log)];
        to[i] = entry.symbol;
        bits.left -= entry.bits;
    }
    return bits.left == 0;
}

}  // namespace ravel::web
