#pragma once

#include "benchmarks/scenes/fluid_frontier.h"

namespace benchmarks {

/// A case, its variants, and how to run one of them.
struct FluidTask {
    std::string name, error, error_of, resolution_of;
    std::vector<int> quick_resolutions, resolutions;
    std::vector<FluidCandidate> variants;              // at each resolution
    std::function<double(const FluidCandidate&)> run;  // the error
};
const std::vector<FluidTask>& all_fluid_tasks();

}  // namespace benchmarks
