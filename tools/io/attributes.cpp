#include "io/attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ravel::io {

Array integers_from_text(std::span<const std::int64_t> numbers, std::uint32_t arity) {
    const bool small = std::all_of(numbers.begin(), numbers.end(), [](std::int64_t number) {
        return number >= std::numeric_limits<std::int32_t>::min() &&
               number <= std::numeric_limits<std::int32_t>::max();
    });
    if (!small) return array_of(numbers, arity);
    Array array{Scalar::i32, arity, {}};
    array.bytes.resize(numbers.size() * sizeof(std::int32_t));
    std::transform(numbers.begin(), numbers.end(), array.as<std::int32_t>().begin(),
                   [](std::int64_t number) { return static_cast<std::int32_t>(number); });
    return array;
}

bool integer_at(const Array& array, std::size_t flat, std::int64_t& value) {
    return with_values(array, [&](auto values) {
        const auto number = values[flat];
        if constexpr (std::is_floating_point_v<decltype(+number)>) {
            constexpr double kLimit = 9007199254740992.0;  // 2^53: beyond, doubles skip integers
            const double wide = static_cast<double>(number);
            if (!(std::abs(wide) <= kLimit) || std::trunc(wide) != wide) return false;
            if (wide == 0 && std::signbit(wide)) return false;
        } else if constexpr (std::is_same_v<std::remove_cv_t<decltype(number)>, std::uint64_t>) {
            if (number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
                return false;
        }
        value = static_cast<std::int64_t>(number);
        return true;
    });
}

double real_at(const Array& array, std::size_t flat) {
    return with_values(array, [&](auto values) { return static_cast<double>(values[flat]); });
}

bool all_integers(const Array& array) {
    std::int64_t ignored = 0;
    for (std::size_t i = 0; i < array.count() * array.arity; ++i)
        if (!integer_at(array, i, ignored)) return false;
    return true;
}

const Attribute* find_attribute(const Mesh& mesh, Place place, std::string_view name) {
    for (const Attribute& attribute : mesh.attributes)
        if (attribute.place == place && attribute.name == name) return &attribute;
    return nullptr;
}

Attribute& add_attribute(Mesh& mesh, std::string name, Place place, Array values,
                         std::vector<Index> index) {
    mesh.attributes.push_back({std::move(name), place, std::move(values), std::move(index), {}});
    return mesh.attributes.back();
}

const Note* find_note(const Mesh& mesh, std::string_view key) {
    for (const Note& note : mesh.notes)
        if (note.key == key) return &note;
    return nullptr;
}

const TagName* find_tag_name(const Mesh& mesh, std::string_view attribute, std::int64_t value) {
    for (const TagName& tag : mesh.tag_names)
        if (tag.attribute == attribute && tag.value == value) return &tag;
    return nullptr;
}

}  // namespace ravel::io
