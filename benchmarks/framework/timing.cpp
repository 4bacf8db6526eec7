#include "benchmarks/framework/timing.h"

#include "verification/framework/statistics.h"

#include <cmath>

namespace benchmarks {

Timing summarise(const std::vector<double>& seconds) {
    const double middle = verification::median(seconds);
    std::vector<double> deviations;
    for (const double s : seconds) deviations.push_back(std::abs(s - middle));
    return {middle, verification::median(std::move(deviations))};
}

}  // namespace benchmarks
