#include "benchmarks/framework/timing.h"

#include "verification/framework/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace benchmarks {

namespace {
/// The largest k with 2 P(Bin(n, 1/2) < k) ≤ 5 %; 0 if there is none.
std::size_t rank_of_interval(std::size_t n) {
    double term = std::ldexp(1.0, -static_cast<int>(n)), below = 0.0;
    for (std::size_t k = 0; k <= n; ++k) {
        below += term;
        if (2.0 * below > 0.05) return k;
        term *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return n;
}
}  // namespace

Timing summarise(const std::vector<double>& seconds) {
    const double middle = verification::median(seconds);
    std::vector<double> deviations;
    for (const double s : seconds) deviations.push_back(std::abs(s - middle));
    return {middle, verification::median(std::move(deviations))};
}

double Ratio::relative() const { return std::max(high - value, value - low) / value; }

Ratio ratio_of(std::span<const double> a, std::span<const double> b, double noise) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) ratios.push_back(a[k] / b[k]);
    std::ranges::sort(ratios);
    Ratio ratio{verification::median(ratios), 0.0, std::numeric_limits<double>::infinity()};
    if (const std::size_t rank = rank_of_interval(ratios.size()); rank > 0) {
        ratio.low = std::min(ratios[rank - 1], ratio.value / (1.0 + noise));
        ratio.high = std::max(ratios[ratios.size() - rank], ratio.value * (1.0 + noise));
    }
    return ratio;
}

}  // namespace benchmarks
