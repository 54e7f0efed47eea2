// Any bytes into the interface for C: size query, decoding under a small limit, into buffers that
// are just large enough.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "ravel/ravel_c.h"

namespace {

void fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ravel_error error;
    ravel_summary holds;
    ravel_summary_init(&holds, sizeof holds);
    const int code = ravel_inspect(data, size, &holds, &error);
    if (code != RAVEL_DONE && error.sentence[0] == 0) fail("an error without words");
    ravel_decode_options options;
    ravel_decode_options_init(&options, sizeof options);
    options.memory_limit = std::uint64_t{16} << 20;
    const bool fits = code == RAVEL_DONE && holds.points < 100000 && holds.corners < 100000 &&
                      holds.cells < 100000;
    std::vector<double> positions(fits ? 3 * holds.points : 0);
    std::vector<std::uint32_t> corners(fits ? holds.corners : 0), begin(fits ? holds.cells + 1 : 0),
        cell(fits ? holds.cells : 0), position(fits ? holds.cells : 0);
    ravel_buffers buffers;
    ravel_buffers_init(&buffers, sizeof buffers);
    buffers.position_scalar = RAVEL_F64;
    const auto lend = [](auto& list, void*& data_of, std::size_t& size_of) {
        data_of = list.data();
        size_of = list.size() * sizeof list[0];
    };
    lend(positions, buffers.positions, buffers.positions_size);
    lend(corners, buffers.corners, buffers.corners_size);
    lend(begin, buffers.corner_begin, buffers.corner_begin_size);
    lend(cell, buffers.strip_cell, buffers.strip_cell_size);
    lend(position, buffers.strip_position, buffers.strip_position_size);
    const int decoded = ravel_decode_into(data, size, &options, &buffers, &error);
    if (decoded == RAVEL_BUG) fail("a bug");
    if (decoded == RAVEL_DONE && code != RAVEL_DONE) fail("decoded what inspect refuses");
    if (decoded == RAVEL_DONE && fits)
        for (const std::uint32_t corner : corners)
            if (corner >= holds.points) fail("a corner names no point");
    return 0;
}
