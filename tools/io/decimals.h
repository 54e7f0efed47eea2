// Numbers as decimals and back: the shortest decimal that reads back as the same bits, and the rule
// that tells float32 from float64 in text files, which do not say.
#pragma once

#include <charconv>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ravel/mesh.h"

namespace ravel::io {

// Appends the shortest decimal that reads back as `value` in its own type.
template <class T>
requires std::integral<T> || std::floating_point<T>
void append_number(std::string& out, T value) {
    char buffer[40];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, end);
}

// Appends number `flat` (tuple * arity + component) of an array.
void append_number(std::string& out, const Array& array, std::size_t flat);

// Is float32 enough to write the same number again: does the shortest decimal of the nearest
// float32 read as exactly this double?
bool survives_float32(double value);

// One array for numbers read from text: float32 where every number survives it, float64 otherwise.
Array floats_from_text(std::span<const double> numbers, std::uint32_t arity);

// Numbers whose type the file does not tell: integers where all of them are whole (so that "1" and
// "1.0" mean the same), floats otherwise.
class TextNumbers {
  public:
    bool add(std::string_view word);  // false when it is no number
    std::size_t size() const { return reals_.size(); }
    Array take(std::uint32_t arity) const;

  private:
    std::vector<double> reals_;
    std::vector<std::int64_t> integers_;  // as long as all are
};

}  // namespace ravel::io
