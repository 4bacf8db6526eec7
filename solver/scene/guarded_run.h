#pragma once

#include "solver/particles/box.h"
#include "solver/scene/simulation.h"

#include <optional>
#include <stdexcept>
#include <vector>

namespace plumbline {

/// A simulation cannot go on. The message names the particle, the term and the time; the simulation itself is back in
/// its last good state, at the beginning of the step that failed.
struct SimulationFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What particles of this scene may not leave: as its file says, or all particles and ghosts of its start,
/// and around them as much again as their longest edge.
Box<3> domain_of(const SceneFile& scene, const Snapshot& start);

/// How long the next step is, and what decided that: a limit by its name, "fixed" or "largest" for what the scene
/// file sets, "output" where it is cut short by a frame or the end.
struct NextStep {
    double dt;  // [s]
    std::string_view why;
    double end;  // the time after it [s]
};
/// From `time` towards `event`, which is reached exactly, with two halves where one step is not enough: a short last
/// one would shake an incompressible fluid, whose pressures are errors over Δt²; steps differ by less than 1e-9 of their
/// length from what decides them, so that no crumb is left over.
/// Throws SimulationFailed where the limits vanish or are not numbers.
NextStep next_step(const SceneFile& scene, const TimeStepLimits& limits, double time, double event);

/// Steps a simulation, and looks after each step whether all particles and bodies are in the domain and all numbers
/// finite. A step that fails is done again, from a state kept some steps ago, with a watch on every term.
class GuardedRun {
public:
    GuardedRun(Simulation& simulation, const Box<3>& domain)
        : simulation_{simulation}, domain_{domain} {}

    double time() const { return time_; }
    std::size_t steps() const { return steps_; }
    /// After the simulation took another state.
    void restart_at(double time, std::size_t steps);
    /// Throws SimulationFailed; time() and steps() are then those of the last good state.
    void step(const NextStep& next);

private:
    struct Trouble {
        enum Kind { not_finite, escaped, body_escaped } kind;
        std::size_t number;  // of the particle or the body
    };
    std::optional<Trouble> trouble() const;
    [[noreturn]] void explain(const NextStep& next, const std::string& thrown);

    Simulation& simulation_;
    Box<3> domain_;
    double time_ = 0.0;
    std::size_t steps_ = 0;
    std::string kept_;                // a good state ...
    std::vector<double> since_kept_;  // ... and the steps that led from it to the present one
};

}  // namespace plumbline
