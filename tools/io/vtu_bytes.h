// Arrays as VTU files hold them: a header of 32 or 64-bit sizes, then the bytes, whole or in
// compressed blocks, raw or as base64.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ravel/result.h"

namespace ravel::io {

enum class VtuCompressor : std::uint8_t { none, zlib, lz4, lzma };

struct VtuCoding {
    VtuCompressor compressor = VtuCompressor::none;
    bool header_64 = false;
    bool big_endian = false;  // of the header's numbers; never written
};

// Takes bytes one after the other from raw or base64 text. Base64 may be padded in the middle, as
// writers do that encode the header by itself.
class VtuSource {
  public:
    VtuSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

    // False when the text ends before, or is no base64.
    bool take(std::size_t count, std::string& bytes);
    // No more than this many bytes can come.
    std::size_t bound() const;

  private:
    bool decode_quantum();

    std::string_view text_;
    bool base64_;
    std::size_t at_ = 0;
    std::string decoded_;
    std::size_t used_ = 0;  // of decoded_
};

// The bytes of one array. The error's detail says only what is wrong; the caller knows where.
Result<std::string> read_vtu_bytes(VtuSource source, const VtuCoding& coding);

// Appends one array; `base64` encodes it as VTK does, the header of compressed data by itself.
Status append_vtu_bytes(std::string& out, std::string_view bytes, const VtuCoding& coding,
                        bool base64);

}  // namespace ravel::io
