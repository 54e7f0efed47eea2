#include "io/vtk_legacy.h"

#include <array>
#include <charconv>

#include "io/attributes.h"
#include "io/file_bytes.h"
#include "io/typed_values.h"

namespace ravel::io {

namespace {

struct ScalarName {
    std::string_view name;
    Scalar scalar;
};

constexpr std::array kScalarNames = {
    ScalarName{"unsigned_char", Scalar::u8},   ScalarName{"char", Scalar::i8},
    ScalarName{"unsigned_short", Scalar::u16}, ScalarName{"short", Scalar::i16},
    ScalarName{"unsigned_int", Scalar::u32},   ScalarName{"int", Scalar::i32},
    ScalarName{"unsigned_long", Scalar::u64},  ScalarName{"long", Scalar::i64},
    ScalarName{"float", Scalar::f32},          ScalarName{"double", Scalar::f64},
    ScalarName{"signed_char", Scalar::i8},     ScalarName{"vtktypeint8", Scalar::i8},
    ScalarName{"vtktypeuint8", Scalar::u8},    ScalarName{"vtktypeint16", Scalar::i16},
    ScalarName{"vtktypeuint16", Scalar::u16},  ScalarName{"vtktypeint32", Scalar::i32},
    ScalarName{"vtktypeuint32", Scalar::u32},  ScalarName{"vtktypeint64", Scalar::i64},
    ScalarName{"vtktypeuint64", Scalar::u64},
};

Array widen(const Array& narrow) {
    Array wide = make_array(Scalar::i64, narrow.arity, narrow.count());
    const std::span<const std::int32_t> from = narrow.as<std::int32_t>();
    std::copy(from.begin(), from.end(), wide.as<std::int64_t>().begin());
    return wide;
}

}  // namespace

std::optional<VtkScalar> vtk_scalar(std::string_view name) {
    if (same_word(name, "vtkidtype")) return VtkScalar{Scalar::i64, true};
    for (const ScalarName& known : kScalarNames) {
        if (same_word(known.name, name)) return VtkScalar{known.scalar, false};
    }
    return std::nullopt;
}

const char* vtk_scalar_name(Scalar scalar, bool version_5) {
    if (version_5 && scalar == Scalar::i64) return "vtktypeint64";
    if (version_5 && scalar == Scalar::u64) return "vtktypeuint64";
    for (const ScalarName& known : kScalarNames) {
        if (known.scalar == scalar) return known.name.data();
    }
    return "double";
}

Result<VtkArray> read_vtk_array(VtkLegacy& file, std::string_view type, std::uint32_t arity,
                                Index tuples, const std::string& what) {
    const std::optional<VtkScalar> scalar = vtk_scalar(type);
    if (!scalar) {
        return file.text.error("the values of " + what + " are of type '" + std::string(type) +
                               "', which is not supported");
    }
    if (arity == 0) return file.text.error(what + " needs at least one component");
    if (!file.binary) {
        const std::size_t start = file.text.offset();
        Result<Array> values = read_values(file.text, scalar->scalar, arity, tuples, what);
        if (!values) return values.error();
        return VtkArray{std::move(*values), start, 0};
    }
    file.text.next_line();
    const std::size_t start = file.text.offset();
    const Scalar stored = scalar->narrow_id ? Scalar::i32 : scalar->scalar;
    Result<Array> values = take_values(file.text, stored, arity, tuples, true, what);
    if (!values) return values.error();
    if (scalar->narrow_id) *values = widen(*values);
    return VtkArray{std::move(*values), start, size_of(stored)};
}

Error error_at(VtkLegacy& file, const VtkArray& array, Index number, const std::string& sentence) {
    if (file.binary) {
        return byte_error(file.text.file(), array.start + number * array.scalar_size, sentence);
    }
    file.text.seek(array.start);
    for (Index i = 0; i <= number; ++i) file.text.word();
    return file.text.error(sentence);
}

void skip_vtk_metadata(VtkLegacy& file) {
    while (file.text.next_line()) {
        if (file.text.line_ended()) return;
    }
}

std::string encode_vtk_name(std::string_view name) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (code > ' ' && code < 127 && c != '"' && c != '%') {
            encoded += c;
        } else {
            encoded += '%';
            encoded += kDigits[code >> 4];
            encoded += kDigits[code & 15];
        }
    }
    return encoded;
}

std::string decode_vtk_name(std::string_view name) {
    std::string decoded;
    for (std::size_t i = 0; i < name.size(); ++i) {
        unsigned code = 0;
        if (name[i] == '%' && i + 2 < name.size()) {
            const char* end = name.data() + i + 3;
            const auto [stop, error] = std::from_chars(name.data() + i + 1, end, code, 16);
            if (error == std::errc{} && stop == end) {
                decoded += static_cast<char>(code);
                i += 2;
                continue;
            }
        }
        decoded += name[i];
    }
    return decoded;
}

}  // namespace ravel::io
