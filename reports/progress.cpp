#include "reports/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace reports {

Progress::Progress(std::size_t steps) : steps_{steps}, shown_{isatty(STDERR_FILENO) != 0} {}

Progress::~Progress() {
    if (shown_ && done_ > 0) fmt::print(stderr, "\r\033[K");
}

void Progress::step(std::string_view what) {
    ++done_;
    if (!shown_) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    const double per_step = spent.count() / static_cast<double>(done_);
    const double left = per_step * static_cast<double>(steps_ - done_ + 1);
    fmt::print(stderr, "\r\033[K{}/{}  about {:.0f} s left  {}", done_, steps_, left,
               what.substr(0, 48));
    std::fflush(stderr);
}

}  // namespace reports
