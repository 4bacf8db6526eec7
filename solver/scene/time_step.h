#pragma once

#include "solver/fluid/tait_equation.h"

#include <algorithm>
#include <mutex>
#include <string_view>

namespace plumbline {

/// The largest stable time steps for the present state [s]; infinite where nothing limits.
struct TimeStepLimits {
    double acoustic = HUGE_VAL, viscous = HUGE_VAL, force = HUGE_VAL, advective = HUGE_VAL;

    double smallest() const { return std::min({acoustic, viscous, force, advective}); }
    /// The name of the smallest one: "acoustic", "viscous", "force" or "advective".
    std::string_view binding() const {
        const double dt = smallest();
        return acoustic == dt  ? "acoustic"
               : viscous == dt ? "viscous"
               : force == dt   ? "force"
                               : "advective";
    }
};

/// The largest f(q) ≥ 0 of all members; the order does not matter, so threads do not.
template <class Q, class F> double largest(const Q& q, F f) {
    std::mutex mutex;
    double most = 0.0;
    parallel_for_parts(q.size(), [&](std::size_t first, std::size_t last) {
        double most_of_part = 0.0;
        for (std::size_t i = first; i < last; ++i) most_of_part = std::max(most_of_part, f(q[i]));
        const std::scoped_lock lock(mutex);
        most = std::max(most, most_of_part);
    });
    return most;
}

/// Δt ≤ C h / (c + v), c at the largest density, v the largest speed, h the support: sound must not
/// cross what a particle feels. With C = 0.4 below the exact limit 2/ω of square, hexagonal and cubic
/// lattices for all kernels of Plumbline but spiky, from 1.6 to 3.2 spacings per support.
template <int Dim> struct AcousticLimit {
    using Reads = Quantities<Velocities<Dim>, Density>;
    using Writes = Quantities<TimeStepLimits>;
    TaitEquation equation;
    double support;        // h [m]
    double courant = 0.4;  // C

    void run(double, const Velocities<Dim>& v, const Density& rho, TimeStepLimits& limits) const {
        const double v2 = largest(v, [](const Vec<Dim>& v_i) { return v_i.squaredNorm(); });
        const double largest_density =
            std::max(equation.rest_density(), largest(rho, [](double rho_i) { return rho_i; }));
        limits.acoustic =
            courant * support / (equation.speed_of_sound(largest_density) + std::sqrt(v2));
    }
};

/// Δt ≤ C h²/ν, ν the kinematic viscosity. C = 0.04 is below the exact limit 2/(ν λ) of
/// BrookshawViscosity on hexagonal and close packed lattices; MonaghanViscosity, which damps compression twice as much,
/// needs 0.025 with Wendland's C2 or the cubic spline, 0.016 with wider ones.
struct ViscousLimit {
    using Reads = Quantities<>;
    using Writes = Quantities<TimeStepLimits>;
    double nu;               // [m²/s]
    double support;          // h [m]
    double fraction = 0.04;  // C

    void run(double, TimeStepLimits& limits) const {
        limits.viscous = fraction * support * support / nu;
    }
};

/// Δt ≤ C √(h / a), a the largest acceleration. After the forces.
template <int Dim> struct ForceLimit {
    using Reads = Quantities<Accelerations<Dim>>;
    using Writes = Quantities<TimeStepLimits>;
    double support;          // h [m]
    double fraction = 0.25;  // C

    void run(double, const Accelerations<Dim>& a, TimeStepLimits& limits) const {
        const double a2 = largest(a, [](const Vec<Dim>& a_i) { return a_i.squaredNorm(); });
        limits.force = fraction * std::sqrt(support / std::sqrt(a2));
    }
};

/// Δt ≤ C d / v, v the largest speed: for incompressible fluids, where no particle is to move by much of the
/// spacing d in a step.
template <int Dim> struct AdvectiveLimit {
    using Reads = Quantities<Velocities<Dim>>;
    using Writes = Quantities<TimeStepLimits>;
    double spacing;         // d [m]
    double fraction = 0.4;  // C

    void run(double, const Velocities<Dim>& v, TimeStepLimits& limits) const {
        const double v2 = largest(v, [](const Vec<Dim>& v_i) { return v_i.squaredNorm(); });
        limits.advective = fraction * spacing / std::sqrt(v2);
    }
};

}  // namespace plumbline
