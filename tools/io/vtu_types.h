// The scalar types of VTU files, and the encodings that can be written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/vtu_bytes.h"
#include "ravel/mesh.h"

namespace ravel::io {

// "Int8" to "UInt64", "Float32" and "Float64".
std::optional<Scalar> vtu_scalar(std::string_view name);
const char* vtu_scalar_name(Scalar scalar);

enum class VtuEncoding : std::uint8_t { text, inline_base64, appended_raw, appended_base64 };

struct VtuOptions {
    VtuEncoding encoding = VtuEncoding::text;
    VtuCoding coding;
};

Status write_vtu_as(const Mesh& mesh, const std::string& path, const VtuOptions& options,
                    std::vector<std::string>* left_out);

}  // namespace ravel::io
