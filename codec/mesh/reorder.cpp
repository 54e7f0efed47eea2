#include "mesh/reorder.h"

#include <algorithm>
#include <cstring>

namespace ravel {

std::array<std::uint8_t, 4> tet_turn(std::uint32_t number) {
    static const auto table = [] {
        std::array<std::array<std::uint8_t, 4>, 24> all{};
        std::array<std::uint8_t, 4> p{0, 1, 2, 3};
        for (auto& entry : all) {
            entry = p;
            std::next_permutation(p.begin(), p.end());
        }
        return all;
    }();
    return table[number < 24 ? number : 0];
}

std::uint32_t number_of_tet_turn(const std::array<std::uint8_t, 4>& permutation) {
    std::uint32_t n = 0;
    while (n < 23 && tet_turn(n) != permutation) ++n;
    return n;
}

std::vector<Index> inverse_of(const std::vector<Index>& from, Index count) {
    std::vector<Index> to(count, kNoIndex);
    for (Index i = 0; i < from.size(); ++i) to[from[i]] = i;
    return to;
}

namespace {

template <class Integer>
void renumber_as(Attribute& attribute, const std::vector<Index>& point,
                 const std::vector<Index>& cell) {
    const auto values = attribute.values.as<Integer>();
    for (const Reference& r : attribute.references) {
        const std::vector<Index>& map = r.place == Place::point ? point : cell;
        for (std::size_t i = r.component; i < values.size(); i += attribute.values.arity) {
            const auto n = static_cast<Index>(values[i]) - static_cast<Index>(r.base);
            if (n < map.size())
                values[i] = static_cast<Integer>(map[n] + static_cast<Index>(r.base));
        }
    }
}

}  // namespace

void renumber(Attribute& attribute, const std::vector<Index>& point,
              const std::vector<Index>& cell) {
    if (attribute.references.empty()) return;
    switch (attribute.values.scalar) {
        case Scalar::i32:
            return renumber_as<std::int32_t>(attribute, point, cell);
        case Scalar::u32:
            return renumber_as<std::uint32_t>(attribute, point, cell);
        case Scalar::i64:
            return renumber_as<std::int64_t>(attribute, point, cell);
        case Scalar::u64:
            return renumber_as<std::uint64_t>(attribute, point, cell);
        default:
            return;
    }
}

Array gather(const Array& array, const std::vector<Index>& from) {
    Array out{array.scalar, array.arity, {}};
    const std::size_t stride = array.stride();
    out.bytes.resize(stride * from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
        std::memcpy(out.bytes.data() + i * stride, array.bytes.data() + from[i] * stride, stride);
    return out;
}

}  // namespace ravel
