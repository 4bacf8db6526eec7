#pragma once

#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"
#include "solver/scene/scene.h"

#include <cmath>

namespace verification {

/// a −= x + 2 d v: an oscillator of angular frequency 1, damped by d.
struct Spring {
    using Reads = plumbline::Quantities<plumbline::Positions<2>, plumbline::Velocities<2>>;
    using Writes = plumbline::Quantities<plumbline::Accelerations<2>>;
    double d = 0.0;
    void run(double, const plumbline::Positions<2>& x, const plumbline::Velocities<2>& v,
             plumbline::Accelerations<2>& a) const {
        for (std::size_t i = 0; i < x.size(); ++i) a[i] -= x[i] + 2.0 * d * v[i];
    }
};

using StartOfOscillator = plumbline::Given<plumbline::Positions<2>, plumbline::Velocities<2>>;

/// Starts at x = 1, at rest; `watch(x, v)` after each of `steps` steps.
template <class Scene, class Watch> void oscillate(Scene scene, double dt, int steps, Watch watch) {
    using namespace plumbline;
    scene.template get<Positions<2>>().assign(1, Vec<2>(1, 0));
    scene.template get<Velocities<2>>().assign(1, Vec<2>(0, 0));
    for (int n = 0; n < steps; ++n) {
        scene.step(dt);
        watch(scene.template get<Positions<2>>()[0].x(),
              scene.template get<Velocities<2>>()[0].x());
    }
}

/// How far (x, v) is from its exact values at t = 1.6 with damping d,
/// x = e^(−d t) (cos w t + d/w sin w t) and v = −e^(−d t) sin(w t) / w.
inline double error_of_state(double x, double v, double d) {
    const double t = 1.6, w = std::sqrt(1.0 - d * d), decay = std::exp(-d * t);
    return std::hypot(x - decay * (std::cos(w * t) + d / w * std::sin(w * t)),
                      v + decay * std::sin(w * t) / w);
}
template <class Scene> double error_at_end(Scene scene, double dt, double d) {
    double error = 0.0;
    oscillate(scene, dt, static_cast<int>(std::round(1.6 / dt)),
              [&](double x, double v) { error = error_of_state(x, v, d); });
    return error;
}
/// max ‖(x, v)‖ over `steps` steps: bounded where the scheme is stable.
template <class Scene> double largest_swing(Scene scene, double dt, int steps) {
    double largest = 0.0;
    oscillate(scene, dt, steps,
              [&](double x, double v) { largest = std::max(largest, std::hypot(x, v)); });
    return largest;
}

}  // namespace verification
