#include "io/vtu_bytes.h"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

namespace ravel::io {

namespace {

constexpr std::size_t kBlock = 32768;  // VTK's own
constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

Error broken(const std::string& sentence) {
    return {Code::unreadable, 0, sentence};
}

constexpr std::array<std::int8_t, 256> digit_values() {
    std::array<std::int8_t, 256> values{};
    for (std::int8_t& value : values) value = -1;
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::int8_t>(i);
    }
    return values;
}
constexpr std::array<std::int8_t, 256> kDigitValues = digit_values();

void append_base64(std::string& out, std::string_view bytes) {
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t triple = 0;
        const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k) {
            triple = triple << 8 | (k < here ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += k <= here ? kDigits[triple >> (18 - 6 * k) & 63] : '=';
        }
    }
}

bool read_size(VtuSource& source, const VtuCoding& coding, std::uint64_t& value) {
    std::string raw;
    const std::size_t width = coding.header_64 ? 8 : 4;
    if (!source.take(width, raw)) return false;
    if (coding.big_endian) std::reverse(raw.begin(), raw.end());
    value = 0;
    for (std::size_t i = width; i-- > 0;) value = value << 8 | static_cast<unsigned char>(raw[i]);
    return true;
}

void append_size(std::string& out, const VtuCoding& coding, std::uint64_t value) {
    for (std::size_t i = 0; i < (coding.header_64 ? 8U : 4U); ++i) {
        out += static_cast<char>(value >> (8 * i) & 255);
    }
}

// No compressor packs tighter than this, so larger claims are false and get no memory.
std::uint64_t best_ratio(VtuCompressor compressor) {
    switch (compressor) {
        case VtuCompressor::zlib:
            return 1100;
        case VtuCompressor::lz4:
            return 256;
        default:
            return 16384;
    }
}

bool unpack(VtuCompressor compressor, std::string_view packed, char* out, std::size_t size) {
    const auto* in = reinterpret_cast<const std::uint8_t*>(packed.data());
    switch (compressor) {
        case VtuCompressor::zlib: {
            uLongf got = size;
            return uncompress(reinterpret_cast<Bytef*>(out), &got, in, packed.size()) == Z_OK &&
                   got == size;
        }
        case VtuCompressor::lz4: {
            constexpr std::size_t kMost = std::numeric_limits<int>::max();
            if (packed.size() > kMost || size > kMost) return false;
            return LZ4_decompress_safe(packed.data(), out, static_cast<int>(packed.size()),
                                       static_cast<int>(size)) == static_cast<int>(size);
        }
        case VtuCompressor::lzma: {
            std::uint64_t memory = std::uint64_t{1} << 30;
            std::size_t in_at = 0, out_at = 0;
            return lzma_stream_buffer_decode(&memory, 0, nullptr, in, &in_at, packed.size(),
                                             reinterpret_cast<std::uint8_t*>(out), &out_at,
                                             size) == LZMA_OK &&
                   out_at == size;
        }
        case VtuCompressor::none:
            break;
    }
    return false;
}

bool pack(VtuCompressor compressor, std::string_view bytes, std::string& packed) {
    const auto* in = reinterpret_cast<const std::uint8_t*>(bytes.data());
    switch (compressor) {
        case VtuCompressor::zlib: {
            uLongf size = compressBound(bytes.size());
            packed.resize(size);
            if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, in, bytes.size(), 6) !=
                Z_OK) {
                return false;
            }
            packed.resize(size);
            return true;
        }
        case VtuCompressor::lz4: {
            packed.resize(static_cast<std::size_t>(LZ4_compressBound(static_cast<int>(kBlock))));
            const int size =
                LZ4_compress_default(bytes.data(), packed.data(), static_cast<int>(bytes.size()),
                                     static_cast<int>(packed.size()));
            if (size <= 0) return false;
            packed.resize(static_cast<std::size_t>(size));
            return true;
        }
        case VtuCompressor::lzma: {
            std::size_t size = 0;
            packed.resize(lzma_stream_buffer_bound(bytes.size()));
            if (lzma_easy_buffer_encode(5, LZMA_CHECK_CRC32, nullptr, in, bytes.size(),
                                        reinterpret_cast<std::uint8_t*>(packed.data()), &size,
                                        packed.size()) != LZMA_OK) {
                return false;
            }
            packed.resize(size);
            return true;
        }
        case VtuCompressor::none:
            break;
    }
    return false;
}

Result<std::string> read_blocks(VtuSource& source, const VtuCoding& coding) {
    const Error short_header = broken("the compression header ends early");
    std::uint64_t blocks = 0, block_size = 0, last_size = 0;
    if (!read_size(source, coding, blocks)) return short_header;
    if (blocks == 0) return std::string{};
    if (!read_size(source, coding, block_size) || !read_size(source, coding, last_size)) {
        return short_header;
    }
    if (blocks > source.bound() / (coding.header_64 ? 8 : 4)) {
        return broken(std::to_string(blocks) +
                      " blocks are announced, more than the file can hold");
    }
    std::vector<std::uint64_t> sizes(blocks);
    for (std::uint64_t& size : sizes) {
        if (!read_size(source, coding, size)) return short_header;
    }
    std::string bytes, packed;
    for (std::size_t b = 0; b < sizes.size(); ++b) {
        if (sizes[b] > source.bound() || !source.take(sizes[b], packed)) {
            return broken("compressed block " + std::to_string(b) + " ends early");
        }
        const std::uint64_t size = b + 1 == sizes.size() && last_size != 0 ? last_size : block_size;
        if (size / best_ratio(coding.compressor) > packed.size()) {
            return broken("compressed block " + std::to_string(b) + " announces " +
                          std::to_string(size) + " bytes, which can't be");
        }
        const std::size_t start = bytes.size();
        bytes.resize(start + size);
        if (!unpack(coding.compressor, packed, bytes.data() + start, size)) {
            return broken("compressed block " + std::to_string(b) + " is damaged");
        }
    }
    return bytes;
}

}  // namespace

bool VtuSource::decode_quantum() {
    std::uint32_t bits = 0;
    int digits = 0, padding = 0;
    while (digits + padding < 4) {
        if (at_ == text_.size()) return false;
        const char c = text_[at_++];
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        if (c == '=') {
            ++padding;
            continue;
        }
        const std::int8_t value = kDigitValues[static_cast<unsigned char>(c)];
        if (value < 0 || padding != 0) return false;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        ++digits;
    }
    if (padding > 2) return false;
    bits <<= 6 * padding;
    for (int k = 0; k < 3 - padding; ++k) decoded_ += static_cast<char>(bits >> (16 - 8 * k) & 255);
    return true;
}

bool VtuSource::take(std::size_t count, std::string& bytes) {
    if (!base64_) {
        if (count > text_.size() - at_) return false;
        bytes.assign(text_.substr(at_, count));
        at_ += count;
        return true;
    }
    decoded_.erase(0, used_);
    used_ = 0;
    if (count > bound()) return false;
    while (decoded_.size() < count) {
        if (!decode_quantum()) return false;
    }
    bytes.assign(decoded_, 0, count);
    used_ = count;
    return true;
}

std::size_t VtuSource::bound() const {
    const std::size_t left = text_.size() - at_;
    return base64_ ? decoded_.size() - used_ + left / 4 * 3 : left;
}

Result<std::string> read_vtu_bytes(VtuSource source, const VtuCoding& coding) {
    if (coding.compressor != VtuCompressor::none) return read_blocks(source, coding);
    std::uint64_t size = 0;
    if (!read_size(source, coding, size)) return broken("the header of its size is missing");
    std::string bytes;
    if (size > source.bound() || !source.take(size, bytes)) {
        return broken(std::to_string(size) + " bytes are announced, more than there are");
    }
    return bytes;
}

Status append_vtu_bytes(std::string& out, std::string_view bytes, const VtuCoding& coding,
                        bool base64) {
    const bool compressed = coding.compressor != VtuCompressor::none;
    if (!coding.header_64 && bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
        return Error{Code::unwritable, 0, "an array is too large for a 32-bit header"};
    }
    std::string header, body;
    if (!compressed) {
        append_size(header, coding, bytes.size());
        header += bytes;
    } else {
        std::string packed;
        append_size(header, coding, (bytes.size() + kBlock - 1) / kBlock);
        append_size(header, coding, kBlock);
        append_size(header, coding, bytes.size() % kBlock);
        for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
            if (!pack(coding.compressor, bytes.substr(at, kBlock), packed)) {
                return Error{Code::unwritable, 0, "an array could not be compressed"};
            }
            append_size(header, coding, packed.size());
            body += packed;
        }
    }
    if (base64) {
        append_base64(out, header);
        append_base64(out, body);
    } else {
        out += header;
        out += body;
    }
    return Done{};
}

}  // namespace ravel::io
