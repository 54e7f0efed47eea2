// The model that the packer and the unpacker of the decoder's module share: the chance of every
// next bit, mixed from several contexts [Mahoney2005]. Both sides ask and teach it in the same way,
// in integers only, so they agree by construction.
//
// It knows what it packs: it follows the instructions in the module's code, since what comes next
// depends on the instructions before rather than on the bytes before. A byte is told along a tree
// where frequent bytes are near the root, five decisions rather than eight; one tree is for bytes
// that begin an instruction (and all that is no code), the other for what follows in it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace packing {

using Byte = std::uint8_t;
using Word = std::uint32_t;

// What is packed ahead of the module. The code is what follows the number of functions.
struct Head {
    Byte length[2][256];  // of every byte's path: 1 to 16, or 0 for a byte that never comes
    Word code_begin, code_end;
};

// Paths of the same length are in the order of their bytes, shorter ones before longer ones.
struct Tree {
    Byte byte[256];
    Word count[17];  // of bytes by the length of their paths

    void plant(const Byte* length) {
        Byte* next = byte;
        for (Word bits = 1; bits <= 16; ++bits) {
            Byte* const before = next;
            for (int i = 0; i < 256; ++i)
                if (length[i] == bits) *next++ = static_cast<Byte>(i);
            count[bits] = static_cast<Word>(next - before);
        }
    }
};

// What the bits after some past were: as 1/65536 beyond one half, and how many there were.
struct Outcome {
    std::int16_t chance, count;
};

// What one context has to say about the next bit.
struct View {
    Word base;  // where the table has it
    std::uint16_t* slot;
    Word slot_now;
    Outcome* outcome;
    int opinion;
};

constexpr int kContexts = 5;
constexpr Word kSlots = 1 << 19;
constexpr int kLimit = 255;  // of what an outcome counts
constexpr Word kOutside = 256, kHeader = 257;
constexpr Word kMultiplier = 0x9E3779B1, kOtherMultiplier = 0x85EBCA6B;

// Starts as zeros (the table is large, and untouched memory costs nothing).
class Model {
  public:
    void start() {
        // e^-x, x in steps of nearly 1/256.
        for (Word i = 0, power = 1 << 30; i < 2048; ++i, power -= power >> 8) {
            const int chance = static_cast<int>((std::uint64_t{1} << 46) / ((1 << 30) + power));
            chances_[2048 + i] = chance;
            chances_[2048 - i] = 65536 - chance;
        }
        for (int i = 1, at = 0; at < 4096; ++at) {
            while (i < 4095 && chances_[i] < at << 4) ++i;
            opinions_[at] = i - 2048;
        }
        for (int i = 0; i <= kLimit; ++i) rates_[i] = 32768 / (2 * i + 3);
        for (auto& weights : by_place_)
            for (int& weight : weights) weight = kFirstWeight;
        for (auto& weights : by_node_)
            for (int& weight : weights) weight = kFirstWeight;
        for (int i = 0; i < 256; ++i) trees_[1].byte[i] = static_cast<Byte>(i);
        trees_[1].count[8] = 256;
        op_ = kOutside;
        begin_byte();
    }

    // The module begins.
    void enter(const Head& head) {
        position_ = 0;
        code_begin_ = head.code_begin;
        code_end_ = head.code_end;
        for (int i = 0; i < 2; ++i) trees_[i].plant(head.length[i]);
        begin_byte();
    }

    // That the next bit is 1, in 1/65536. A function of its own, as the other: engines replace a
    // function that is called often by a faster one, but none that runs.
    __attribute__((noinline)) int chance() {
        const Word level = level_ & 3, low = (node_ & ((1 << level) - 1)) | 1 << level;
        const int *const by_place = place_weights_, *const by_node = node_weights();
        int sum = 0;
        for (int i = 0; i < kContexts; ++i) {
            View& view = views_[i];
            // The next four levels are side by side.
            if (level == 0) view.base += node_ * kMultiplier;
            view.slot = table_ + ((view.base + low) & (kSlots - 1));
            // No past, and the check.
            const Word fresh = view.base >> 24 | 257;
            Word now = *view.slot;
            if (((now ^ fresh) & 255) != 0) now = fresh;
            view.slot_now = now;
            view.outcome = outcomes_[i] + (now >> 8);
            view.opinion = opinions_[2048 + (view.outcome->chance >> 4)];
            sum += view.opinion * (by_place[i] + by_node[i]) >> 8;
        }
        sum >>= 8;
        if (sum > 2047) sum = 2047;
        if (sum < -2047) sum = -2047;
        return chance_ = chances_[2048 + sum];
    }

    // Returns whether that ends a byte.
    __attribute__((noinline)) bool learn(int bit) {
        const int error = (bit << 16) - chance_, goal = bit != 0 ? 32767 : -32768;
        int *const by_place = place_weights_, *const by_node = node_weights();
        for (int i = 0; i < kContexts; ++i) {
            const View& view = views_[i];
            const int change = (view.opinion * error + (1 << (kSlowness - 1))) >> kSlowness;
            by_place[i] += change;
            by_node[i] += change;
            Outcome& outcome = *view.outcome;
            outcome.chance += (goal - outcome.chance) * rates_[outcome.count] >> 14;
            if (outcome.count < kLimit) ++outcome.count;
            // The past is the last seven bits at most, behind a 1.
            Word past = (view.slot_now >> 8) * 2 + static_cast<Word>(bit);
            if (past > 255) past = (past & 127) | 128;
            *view.slot = static_cast<std::uint16_t>(past << 8 | (view.slot_now & 255));
        }
        node_ = 2 * node_ + static_cast<Word>(bit);
        const Word offset = 2 * offset_ + static_cast<Word>(bit), count = tree_->count[++level_];
        if (offset < count) {
            follow(rank_[offset]);
            return true;
        }
        rank_ += count;
        offset_ = offset - count;
        return false;
    }

    Byte last_byte() const { return static_cast<Byte>(bytes_); }
    const Tree& tree() const { return *tree_; }
    bool in_instruction() const { return at_ != 0; }

    // Learns where in the module the next byte is.
    void follow(Word byte) {
        bytes_ = bytes_ << 8 | byte;
        ++position_;
        ++at_;
        so_far_ = (so_far_ + byte + 1) * kMultiplier;
        so_far_ ^= so_far_ >> 15;
        if (position_ <= code_begin_ || position_ > code_end_) {
            op_ = kOutside;
            ops_ = ops_ << 8 | byte;
            if (position_ == code_begin_) begin_function();
        } else if (raw_ != 0) {
            --raw_;
        } else if (left_ != 0) {
            follow_argument(byte);
        } else {
            begin_instruction(byte);
        }
        if (left_ + raw_ == 0) so_far_ = at_ = 0;
        begin_byte();
    }

  private:
    static constexpr int kFirstWeight = 10000, kSlowness = 15;

    // A function begins with its size, then pairs of a number and a type of variables.
    void begin_function() {
        op_ = kHeader;
        left_ = 2;
        ops_ = 0;
    }

    void begin_instruction(Word op) {
        op_ = op;
        ops_ = ops_ << 8 | op;
        argument_ = 0;
        const auto among = [op](Word first, Word last) { return op - first <= last - first; };
        if (among(0x28, 0x3E) || op == 0x11)
            left_ = 2;
        else if (among(0x02, 0x04) || among(0x0C, 0x0E) || op == 0x10 || among(0x20, 0x24) ||
                 among(0x3F, 0x42) || op == 0xFC)
            left_ = 1;
        if (among(0x43, 0x44)) raw_ = 4 * (op - 0x42);  // a float, a double
        if (among(0x02, 0x04)) ++depth_;
        if (op == 0x0B && depth_-- == 0) {
            depth_ = 0;
            begin_function();
        }
    }

    // An argument is a number, seven bits in a byte.
    void follow_argument(Word byte) {
        value_ |= (byte & 127) << (shift_ & 31);
        shift_ += 7;
        if (byte > 127) return;
        --left_;
        ++argument_;
        if (op_ == kHeader && argument_ == 2) left_ = 2 * value_;
        if (op_ == 0x0E && argument_ == 1) left_ = value_ + 1;  // a table of jumps
        if (op_ == 0xFC && argument_ == 1 && value_ > 7) left_ = value_ == 11 ? 1 : 2;
        value_ = shift_ = 0;
    }

    int* node_weights() { return by_node_[(node_ & 255) + 256 * (at_ == 0)]; }

    void begin_byte() {
        tree_ = trees_ + (at_ == 0);
        rank_ = tree_->byte;
        level_ = offset_ = 0;
        node_ = 1;
        const Word ops = static_cast<Word>(ops_);
        const Word older_ops = static_cast<Word>(ops_ >> 32) & 0xFFFF;
        // The instruction so far with three and with six before it, where in an instruction this
        // is, the last three bytes, the last one.
        const Word contexts[kContexts][2] = {{so_far_, ops & 0xFFFFFF},
                                             {so_far_, ops * kMultiplier + older_ops},
                                             {op_ + 512 * at_, 0},
                                             {0, bytes_ & 0xFFFFFF},
                                             {1, bytes_ & 0xFF}};
        for (Word i = 0; i < kContexts; ++i) {
            Word hash = (contexts[i][0] * kOtherMultiplier + contexts[i][1]) * kMultiplier + i;
            hash = (hash ^ hash >> 15) * kOtherMultiplier;
            views_[i].base = hash ^ hash >> 13;
        }
        place_weights_ = by_place_[op_ * 4 + (at_ < 3 ? at_ : 3)];
    }

    Word code_begin_, code_end_;
    Tree trees_[2];
    const Tree* tree_;
    const Byte* rank_;
    Word level_, offset_, node_;
    Word position_, op_, at_, left_, raw_, argument_, value_, shift_, depth_, so_far_;
    std::uint64_t ops_;
    Word bytes_;
    int chance_;
    int* place_weights_;
    View views_[kContexts];
    int chances_[4096], opinions_[4096], rates_[kLimit + 1];
    int by_place_[4 * 258][kContexts], by_node_[512][kContexts];
    Outcome outcomes_[kContexts][256];
    std::uint16_t table_[kSlots];
};

}  // namespace packing
