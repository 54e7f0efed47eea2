// Unpacks the decoder's module: a module of its own, a kilobyte, that runs first. LZMA, the format
// of xz, makes it a thirteenth smaller than deflate does: literals, matches and the last four
// distances, told in bits with adaptive chances by a range coder. Raw, with lc = 3, lp = pb = 0 and
// a size that is known; the bytes are the package's own, so nothing is checked.
#include <cstddef>
#include <cstdint>

namespace {

using Byte = std::uint8_t;

// Chances in 1/2048 that a bit is 0.
using Chance = std::uint16_t;
constexpr int kStates = 12;
struct Length {
    Chance beyond_short, beyond_middle;
    Chance low[8], middle[8], high[256];
};
struct Chances {
    Chance match[kStates], repeat[kStates], older[kStates], oldest[2][kStates], longer[kStates];
    Length length, repeat_length;
    Chance slot[4][64], far[128], near[16];
    Chance literal[8][3][256];  // by the last byte; with no bit to expect, a 0 or a 1
};
Chances chances;

const Byte* in;
std::uint32_t range, code;

void refill() {
    if (range >= 1u << 24) return;
    range <<= 8;
    code = code << 8 | *in++;
}

int bit(Chance& chance) {
    const std::uint32_t bound = (range >> 11) * chance;
    const bool yes = code >= bound;
    if (yes) {
        range -= bound;
        code -= bound;
        chance -= chance >> 5;
    } else {
        range = bound;
        chance += (2048 - chance) >> 5;
    }
    refill();
    return yes;
}

// Most significant bit first, each under those before it.
int tree(Chance* at, int bits) {
    int node = 1;
    for (int i = 0; i < bits; ++i) node = 2 * node + bit(at[node]);
    return node - (1 << bits);
}
// Least significant bit first.
int tree_upwards(Chance* at, int bits) {
    int node = 1, value = 0;
    for (int i = 0; i < bits; ++i) {
        const int yes = bit(at[node]);
        node = 2 * node + yes;
        value |= yes << i;
    }
    return value;
}

int length_of(Length& length) {
    if (!bit(length.beyond_short)) return 2 + tree(length.low, 3);
    if (!bit(length.beyond_middle)) return 10 + tree(length.middle, 3);
    return 18 + tree(length.high, 8);
}

std::uint32_t distance_of(int length) {
    const int slot = tree(chances.slot[length < 6 ? length - 2 : 3], 6), bits = (slot >> 1) - 1;
    if (slot < 4) return slot + 1;
    std::uint32_t distance = (2 | (slot & 1)) << bits;
    if (slot < 14) return distance + tree_upwards(chances.far + distance - slot, bits) + 1;
    for (int i = bits - 1; i >= 4; --i) {
        range >>= 1;
        if (code >= range) {
            code -= range;
            distance += 1u << i;
        }
        refill();
    }
    return distance + tree_upwards(chances.near, 4) + 1;
}

}  // namespace

// A zero stands before `out`.
extern "C" __attribute__((export_name("unpack"))) void ravel_unpack(const Byte* packed, Byte* out,
                                                                    std::size_t size) {
    for (std::size_t i = 0; i < sizeof chances / sizeof(Chance); ++i)
        reinterpret_cast<Chance*>(&chances)[i] = 1024;
    in = packed + 1;
    range = ~0u;
    for (int i = 0; i < 4; ++i) code = code << 8 | *in++;
    std::uint32_t distance[4] = {1, 1, 1, 1};  // the latest first
    int state = 0;                             // what came last: below 7 a literal
    for (Byte* const end = out + size; out < end;) {
        if (!bit(chances.match[state])) {
            auto& literal = chances.literal[out[-1] >> 5];
            int node = 1, like = state < 7 ? 0 : out[-static_cast<std::ptrdiff_t>(distance[0])];
            bool alike = state >= 7;
            for (; node < 256; like <<= 1) {
                const int expected = like >> 7 & 1;
                const int yes = bit(literal[alike ? 1 + expected : 0][node]);
                node = 2 * node + yes;
                alike = alike && yes == expected;
            }
            *out++ = static_cast<Byte>(node);
            state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
            continue;
        }
        int length = 1, age = 0;
        std::uint32_t taken = 0;
        if (!bit(chances.repeat[state])) {
            length = length_of(chances.length);
            taken = distance_of(length);
            age = 3;
            state = state < 7 ? 7 : 10;
        } else {
            bool short_one = false;
            if (bit(chances.older[state])) {
                age = 1;
                while (age < 3 && bit(chances.oldest[age - 1][state])) ++age;
            } else {
                short_one = !bit(chances.longer[state]);
            }
            taken = distance[age];
            if (!short_one) length = length_of(chances.repeat_length);
            state = state < 7 ? (short_one ? 9 : 8) : 11;
        }
        for (; age > 0; --age) distance[age] = distance[age - 1];
        distance[0] = taken;
        for (; length > 0; --length, ++out) *out = out[-static_cast<std::ptrdiff_t>(taken)];
    }
}
