#include "ravel/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>

#include "ravel/talk.h"

namespace ravel::tool {
namespace {

// A light that runs to and fro: how far the work is nobody knows before it is done.
std::string bar(unsigned tick) {
    constexpr unsigned kWidth = 12, kLight = 3, kWay = kWidth - kLight;
    const unsigned there = tick % (2 * kWay), at = there <= kWay ? there : 2 * kWay - there;
    std::string text(kWidth, '.');
    text.replace(at, kLight, kLight, '#');
    return "[" + text + "]";
}

}  // namespace

Progress::Progress(std::string file, std::string work)
    : file_(std::move(file)), work_(std::move(work)) {
    if (is_quiet() || ::isatty(STDERR_FILENO) == 0) return;
    try {
        painter_ = std::thread([this] { paint(); });
    } catch (const std::exception&) {
        // Without a thread there is no line, and the work goes on.
    }
}

Progress::~Progress() {
    if (!painter_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    ended_.notify_all();
    painter_.join();
}

void Progress::now(std::string work) {
    const std::lock_guard lock(mutex_);
    work_ = std::move(work);
}

void Progress::paint() {
    using namespace std::chrono_literals;
    const auto start = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    if (ended_.wait_for(lock, 1s, [this] { return done_; })) return;
    for (unsigned tick = 0; !done_; ++tick) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
            std::chrono::steady_clock::now() - start);
        const std::string line =
            fmt::format("\r\033[Kravel: {} {}: {}, {} s", bar(tick), file_, work_, seconds.count());
        std::fputs(line.c_str(), stderr);
        set_line_shown(true);
        ended_.wait_for(lock, 150ms, [this] { return done_; });
    }
    std::fputs("\r\033[K", stderr);
    set_line_shown(false);
}

}  // namespace ravel::tool
