#include <cstdint>
#include <vector>

namespace ravel::web {
namespace {

std::size_t at_most(std::uint64_t bytes) {
    return static_cast<std::size_t>(std::min<std::uint64_t>(bytes, SIZE_MAX));
}
std::size_t product(std::size_t size, std::size_t count) {
    return at_most(std::uint64_t{size} * count);
}

}  // namespace

void Store::reserve(std::size_t size, std::size_t count) {
    const std::size_t bytes = product(size, count);
    if (bytes > static_cast<std::size_t>(limit - begin)) ::operator delete(move_to(bytes));
}

void* Store::add(std::size_t bytes) {
    if (bytes > static_cast<std::size_t>(limit - end)) ::operator delete(move_ahead(bytes));
    return std::exchange(end, end + bytes);
}

void Store::append(const void* from, std::size_t bytes) {
    std::byte* old = nullptr;
    if (bytes > static_cast<std::size_t>(limit - end)) old = move_ahead(bytes);
    if (bytes > 0) std::memmove(end, from, bytes);
    end += bytes;
    ::operator delete(old);
}

void Store::fill(const void* from, std::size_t size, std::size_t count) {
    if (count == 0) return;
    std::byte* old = nullptr;
    const std::size_t bytes = product(size, count);
    if (bytes > static_cast<std::size_t>(limit - end)) old = move_ahead(bytes);
    if (from == nullptr) {
        std::memset(end, 0, bytes);
    } else {
        std::memmove(end, from, size);
        for (std::size_t done = size; done < bytes; done *= 2)
            std::memcpy(end + done, end, std::min(done, bytes - done));
    }
    end += bytes;
    ::operator delete(old);
}

void Store::swap(Store& other) {
    std::swap(begin, other.begin);
    std::swap(end, other.end);
    std::swap(limit, other.limit);
}

std::byte* Store::move_to(std::size_t bytes) {
    auto* const to = static_cast<std::byte*>(::operator new(bytes));
    const auto size = static_cast<std::size_t>(end - begin);
    if (size > 0) std::memcpy(to, begin, size);
    end = to + size;
    limit = to + bytes;
    return std::exchange(begin, to);
}

std::byte* Store::move_ahead(std::size_t bytes) {
    const auto size = static_cast<std::size_t>(end - begin),
               held = static_cast<std::size_t>(limit - begin);
    return move_to(std::max(at_most(std::uint64_t{size} + bytes), 2 * held));
}

}  // namespace ravel::web
