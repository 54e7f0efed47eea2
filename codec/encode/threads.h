// Work that may go on beside other work.
#pragma once

#include <future>
#include <system_error>

namespace ravel {

// What `work` returns, or throws. On a thread of its own, if there are `more` and the system gives
// one; else when it is asked for.
template <class Work>
auto start(bool more, const Work& work) {
    try {
        if (more) return std::async(std::launch::async, work);
    } catch (const std::system_error&) {
        // Without a thread it takes longer.
    }
    return std::async(std::launch::deferred, work);
}

}  // namespace ravel
