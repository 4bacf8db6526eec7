#pragma once

#include <chrono>
#include <span>
#include <vector>

namespace benchmarks {

/// Median and median absolute deviation over the repeats [s].
struct Timing {
    double median_s, mad_s;
};

Timing summarise(const std::vector<double>& seconds);

/// How many times as long one thing takes as another, with an interval that holds the true median
/// ratio with a confidence of at least 95 %.
struct Ratio {
    double value, low, high;

    bool tells_apart() const { return low > 1.0 || high < 1.0; }
    /// The farther end of the interval, as a share of the value: 0.06 for ± 6 %.
    double relative() const;
};

/// Below so many rounds no interval between two of the ratios holds the median with 95 % confidence.
inline constexpr std::size_t least_rounds = 6;

/// The median over the rounds of a[k] / b[k], two runs of one round, so that slow spells of the machine
/// cancel. The interval is that of the sign test, between two of the ratios, without any assumption
/// on their distribution: the k-th smallest and k-th largest of n hold the median with probability
/// 1 − 2 P(Bin(n, 1/2) < k). It is widened to value · (1 + noise)^±1, and has no end below
/// `least_rounds` rounds.
Ratio ratio_of(std::span<const double> a, std::span<const double> b, double noise = 0.0);

template <class Work> double seconds_of(Work work) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace benchmarks
