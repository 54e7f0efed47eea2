#include "io/decimals.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/attributes.h"
#include "io/text_reader.h"

namespace ravel::io {

void append_number(std::string& out, const Array& array, std::size_t flat) {
    with_values(array, [&](auto values) { append_number(out, values[flat]); });
}

bool survives_float32(double value) {
    if (std::isnan(value) || std::isinf(value)) return true;
    if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) return false;
    char buffer[40];
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value));
    double back = 0;
    std::from_chars(buffer, end, back);
    return std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(value);
}

Array floats_from_text(std::span<const double> numbers, std::uint32_t arity) {
    if (!std::all_of(numbers.begin(), numbers.end(), survives_float32))
        return array_of(numbers, arity);
    Array array{Scalar::f32, arity, {}};
    array.bytes.resize(numbers.size() * sizeof(float));
    std::transform(numbers.begin(), numbers.end(), array.as<float>().begin(),
                   [](double number) { return static_cast<float>(number); });
    return array;
}

bool TextNumbers::add(std::string_view word) {
    double real = 0;
    if (!parse_real(word, real)) return false;
    std::int64_t integer = 0;
    constexpr double kExact = 9007199254740992.0;  // 2^53
    const bool whole =
        std::abs(real) <= kExact && std::trunc(real) == real && !(real == 0 && std::signbit(real));
    if (integers_.size() == reals_.size()) {
        if (parse_integer(word, integer) && (whole || integer != 0)) {
            integers_.push_back(integer);
        } else if (whole) {
            integers_.push_back(static_cast<std::int64_t>(real));
        }
    }
    reals_.push_back(real);
    return true;
}

Array TextNumbers::take(std::uint32_t arity) const {
    if (integers_.size() == reals_.size()) return integers_from_text(integers_, arity);
    return floats_from_text(reals_, arity);
}

}  // namespace ravel::io
