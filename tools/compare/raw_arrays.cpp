#include <cstring>

#include "compare/raw.h"

namespace ravel::compare {
namespace {

// A run of unsigned numbers of 2, 4 or 8 bytes; `arity` numbers belong together.
struct Numbers {
    std::size_t width = 4;
    std::size_t arity = 1;
    std::vector<std::uint64_t> values;
};

std::uint64_t mask_of(std::size_t width) {
    return width == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * width)) - 1;
}

std::uint64_t zigzag(std::uint64_t difference, std::size_t width) {
    const std::uint64_t sign = difference >> (8 * width - 1) & 1;
    return ((difference << 1) ^ (sign ? ~std::uint64_t{0} : 0)) & mask_of(width);
}

std::uint64_t unzigzag(std::uint64_t code, std::size_t width) {
    return ((code >> 1) ^ (code & 1 ? ~std::uint64_t{0} : 0)) & mask_of(width);
}

void append(std::vector<std::byte>& bytes, const Numbers& numbers, Layout layout) {
    const std::size_t count = numbers.values.size(), begin = bytes.size();
    bytes.resize(begin + count * numbers.width);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t value = numbers.values[i];
        if (layout == Layout::planes) {
            const std::uint64_t before = i < numbers.arity ? 0 : numbers.values[i - numbers.arity];
            value = zigzag((value - before) & mask_of(numbers.width), numbers.width);
        }
        for (std::size_t b = 0; b < numbers.width; ++b) {
            const std::size_t at = layout != Layout::planes ? i * numbers.width + b : b * count + i;
            bytes[begin + at] = static_cast<std::byte>(value >> (8 * b));
        }
    }
}

bool take(std::span<const std::byte>& bytes, Numbers& numbers, std::size_t count, Layout layout) {
    if (bytes.size() < count * numbers.width) return false;
    numbers.values.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t value = 0;
        for (std::size_t b = 0; b < numbers.width; ++b) {
            const std::size_t at = layout != Layout::planes ? i * numbers.width + b : b * count + i;
            value |= static_cast<std::uint64_t>(bytes[at]) << (8 * b);
        }
        if (layout == Layout::planes) {
            const std::uint64_t before = i < numbers.arity ? 0 : numbers.values[i - numbers.arity];
            value = (unzigzag(value, numbers.width) + before) & mask_of(numbers.width);
        }
        numbers.values[i] = value;
    }
    bytes = bytes.subspan(count * numbers.width);
    return true;
}

bool mixed_degrees(const Mesh& mesh) {
    if (mesh.kind == CellKind::tet) return false;
    for (Index c = 1; c < mesh.cell_count(); ++c)
        if (mesh.cell(c).size() != mesh.cell(0).size()) return true;
    return false;
}

// The grid the positions are put on, or null where they stay floats.
const Grid* grid_of(const Input& input, Layout layout) {
    return input.grid && layout != Layout::raw ? &*input.grid : nullptr;
}

std::size_t position_width(const Input& input, Layout layout) {
    if (const Grid* grid = grid_of(input, layout)) return grid->bits <= 16 ? 2 : 4;
    return size_of(input.mesh.positions.scalar);
}

Numbers positions_of(const Input& input, Layout layout) {
    Numbers numbers{position_width(input, layout), 3, {}};
    const Grid* grid = grid_of(input, layout);
    const Mesh& mesh = input.mesh;
    numbers.values.resize(3 * mesh.point_count());
    for (std::size_t i = 0; i < numbers.values.size(); ++i) {
        const int k = static_cast<int>(i % 3);
        if (grid)
            numbers.values[i] = grid_number(*grid, coordinate(mesh, i / 3, k), k);
        else
            std::memcpy(&numbers.values[i], mesh.positions.bytes.data() + i * numbers.width,
                        numbers.width);
    }
    return numbers;
}

}  // namespace

std::vector<std::byte> arrays_of(const Input& input, Layout layout) {
    const Mesh& mesh = input.mesh;
    std::vector<std::byte> bytes;
    if (mixed_degrees(mesh)) {
        Numbers degrees;
        for (Index c = 0; c < mesh.cell_count(); ++c) degrees.values.push_back(mesh.cell(c).size());
        append(bytes, degrees, layout);
    }
    append(bytes, Numbers{4, 1, mesh.corners}, layout);
    append(bytes, positions_of(input, layout), layout);
    return bytes;
}

std::size_t arrays_size(const Input& input, Layout layout) {
    const Mesh& mesh = input.mesh;
    const Index degrees = mixed_degrees(mesh) ? mesh.cell_count() : 0;
    return 4 * (degrees + mesh.corners.size()) +
           3 * position_width(input, layout) * mesh.point_count();
}

Result<Mesh> mesh_of_arrays(std::span<const std::byte> arrays, const Input& input, Layout layout) {
    const Mesh& original = input.mesh;
    const Error broken{Code::corrupt, 0, "the arrays end early"};
    Mesh mesh;
    mesh.kind = original.kind;
    if (mixed_degrees(original)) {
        Numbers degrees;
        if (!take(arrays, degrees, original.cell_count(), layout)) return broken;
        mesh.corner_begin.push_back(0);
        for (std::uint64_t degree : degrees.values)
            mesh.corner_begin.push_back(mesh.corner_begin.back() + degree);
    } else {
        mesh.corner_begin = original.corner_begin;  // one degree for all: a header tells it
    }
    Numbers corners;
    if (!take(arrays, corners, original.corners.size(), layout)) return broken;
    mesh.corners = std::move(corners.values);
    Numbers positions{position_width(input, layout), 3, {}};
    const Grid* grid = grid_of(input, layout);
    if (!take(arrays, positions, 3 * original.point_count(), layout)) return broken;
    mesh.positions =
        make_array(grid ? Scalar::f32 : original.positions.scalar, 3, original.point_count());
    for (std::size_t i = 0; i < positions.values.size(); ++i) {
        const int k = static_cast<int>(i % 3);
        if (grid)
            mesh.positions.as<float>()[i] = static_cast<float>(
                grid_value(*grid, static_cast<std::uint32_t>(positions.values[i]), k));
        else
            std::memcpy(mesh.positions.bytes.data() + i * positions.width, &positions.values[i],
                        positions.width);
    }
    return mesh;
}

}  // namespace ravel::compare
