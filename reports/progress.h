#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace reports {

/// A line on stderr that says what is being done and how much time is left; on a terminal only.
class Progress {
public:
    explicit Progress(std::size_t steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The next step begins.
    void step(std::string_view what);

private:
    std::size_t steps_, done_ = 0;
    bool shown_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace reports
