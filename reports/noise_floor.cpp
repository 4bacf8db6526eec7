#include "reports/noise_floor.h"

#include "benchmarks/framework/timing.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reports {

namespace {
/// Some milliseconds of what the solver does all day: read, compute, write.
double work(std::vector<double>& values) {
    double total = 0.0;
    for (int pass = 0; pass < 20; ++pass)
        for (double& v : values) {
            v = 0.5 * (v + std::sqrt(1.0 + v));
            total += v;
        }
    return total;
}
}  // namespace

NoiseFloor measure_noise_floor() {
    NoiseFloor floor{.relative = 0, .spread = 0, .seconds = 0, .rounds = 5, .runs = 9};
    std::vector<double> values(1 << 15, 1.0), all;
    volatile double kept = work(values);  // warm, and not optimised away
    for (int round = 0; round < floor.rounds; ++round) {
        std::vector<double> a, b;
        for (int k = 0; k < floor.runs; ++k)
            for (std::vector<double>* times : {&a, &b})
                times->push_back(benchmarks::seconds_of([&] { kept = work(values); }));
        const double ratio = benchmarks::summarise(a).median_s / benchmarks::summarise(b).median_s;
        floor.relative = std::max(floor.relative, std::max(ratio, 1.0 / ratio) - 1.0);
        all.insert(all.end(), a.begin(), a.end());
        all.insert(all.end(), b.begin(), b.end());
    }
    const benchmarks::Timing timing = benchmarks::summarise(all);
    floor.seconds = timing.median_s;
    floor.spread = timing.mad_s / timing.median_s;
    return floor;
}

}  // namespace reports
