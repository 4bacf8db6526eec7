#pragma once

#include <chrono>
#include <vector>

namespace benchmarks {

/// Median and median absolute deviation over the repeats [s].
struct Timing {
    double median_s, mad_s;
};

Timing summarise(const std::vector<double>& seconds);

template <class Work> double seconds_of(Work work) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace benchmarks
