// Work that may go on beside other work.
#pragma once

#include <future>
#include <utility>

namespace ravel {

// What `work` returns, or throws. On a thread of its own, if there are `more` and the system has
// one to give; else when it is asked for.
template <class Work>
auto start(bool more, Work work) {
    return std::async(more ? std::launch::async | std::launch::deferred : std::launch::deferred,
                      std::move(work));
}

}  // namespace ravel
