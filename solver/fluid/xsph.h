#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

#include <cmath>

namespace plumbline {

/// Σⱼ 2 mⱼ/(ρᵢ + ρⱼ) ωᵢⱼ (vⱼ − vᵢ): from the velocity of each particle towards those around it [m/s].
template <int Dim> struct VelocityTowardsMean : Each<Vec<Dim>> {
    static constexpr std::string_view name = "velocity towards the mean";
};

/// The average of Monaghan 1992: symmetric, so that momentum is conserved, and zero for uniform motion.
/// adams2009 Eq. 53 averages v itself: momentum is conserved with the density of Eq. 5, but uniform
/// motion is not left alone, for Σ V ω ≠ 1: erratum 20. Angular momentum is not conserved.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct AverageVelocities {
    static constexpr int dim = K::dim;
    using Reads =
        Quantities<Positions<dim>, Velocities<dim>, Masses, Density, Neighbourhood<dim, Space>>;
    using Writes = Quantities<VelocityTowardsMean<dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const Neighbourhood<dim, Space>& near,
             VelocityTowardsMean<dim>& towards) const {
        parallel_for(x.size(), [&](std::size_t i) {
            towards[i] = near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                return 2.0 * m[n.j] / (rho[i] + rho[n.j]) * w.value(n.r) * (v[n.j] - v[i]);
            });
        });
    }
};

/// How strong XSPH is: ξ for a step of `reference_step` [s]. A step of another length gets the ξ that
/// makes the smoothing per time the same; without that it would depend on the time step.
struct XsphStrength {
    double xi;              // 0 ≤ ξ ≤ 1
    double reference_step;  // [s]
    double of(double dt) const { return 1.0 - std::pow(1.0 - xi, dt / reference_step); }
};

/// vᵢ += ξ Σⱼ …: the smoothed velocities are stored.                           adams2009 Eq. 53
/// After AverageVelocities. Acts like a kinematic viscosity ξ m₂ / (2 Δt), m₂ = ∫ ω x² dV.
template <int Dim> struct XsphVelocities {
    using Reads = Quantities<VelocityTowardsMean<Dim>>;
    using Writes = Quantities<Velocities<Dim>>;
    XsphStrength strength;

    void run(double dt, const VelocityTowardsMean<Dim>& towards, Velocities<Dim>& v) const {
        const double xi = strength.of(dt);
        for (std::size_t i = 0; i < v.size(); ++i) v[i] += xi * towards[i];
    }
};

/// xᵢ += Δt ξ Σⱼ …: particles move with smoothed velocities, the stored ones stay as they are. This is
/// "original XSPH", of which adams2009 Sec. 6.2 speaks. After AverageVelocities, before the integrator.
template <int Dim> struct XsphMotion {
    using Reads = Quantities<VelocityTowardsMean<Dim>>;
    using Writes = Quantities<Positions<Dim>>;
    double xi;  // 0 ≤ ξ ≤ 1

    void run(double dt, const VelocityTowardsMean<Dim>& towards, Positions<Dim>& x) const {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * xi * towards[i];
    }
};

}  // namespace plumbline
