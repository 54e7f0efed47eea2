// The module's heap, a tenth of the C library's in size. Small blocks come from lists by size and
// go back to them; large ones from one list of free stretches, ordered by address, where neighbours
// join again. First fit. Every block has its size in front of it.
#include <cstddef>
#include <cstdint>

namespace {

constexpr std::size_t kUnit = 16, kPage = 65536, kSmall = 512;

struct alignas(kUnit) Block {
    std::size_t size;  // with this header, a multiple of kUnit
    Block* next;       // of a free one
};
Block* small_blocks[kSmall / kUnit + 1];
Block* large_blocks;

Block* at(std::uintptr_t address) {
    return reinterpret_cast<Block*>(address);
}
std::uintptr_t end_of(const Block* block) {
    return reinterpret_cast<std::uintptr_t>(block) + block->size;
}

void put_back(Block* block) {
    Block *before = nullptr, *after = large_blocks;
    while (after != nullptr && after < block) before = after, after = after->next;
    block->next = after;
    if (after != nullptr && end_of(block) == reinterpret_cast<std::uintptr_t>(after)) {
        block->size += after->size;
        block->next = after->next;
    }
    if (before == nullptr) {
        large_blocks = block;
    } else if (end_of(before) == reinterpret_cast<std::uintptr_t>(block)) {
        before->size += block->size;
        before->next = block->next;
    } else {
        before->next = block;
    }
}

bool grow(std::size_t size) {
    const std::size_t pages = (size + kPage - 1) / kPage;
    const std::size_t before = __builtin_wasm_memory_grow(0, pages);
    if (before == SIZE_MAX) return false;
    Block* block = at(before * kPage);
    block->size = pages * kPage;
    put_back(block);
    return true;
}

Block* take_large(std::size_t size) {
    for (;;) {
        Block* before = nullptr;
        for (Block* block = large_blocks; block != nullptr; before = block, block = block->next) {
            if (block->size < size) continue;
            Block* rest = block->next;
            if (block->size - size >= kUnit) {
                rest = at(reinterpret_cast<std::uintptr_t>(block) + size);
                rest->size = block->size - size;
                rest->next = block->next;
                block->size = size;
            }
            (before == nullptr ? large_blocks : before->next) = rest;
            return block;
        }
        if (!grow(size)) return nullptr;
    }
}

}  // namespace

extern "C" {

void* malloc(std::size_t count) {
    if (count > SIZE_MAX - kPage) return nullptr;
    const std::size_t size = (count + sizeof(Block) + kUnit - 1) / kUnit * kUnit;
    if (size > kSmall || small_blocks[size / kUnit] == nullptr) {
        Block* block = take_large(size);
        return block == nullptr ? nullptr : block + 1;
    }
    Block* block = small_blocks[size / kUnit];
    small_blocks[size / kUnit] = block->next;
    return block + 1;
}

void free(void* memory) {
    if (memory == nullptr) return;
    Block* block = static_cast<Block*>(memory) - 1;
    if (block->size > kSmall) return put_back(block);
    block->next = small_blocks[block->size / kUnit];
    small_blocks[block->size / kUnit] = block;
}

// One instruction each with bulk memory.
void* memcpy(void* to, const void* from, std::size_t size) {
    return __builtin_memcpy(to, from, size);
}
void* memmove(void* to, const void* from, std::size_t size) {
    return __builtin_memmove(to, from, size);
}
void* memset(void* to, int value, std::size_t size) {
    return __builtin_memset(to, value, size);
}
}
