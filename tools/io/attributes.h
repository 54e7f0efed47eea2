// Typed access to arrays, and finding and adding attributes by name.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "ravel/mesh.h"

namespace ravel::io {

template <class T>
constexpr Scalar scalar_of() {
    if constexpr (std::is_same_v<T, float>)
        return Scalar::f32;
    else if constexpr (std::is_same_v<T, double>)
        return Scalar::f64;
    else if constexpr (sizeof(T) == 1)
        return std::is_signed_v<T> ? Scalar::i8 : Scalar::u8;
    else if constexpr (sizeof(T) == 2)
        return std::is_signed_v<T> ? Scalar::i16 : Scalar::u16;
    else if constexpr (sizeof(T) == 4)
        return std::is_signed_v<T> ? Scalar::i32 : Scalar::u32;
    else
        return std::is_signed_v<T> ? Scalar::i64 : Scalar::u64;
}

// Calls f(std::span<const T>) with the array's own type.
template <class F>
decltype(auto) with_values(const Array& array, F&& f) {
    switch (array.scalar) {
        case Scalar::u8:
            return f(array.as<std::uint8_t>());
        case Scalar::i8:
            return f(array.as<std::int8_t>());
        case Scalar::u16:
            return f(array.as<std::uint16_t>());
        case Scalar::i16:
            return f(array.as<std::int16_t>());
        case Scalar::u32:
            return f(array.as<std::uint32_t>());
        case Scalar::i32:
            return f(array.as<std::int32_t>());
        case Scalar::u64:
            return f(array.as<std::uint64_t>());
        case Scalar::i64:
            return f(array.as<std::int64_t>());
        case Scalar::f32:
            return f(array.as<float>());
        case Scalar::f64:
            break;
    }
    return f(array.as<double>());
}

// A copy of the values' bytes as an array of their type.
template <class T>
Array array_of(std::span<const T> values, std::uint32_t arity) {
    Array array{scalar_of<T>(), arity, {}};
    array.bytes.resize(values.size_bytes());
    if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), values.size_bytes());
    return array;
}
template <class T>
Array array_of(const std::vector<T>& values, std::uint32_t arity) {
    return array_of(std::span<const T>(values), arity);
}

// Integers read from text: int32 where all of them fit, int64 otherwise.
Array integers_from_text(std::span<const std::int64_t> numbers, std::uint32_t arity);

// Number `flat` as an integer, and whether it is one (floats with a fraction, NaN, too large: no).
bool integer_at(const Array& array, std::size_t flat, std::int64_t& value);
double real_at(const Array& array, std::size_t flat);
// Are all numbers of the array integers (of any type)?
bool all_integers(const Array& array);

const Attribute* find_attribute(const Mesh& mesh, Place place, std::string_view name);
Attribute& add_attribute(Mesh& mesh, std::string name, Place place, Array values,
                         std::vector<Index> index = {});
// The tuple of element `element`, kNoIndex where it has none.
inline Index tuple_of(const Attribute& attribute, Index element) {
    return attribute.index.empty() ? element : attribute.index[element];
}

const Note* find_note(const Mesh& mesh, std::string_view key);
const TagName* find_tag_name(const Mesh& mesh, std::string_view attribute, std::int64_t value);

}  // namespace ravel::io
