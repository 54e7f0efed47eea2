// A line on stderr while long work goes on: what is done to which file, and for how long. Only
// where stderr is a terminal, nobody asked for quiet, and a second has passed; it is wiped at the
// end.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace ravel::tool {

class Progress {
  public:
    Progress(std::string file, std::string work);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    // The next piece of work, e.g. "packing 1273170 tets".
    void now(std::string work);

  private:
    void paint();

    std::string file_, work_;
    bool done_ = false;
    std::mutex mutex_;
    std::condition_variable ended_;
    std::thread painter_;
};

}  // namespace ravel::tool
