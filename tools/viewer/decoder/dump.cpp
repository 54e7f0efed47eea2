// What the page's decoder must answer, by the native decoder: replies with their arrays inline.
//     ravel_viewer_dump [--time] FILE.ravel OUT.reply [FILE OUT ...]
// Prints a line per file: milliseconds of the processor, the best of several with --time.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string_view>

#include "decoder/describe.h"

namespace ravel::web {

void put_array(Reply& reply, const void* data, std::size_t size) {
    reply.raw(data, size);
}

namespace {

void answer(std::span<const std::byte> bytes, Reply& reply) {
    DecodeOptions all;
    all.steps = true;
    Result<Decoded> decoded = decode(bytes, all);
    std::vector<Bytes> more;
    reply = {};
    if (decoded)
        describe(*decoded, {true, true}, more, reply);
    else
        describe(decoded.error(), reply);
}

bool dump(const char* from, const char* to, bool timed) {
    std::ifstream file(from, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    if (!file) return false;
    Reply reply;
    double best = 0;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(timed ? 2000 : 0);
    do {
        const std::clock_t start = std::clock();
        answer(std::as_bytes(std::span(bytes)), reply);
        const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best = best == 0 ? ms : std::min(best, ms);
    } while (Clock::now() < end);
    std::printf("%.3f\n", best);
    std::ofstream out(to, std::ios::binary);
    out.write(reinterpret_cast<const char*>(reply.bytes.data()),
              static_cast<std::streamsize>(reply.bytes.size()));
    return static_cast<bool>(out.flush());
}

}  // namespace
}  // namespace ravel::web

int main(int count, char** words) {
    int word = 1;
    const bool timed = count > 1 && std::string_view(words[1]) == "--time";
    word += timed;
    for (; word + 1 < count; word += 2)
        if (!ravel::web::dump(words[word], words[word + 1], timed)) return 1;
    return 0;
}
