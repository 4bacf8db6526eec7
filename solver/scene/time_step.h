#pragma once

#include "solver/fluid/tait_equation.h"

#include <algorithm>
#include <string_view>

namespace plumbline {

/// The largest stable time steps for the present state [s]; infinite where nothing limits.
struct TimeStepLimits {
    double acoustic = HUGE_VAL, viscous = HUGE_VAL, force = HUGE_VAL;

    double smallest() const { return std::min({acoustic, viscous, force}); }
    /// The name of the smallest one: "acoustic", "viscous" or "force".
    std::string_view binding() const {
        const double dt = smallest();
        return acoustic == dt ? "acoustic" : viscous == dt ? "viscous" : "force";
    }
};

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
        double v2 = 0.0, largest_density = equation.rest_density();
        for (const Vec<Dim>& v_i : v) v2 = std::max(v2, v_i.squaredNorm());
        for (const double rho_i : rho) largest_density = std::max(largest_density, rho_i);
        limits.acoustic =
            courant * support / (equation.speed_of_sound(largest_density) + std::sqrt(v2));
    }
};

/// Δt ≤ C h²/ν, ν the kinematic viscosity. C = 0.04 is less than two thirds of the exact limit 2/(ν λ)
/// of BrookshawViscosity on hexagonal and close packed lattices.
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
        double a2 = 0.0;
        for (const Vec<Dim>& a_i : a) a2 = std::max(a2, a_i.squaredNorm());
        limits.force = fraction * std::sqrt(support / std::sqrt(a2));
    }
};

}  // namespace plumbline
