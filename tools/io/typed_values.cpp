#include "io/typed_values.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"

namespace ravel::io {

namespace {

// A number takes a digit and a separator, so this many fit at most into the text that is left.
bool fits_text(const TextReader& text, Index count) {
    return count <= text.bytes_left() / 2 + 1;
}

Error too_many(const TextReader& text, Index count, const std::string& what) {
    return text.error(std::to_string(count) + " values of " + what +
                      " are announced, more than the file can hold");
}

bool multiply(Index a, Index b, Index& product) {
    return !__builtin_mul_overflow(a, b, &product);
}

template <class T>
Result<Array> read_integers(TextReader& text, std::uint32_t arity, Index numbers,
                            const std::string& what) {
    Array array{scalar_of<T>(), arity, {}};
    array.bytes.resize(numbers * sizeof(T));
    for (T& value : array.as<T>()) {
        if (text.read(value)) continue;
        return text.expected(std::string("a number of type ") + name_of(array.scalar) + " of " +
                             what);
    }
    return array;
}

// Is the number the nearest float32, written with as many digits as the word has?
bool spells_float32(std::string_view word, double value) {
    if (survives_float32(value)) return true;
    if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) return false;
    int digits = 0;
    for (const char c : word) {
        if (c == 'e' || c == 'E' || c == 'd' || c == 'D') break;
        // Zeros in front do not count.
        if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
    }
    if (digits == 0) return false;
    char printed[64];
    const int size = std::snprintf(printed, sizeof printed, "%.*e", std::min(digits, 40) - 1,
                                   static_cast<double>(static_cast<float>(value)));
    double back = 0;
    return size > 0 && size < static_cast<int>(sizeof printed) && parse_real(printed, back) &&
           back == value;
}

// The type says float: float32 if that is what all the decimals were printed from.
Result<Array> read_floats(TextReader& text, std::uint32_t arity, Index numbers,
                          const std::string& what) {
    std::vector<double> reals(numbers);
    bool narrow = true;
    for (double& real : reals) {
        const std::string_view word = text.word();
        if (!parse_real(word, real)) return text.expected("a number of " + what);
        narrow = narrow && spells_float32(word, real);
    }
    if (!narrow) return array_of(reals, arity);
    return array_of(std::vector<float>(reals.begin(), reals.end()), arity);
}

}  // namespace

void swap_bytes(std::span<std::byte> bytes, std::size_t scalar_size) {
    for (std::size_t at = 0; at + scalar_size <= bytes.size(); at += scalar_size) {
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + scalar_size));
    }
}

Result<std::vector<double>> read_reals(TextReader& text, Index count, const std::string& what) {
    if (!fits_text(text, count)) return too_many(text, count, what);
    std::vector<double> numbers(count);
    for (double& number : numbers) {
        if (!text.read(number)) return text.expected("a number of " + what);
    }
    return numbers;
}

Result<Array> read_values(TextReader& text, Scalar scalar, std::uint32_t arity, Index tuples,
                          const std::string& what) {
    Index numbers = 0;
    if (!multiply(tuples, arity, numbers) || !fits_text(text, numbers)) {
        return too_many(text, tuples, what);
    }
    switch (scalar) {
        case Scalar::u8:
            return read_integers<std::uint8_t>(text, arity, numbers, what);
        case Scalar::i8:
            return read_integers<std::int8_t>(text, arity, numbers, what);
        case Scalar::u16:
            return read_integers<std::uint16_t>(text, arity, numbers, what);
        case Scalar::i16:
            return read_integers<std::int16_t>(text, arity, numbers, what);
        case Scalar::u32:
            return read_integers<std::uint32_t>(text, arity, numbers, what);
        case Scalar::i32:
            return read_integers<std::int32_t>(text, arity, numbers, what);
        case Scalar::u64:
            return read_integers<std::uint64_t>(text, arity, numbers, what);
        case Scalar::i64:
            return read_integers<std::int64_t>(text, arity, numbers, what);
        case Scalar::f32:
            return read_floats(text, arity, numbers, what);
        case Scalar::f64:
            break;
    }
    Result<std::vector<double>> reals = read_reals(text, numbers, what);
    if (!reals) return reals.error();
    return array_of(*reals, arity);
}

Result<Array> take_values(TextReader& bytes, Scalar scalar, std::uint32_t arity, Index tuples,
                          bool swapped, const std::string& what) {
    Array array{scalar, arity, {}};
    Index size = 0;
    if (!multiply(tuples, array.stride(), size) || size > bytes.bytes_left()) {
        return byte_error(bytes.file(), bytes.offset(),
                          std::to_string(tuples) + " tuples of " + std::to_string(array.stride()) +
                              " bytes are announced for " + what + ", but only " +
                              std::to_string(bytes.bytes_left()) + " bytes are left");
    }
    const std::string_view raw = bytes.take(size);
    array.bytes.resize(size);
    if (size != 0) std::memcpy(array.bytes.data(), raw.data(), size);
    if (swapped) swap_bytes(array.bytes, size_of(scalar));
    return array;
}

Result<std::vector<Index>> as_indices(const Array& array) {
    std::vector<Index> indices(array.count() * array.arity);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        std::int64_t value = 0;
        if (is_float(array.scalar) || !integer_at(array, i, value) || value < 0) {
            return Error{Code::unreadable, i, "number " + std::to_string(i) + " is no index"};
        }
        indices[i] = static_cast<Index>(value);
    }
    return indices;
}

void append_values(std::string& out, const Array& array, std::size_t per_line) {
    const std::size_t tuples = array.count();
    for (std::size_t t = 0; t < tuples; ++t) {
        for (std::size_t k = 0; k < array.arity; ++k) {
            append_number(out, array, t * array.arity + k);
            out += k + 1 < array.arity || ((t + 1) % per_line != 0 && t + 1 < tuples) ? ' ' : '\n';
        }
    }
}

Array expand(const Array& values, std::span<const Index> index) {
    if (index.empty()) return values;
    const std::size_t stride = values.stride();
    Array expanded = make_array(values.scalar, values.arity, index.size());
    for (std::size_t e = 0; e < index.size(); ++e) {
        if (index[e] == kNoIndex) continue;
        std::memcpy(expanded.bytes.data() + e * stride, values.bytes.data() + index[e] * stride,
                    stride);
    }
    return expanded;
}

}  // namespace ravel::io
