#include "predict/array_planes.h"

#include <cstring>

#include "predict/float_image.h"

namespace ravel {
namespace {

std::uint64_t load(const std::byte* at, std::size_t width) {
    std::uint64_t v = 0;
    std::memcpy(&v, at, width);  // little-endian hosts only; others would have to assemble bytes
    return v;
}

std::uint64_t mask_of(std::size_t width) {
    return width == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * width)) - 1;
}

std::uint64_t to_image(Scalar scalar, std::uint64_t bits) {
    if (scalar == Scalar::f32) return image_of(static_cast<std::uint32_t>(bits));
    return scalar == Scalar::f64 ? image_of(bits) : bits;
}
std::uint64_t from_image(Scalar scalar, std::uint64_t image) {
    if (scalar == Scalar::f32) return bits32_of(image);
    return scalar == Scalar::f64 ? bits64_of(image) : image;
}

// Sign-extends a wrapped difference and folds it to an unsigned number of the same width.
std::uint64_t fold(std::uint64_t d, std::size_t width) {
    const int shift = 64 - static_cast<int>(8 * width);
    return zigzag(static_cast<std::int64_t>(d << shift) >> shift) & mask_of(width);
}

}  // namespace

Bytes planes_of(const Array& array) {
    const std::size_t width = size_of(array.scalar), values = array.bytes.size() / width;
    Bytes planes(array.bytes.size());
    std::vector<std::uint64_t> last(array.arity, 0);
    std::size_t component = 0;
    for (std::size_t i = 0; i < values; ++i) {
        const std::uint64_t image =
            to_image(array.scalar, load(array.bytes.data() + i * width, width));
        const std::uint64_t folded = fold((image - last[component]) & mask_of(width), width);
        last[component] = image;
        if (++component == array.arity) component = 0;
        for (std::size_t b = 0; b < width; ++b)
            planes[b * values + i] = static_cast<std::byte>(folded >> (8 * b));
    }
    return planes;
}

Array array_of_planes(Scalar scalar, std::uint32_t arity, std::span<const std::byte> planes) {
    const std::size_t width = size_of(scalar), values = planes.size() / width;
    Array array{scalar, arity, {}};
    array.bytes.resize(planes.size());
    std::vector<std::uint64_t> last(arity, 0);
    std::size_t component = 0;
    for (std::size_t i = 0; i < values; ++i) {
        std::uint64_t folded = 0;
        for (std::size_t b = 0; b < width; ++b)
            folded |= static_cast<std::uint64_t>(planes[b * values + i]) << (8 * b);
        const std::uint64_t image =
            (last[component] + static_cast<std::uint64_t>(unzigzag(folded))) & mask_of(width);
        last[component] = image;
        if (++component == arity) component = 0;
        const std::uint64_t bits = from_image(scalar, image);
        std::memcpy(array.bytes.data() + i * width, &bits, width);
    }
    return array;
}

}  // namespace ravel
