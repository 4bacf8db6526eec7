#pragma once

#include "solver/scene/time_step.h"

#include <map>
#include <string>

namespace plumbline {

/// What happened between two times: how many steps each limit decided, by its name; "end" counts those
/// cut short by the end, "fixed" those of a chosen length.
struct Advance {
    int steps = 0;
    double smallest_step = HUGE_VAL;  // [s], those cut short left out
    std::map<std::string_view, int> decided = {};

    void count(std::string_view why, double dt) {
        ++steps, ++decided[why];
        if (why != "end") smallest_step = std::min(smallest_step, dt);
    }
};

/// Steps of `dt` until `duration` [s] is over, the last one shorter.
/// Throws InvalidInput unless dt > 0 and duration ≥ 0.
template <class Scene> Advance advance_by_fixed_steps(Scene& scene, double duration, double dt) {
    require_positive(dt, "time step");
    if (!(duration >= 0.0 && duration < HUGE_VAL))
        throw InvalidInput("duration: expected a finite number ≥ 0, found " +
                           std::to_string(duration));
    Advance record;
    // Times are multiples, not sums, so that no rounding adds a step.
    const double whole = std::floor(duration / dt * (1.0 + 1e-12));
    for (double n = 0; n < whole; ++n) scene.step(dt), record.count("fixed", dt);
    if (const double rest = duration - whole * dt; rest > 1e-12 * dt)
        scene.step(rest), record.count("end", rest);
    return record;
}

/// Steps as long as the limits that the scene computes allow, but not longer than `largest`, until
/// `duration` [s] is over. The limits of a step are those that its predecessor found; a step of no
/// time comes first, to find the first ones.
/// Throws InvalidInput where the limits vanish or are not numbers: the state has blown up.
template <class Scene>
Advance advance_by_limits(Scene& scene, double duration, double largest = HUGE_VAL) {
    static_assert(Scene::template stores<TimeStepLimits>, "no pass of the scene limits its steps");
    Advance record;
    scene.step(0.0);
    for (double t = 0.0; t < duration;) {
        const TimeStepLimits& limits = scene.template get<TimeStepLimits>();
        const double limit = limits.smallest(), rest = duration - t;
        if (!(limit > 1e-12 * duration))
            throw InvalidInput("time step: expected a limit above 1e-12 of the duration, found " +
                               std::to_string(limit) + " by " + std::string(limits.binding()) +
                               " at t = " + std::to_string(t));
        const double wanted = std::min(limit, largest);
        const bool last = rest <= wanted * (1.0 + 1e-9);  // no crumb is left over by rounding
        // A short last step would have to undo in no time what DFSPH tolerates of density errors.
        const bool halved = !last && rest < 2.0 * wanted;
        const double dt = last ? rest : halved ? 0.5 * rest : wanted;
        record.count(last || halved ? "end" : wanted == limit ? limits.binding() : "fixed", dt);
        scene.step(dt);
        t = last ? duration : t + dt;
    }
    return record;
}

}  // namespace plumbline
