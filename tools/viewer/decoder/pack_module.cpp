// Packs a WebAssembly module for decoder/unpack_module.cpp: pack_module MODULE >PACKED
#include "packing.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <numeric>
#include <vector>

namespace {

using packing::Byte;
using packing::Head;
using packing::Model;
using packing::Word;
using Bytes = std::vector<Byte>;

// Where the functions are. A number here has seven bits in a byte.
void find_code(const Bytes& module, Head& head) {
    std::size_t at = 8;
    const auto number = [&] {
        Word value = 0;
        for (int shift = 0; at < module.size(); shift += 7) {
            const Byte byte = module[at++];
            value |= (byte & Word{127}) << shift;
            if (byte < 128) break;
        }
        return value;
    };
    while (at < module.size()) {
        const Byte section = module[at++];
        const Word size = number();
        const std::size_t end = at + size;
        if (section == 10) {
            number();
            head.code_begin = static_cast<Word>(at);
            head.code_end = static_cast<Word>(end);
        }
        at = end;
    }
}

// Huffman's tree, flattened by a larger `least` till no path is longer than 15.
void choose_lengths(const Word* counts, Byte* lengths) {
    struct Branch {
        Word count;
        Bytes bytes;
    };
    for (Word least = 16;; least *= 2) {
        std::fill(lengths, lengths + 256, Byte{0});
        std::vector<Branch> branches;
        for (int i = 0; i < 256; ++i)
            if (counts[i] != 0) branches.push_back({counts[i] + least, {static_cast<Byte>(i)}});
        while (branches.size() > 1) {
            std::stable_sort(branches.begin(), branches.end(),
                             [](const Branch& a, const Branch& b) { return a.count > b.count; });
            const Branch rarest = std::move(branches.back());
            branches.pop_back();
            Branch& other = branches.back();
            other.count += rarest.count;
            other.bytes.insert(other.bytes.end(), rarest.bytes.begin(), rarest.bytes.end());
            for (const Byte byte : other.bytes) ++lengths[byte];
        }
        if (*std::max_element(lengths, lengths + 256) <= 15) return;
    }
}

Head head_of(const Bytes& module) {
    Head head{};
    find_code(module, head);
    const auto model = std::make_unique<Model>();
    model->start();
    model->enter(head);
    std::vector<Word> counts[2] = {std::vector<Word>(256), std::vector<Word>(256)};
    for (auto& tree : counts) tree[0] = tree[1] = 1;  // a tree has two paths at least
    for (const Byte byte : module) {
        ++counts[model->in_instruction() ? 0 : 1][byte];
        model->follow(byte);
    }
    for (int i = 0; i < 2; ++i) choose_lengths(counts[i].data(), head.length[i]);
    return head;
}

class Packer {
  public:
    Packer() : model_(std::make_unique<Model>()) { model_->start(); }

    void enter(const Head& head) { model_->enter(head); }

    void pack(const Byte* bytes, std::size_t size) {
        for (const Byte* const end = bytes + size; bytes < end; ++bytes) pack_byte(*bytes);
    }

    // The fewest bytes that tell it, whatever follows them.
    Bytes finish() {
        for (int kept = 8;; kept += 8) {
            const std::uint64_t rest = kept == 64 ? 0 : ~std::uint64_t{0} >> kept;
            const std::uint64_t value = (low_ + rest) & ~rest;
            if (kept < 64 && value - low_ + rest >= range_) continue;
            if (value < low_) carry();
            for (int shift = 56; shift >= 64 - kept; shift -= 8)
                out_.push_back(static_cast<Byte>(value >> shift));
            return out_;
        }
    }

  private:
    void pack_byte(Byte byte) {
        const packing::Tree& tree = model_->tree();
        Word path = 0, bits = 1;
        for (const Byte* rank = tree.byte;; ++bits) {
            const Byte* const end = rank + tree.count[bits];
            const Byte* const found = std::find(rank, end, byte);
            if (found != end) {
                path += static_cast<Word>(found - rank);
                break;
            }
            path = 2 * (path + tree.count[bits]);
            rank = end;
        }
        while (bits-- > 0) pack_bit(path >> bits & 1);
    }

    void pack_bit(int bit) {
        const std::uint64_t bound = (range_ >> 16) * static_cast<std::uint64_t>(model_->chance());
        if (bit != 0) {
            range_ = bound;
        } else {
            low_ += bound;
            range_ -= bound;
            if (low_ < bound) carry();
        }
        for (; range_ >> 48 == 0; range_ <<= 8, low_ <<= 8)
            out_.push_back(static_cast<Byte>(low_ >> 56));
        model_->learn(bit);
    }

    void carry() {
        for (auto at = out_.rbegin(); ++*at == 0;) ++at;
    }

    std::unique_ptr<Model> model_;
    Bytes out_;
    std::uint64_t low_ = 0, range_ = ~std::uint64_t{0};
};

Bytes read_file(const char* name) {
    Bytes bytes;
    if (std::FILE* const file = std::fopen(name, "rb")) {
        for (int byte; (byte = std::getc(file)) != EOF;) bytes.push_back(static_cast<Byte>(byte));
        std::fclose(file);
    }
    return bytes;
}

}  // namespace

int main(int count, char** arguments) {
    const Bytes module = count == 2 ? read_file(arguments[1]) : Bytes{};
    if (module.size() < 8) {
        std::fputs("pack_module MODULE >PACKED\n", stderr);
        return 2;
    }
    const Head head = head_of(module);
    Packer packer;
    packer.pack(reinterpret_cast<const Byte*>(&head), sizeof head);
    packer.enter(head);
    packer.pack(module.data(), module.size());
    const Bytes packed = packer.finish();
    const bool written = std::fwrite(packed.data(), 1, packed.size(), stdout) == packed.size();
    return written && std::fflush(stdout) == 0 ? 0 : 1;
}
