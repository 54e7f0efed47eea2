// What the WebAssembly module exports. One call at a time; the arrays of an answer are good until
// the next call.
#include <cstdlib>
#include <new>
#include <optional>

#include "decoder/describe.h"

// Throws in the page, which drops the module: nothing runs on after it.
extern "C" __attribute__((import_module("ravel"), import_name("out_of_memory"), noreturn)) void
ravel_out_of_memory();

void* operator new(std::size_t size) {
    void* memory = std::malloc(size);
    if (memory == nullptr && size > 0) ravel_out_of_memory();
    return memory;
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace ravel::web {

void put_array(Reply& reply, const void* data, std::size_t) {
    reply.number(static_cast<double>(reinterpret_cast<std::uintptr_t>(data)));
}

namespace {

struct Answer {
    Bytes input;
    std::optional<Result<Decoded>> decoded;
    std::vector<Bytes> more;
    Reply reply;
};
// The last one is never destroyed: the module ends when the page drops it.
Answer* answer = nullptr;

}  // namespace

extern "C" {

__attribute__((export_name("input"))) std::byte* ravel_input(std::size_t size) {
    delete answer;
    answer = new Answer;
    answer->input.resize(size);
    return answer->input.data();
}
__attribute__((export_name("decode"))) void ravel_web_decode(double memory_limit, bool strip,
                                                             bool surface) {
    DecodeOptions options;
    options.memory_limit = static_cast<std::uint64_t>(memory_limit);
    options.steps = strip;
    Result<Decoded>& decoded = answer->decoded.emplace(decode(answer->input, options));
    answer->input = Bytes();
    if (decoded)
        describe(*decoded, {strip, surface}, answer->more, answer->reply);
    else
        describe(decoded.error(), answer->reply);
}
__attribute__((export_name("info"))) void ravel_web_info() {
    const Result<FileInfo> info = inspect(answer->input);
    if (info)
        describe(*info, answer->reply);
    else
        describe(info.error(), answer->reply);
}
__attribute__((export_name("reply"))) const std::byte* ravel_web_reply() {
    return answer->reply.bytes.data();
}
}

}  // namespace ravel::web
