#pragma once

#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

#include <cmath>

namespace plumbline {

/// The time at the end of the step [s].
struct Time {
    double value = 0.0;
};

/// Adds up the steps. Before an integrator that evaluates forces at the end of a step, as Leapfrog does; its first step
/// is to be one of no time.
struct KeepTime {
    using Reads = Quantities<>;
    using Writes = Quantities<Time>;
    void run(double dt, Time& time) const { time.value += dt; }
};

/// What every particle weighs in the frame of the tank [m/s²]: the pressure of fluid at rest in it has the gradient
/// ρ times this.
template <int Dim> struct ApparentGravity { Vec<Dim> value = Vec<Dim>::Zero(); };

/// Gravity in a tank that is moved to X(t) = A cos ωt, from rest: aᵢ += g − Ẍ = g + A ω² cos ωt. Positions and velocities are
/// those relative to the tank.
template <int Dim> struct SwayingFrame {
    using Reads = Quantities<Time>;
    using Writes = Quantities<ApparentGravity<Dim>, Accelerations<Dim>>;
    Vec<Dim> g;
    Vec<Dim> amplitude = Vec<Dim>::Zero();  // A [m]
    double angular_frequency = 0.0;         // ω [1/s]

    void run(double, const Time& time, ApparentGravity<Dim>& apparent,
             Accelerations<Dim>& a) const {
        const double omega = angular_frequency;
        apparent.value = g + omega * omega * std::cos(omega * time.value) * amplitude;
        parallel_for_parts(a.size(), [&](std::size_t first, std::size_t last) {
            const Vec<Dim> all = apparent.value;  // a copy, which what is written cannot change
            for (std::size_t i = first; i < last; ++i) a[i] += all;
        });
    }
};

}  // namespace plumbline
