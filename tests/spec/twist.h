// A valid file whose streams go another way at one place: so that its fault is the one that is
// meant, and comes first.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/bytes.h"
#include "predict/position_codes.h"
#include "walk/walk.h"

namespace ravel::test {

// What the walk asks for, by its name in the format ("kOldNear"), how often that was asked for
// before, and what has been visited; answers take the place of what the file says.
struct Question {
    std::string block;
    int before = 0;
    const Walked& walked;
};
struct Twist {
    std::function<std::optional<bool>(const Question&)> flag;
    std::function<std::optional<std::uint64_t>(const Question&)> number;
};

// `file` with other connectivity, up to where the walk refuses to go on. What follows a twist reads
// as the likely answers. Throws a std::runtime_error where the walk goes through.
Bytes with_twisted_walk(const Bytes& file, const Twist& twist);

// `file`, of quads apart, with the given numbers as positions of its first vertices, flags of the
// blocks in `forced` as they say, and `change` made to the head of the section. Throws where no
// fault is found.
struct Positions {
    std::vector<Position> truth;
    std::vector<std::pair<std::string, bool>> forced;
    std::function<void(Bytes&)> change;
};
Bytes with_positions(const Bytes& file, const Positions& positions);

}  // namespace ravel::test
