// One thread waits for signals, so that what it does need not be async-signal-safe. A mutex keeps
// it away while folders are made, renamed from, or removed.
#include "ravel/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ravel::tool {
namespace {

namespace fs = std::filesystem;

struct Leftovers {
    std::mutex mutex;
    std::vector<fs::path> folders;
};

// Never destroyed: the thread may outlive main's statics.
Leftovers& leftovers() {
    static auto* const all = new Leftovers;
    return *all;
}

// Who writes goes on meanwhile, and may open its file in a folder that was just found empty: then
// the folder stays, with that file, and is removed again.
void remove_while_written(const fs::path& folder) {
    constexpr int kMostFiles = 100;  // far more than anyone opens
    std::error_code failed;
    for (int i = 0; i < kMostFiles; ++i) {
        fs::remove_all(folder, failed);
        if (!failed) return;
    }
}

void wait_for_end(sigset_t set) {
    int signal = 0;
    if (sigwait(&set, &signal) != 0) return;
    Leftovers& all = leftovers();
    all.mutex.lock();  // for good: nobody makes or renames anything from here on
    for (const fs::path& folder : all.folders) remove_while_written(folder);
    std::signal(signal, SIG_DFL);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    ::kill(::getpid(), signal);
}

}  // namespace

void watch_signals() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    sigset_t set;
    sigemptyset(&set);
    bool any = false;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler == SIG_IGN) continue;
        sigaddset(&set, signal);
        any = true;
    }
    if (!any || pthread_sigmask(SIG_BLOCK, &set, nullptr) != 0) return;
    try {
        std::thread(wait_for_end, set).detach();
    } catch (const std::exception&) {
        pthread_sigmask(SIG_UNBLOCK, &set, nullptr);  // no thread to be had: end as ever
    }
}

Result<fs::path> make_leftover(const fs::path& parent) {
    Leftovers& all = leftovers();
    const std::lock_guard lock(all.mutex);
    std::string name = (parent / ".ravel-XXXXXX").string();
    if (!::mkdtemp(name.data()))
        return Error{Code::unwritable, 0, parent.string() + ": " + std::strerror(errno)};
    all.folders.emplace_back(name);
    return all.folders.back();
}

void remove_leftover(const fs::path& folder) {
    Leftovers& all = leftovers();
    const std::lock_guard lock(all.mutex);
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    all.folders.erase(std::remove(all.folders.begin(), all.folders.end(), folder),
                      all.folders.end());
}

Status without_interruption(const std::function<Status()>& work) {
    const std::lock_guard lock(leftovers().mutex);
    return work();
}

}  // namespace ravel::tool
