#pragma once

#include "verification/framework/study.h"

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace benchmarks {

/// One way to compute a fluid, and what it gave: one run on one thread, from filling the scene to the error.
struct FluidCandidate {
    std::string method, kernel;
    int resolution;              // particles per length of the case
    double support_in_spacings;  // h/dx
    double sound;                // c₀ over the largest speed; 0: incompressible
    double courant;  // steps: of h/(c + v), or of spacings per step where incompressible
    double error = HUGE_VAL, seconds = 0.0;
    std::string failure = {};  // what ended it; empty if nothing did
    bool on_front = false;

    /// Without a number, or no better than no fluid at all.
    bool failed() const { return !(error < 1.0); }
};

struct FluidFrontier {
    std::string task;      // "taylor_green"
    std::string error;     // "velocity error"
    std::string error_of;  // its definition; a ratio
    std::string resolution_of;
    std::vector<FluidCandidate> candidates;
    double noise;  // relative: what two runs of the first candidate differ by
    std::string finding;
};

/// taylor_green, hydrostatic, dam_break.
const std::vector<std::string>& fluid_tasks();
/// The methods of one of them, each once. Throws InvalidInput for a task that is none.
std::vector<std::string> fluid_methods(const std::string& task);

/// Runs every method of a task over resolution, kernel, h/dx, speed of sound and time step: each of the last four varied
/// alone, around a usual choice, at every resolution. `between_runs` may throw to end it.
/// Throws InvalidInput for a task that is none.
FluidFrontier measure_fluids(const std::string& task, verification::Effort effort,
                             const std::function<void()>& between_runs = {});

}  // namespace benchmarks
