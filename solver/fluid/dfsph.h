#pragma once

#include "solver/fluid/pressure_projection.h"

namespace plumbline {

/// p/ρ² as the last step left it, where the next one begins.
struct SolvedPressure : Each<double> {
    static constexpr std::string_view name = "solved pressures";
};
struct SolvedDivergence : Each<double> {
    static constexpr std::string_view name = "solved divergences";
};
struct DensityReport : ProjectionReport {};
struct DivergenceReport : ProjectionReport {};
struct DensityStep : ProjectionStep {};
struct DivergenceStep : ProjectionStep {};

/// Velocities with which no density is above ρ₀ at the end of the step: ρᵢ + Δt dρᵢ/dt ≤ ρ₀, to the
/// tolerance, in the mean, of ρ₀. After forces have changed the velocities, before particles are moved.
/// There is no sound to limit the time step, only that no particle moves by much of a spacing.
/// Gravity compresses n layers of spacing d by g Δt²/(n d) per step, in the mean: with a larger tolerance densities are
/// as good, but pressures are left to chance.
///                                              DFSPH, Bender and Koschier 2015, 2017, Algorithm 3
template <int Dim, class Real = double> struct ConstantDensity {
    using Reads = Quantities<Density, PairGradients<Real, Dim>>;
    using Writes = Quantities<Velocities<Dim>, Pressure, SolvedPressure, DensityStep,
                              ProjectionMemory<Real, Dim>, DensityReport>;
    double rest_density;  // ρ₀ [kg/m^Dim]
    ProjectionLimits limits = {.tolerance = 1e-5};

    void run(double dt, const Density& rho, const PairGradients<Real, Dim>& pairs,
             Velocities<Dim>& v, Pressure& p, SolvedPressure& solved, DensityStep& step,
             ProjectionMemory<Real, Dim>& memory, DensityReport& report) const {
        if (dt == 0.0) return;
        for (double& P : solved) P *= limits.warm_start ? dt : 0.0;
        const auto error_per_time = [&](std::size_t i) { return (rho[i] - rest_density) / dt; };
        project(pairs, limits, dt / rest_density, error_per_time, v, solved, step, memory, report);
        for (std::size_t i = 0; i < p.size(); ++i) {
            solved[i] /= dt;
            p[i] = solved[i] * rho[i] * rho[i];
        }
    }
};

/// Velocities that compress nothing: dρᵢ/dt ≤ 0, to the tolerance, in the mean, of ρ₀/Δt. Without it
/// velocities keep the errors that ConstantDensity corrects in positions. At the start of a step.
/// Particles less dense than `full` of ρ₀ are spray, or a surface, and are left to fall. With pressures that pull it
/// makes a fluid that fills its domain incompressible by itself, if ShiftParticles keeps it even.
///                                              DFSPH, Bender and Koschier 2015, 2017, Algorithm 2
template <int Dim, class Real = double> struct ZeroDivergence {
    using Reads = Quantities<Density, PairGradients<Real, Dim>>;
    using Writes = Quantities<Velocities<Dim>, SolvedDivergence, DivergenceStep,
                              ProjectionMemory<Real, Dim>, DivergenceReport>;
    double rest_density;  // ρ₀ [kg/m^Dim]
    ProjectionLimits limits = {.tolerance = 1e-3};
    double full = 0.75;

    void run(double dt, const Density& rho, const PairGradients<Real, Dim>& pairs,
             Velocities<Dim>& v, SolvedDivergence& solved, DivergenceStep& step,
             ProjectionMemory<Real, Dim>& memory, DivergenceReport& report) const {
        if (dt == 0.0) return;
        if (!limits.warm_start) std::fill(solved.begin(), solved.end(), 0.0);
        const auto none_of_spray = [&](std::size_t i) {
            return rho[i] < full * rest_density ? -HUGE_VAL : 0.0;
        };
        project(pairs, limits, dt / rest_density, none_of_spray, v, solved, step, memory, report);
    }
};

/// p += what ZeroDivergence pushed with in the same step. After ConstantDensity: only both together carry the fluid.
struct AddPressureOfDivergence {
    using Reads = Quantities<Density, SolvedDivergence>;
    using Writes = Quantities<Pressure>;
    void run(double dt, const Density& rho, const SolvedDivergence& solved, Pressure& p) const {
        if (dt == 0.0) return;
        for (std::size_t i = 0; i < p.size(); ++i) p[i] += solved[i] * rho[i] * rho[i] / dt;
    }
};

/// v += Δt a, a = 0: what forces do to velocities, in steps that then correct these.
template <int Dim> struct Kick {
    using Reads = Quantities<>;
    using Writes = Quantities<Velocities<Dim>, Accelerations<Dim>>;
    void run(double dt, Velocities<Dim>& v, Accelerations<Dim>& a) const {
        for (std::size_t i = 0; i < v.size(); ++i) {
            v[i] += dt * a[i];
            a[i].setZero();
        }
    }
};
/// x += Δt v.
template <int Dim> struct Drift {
    using Reads = Quantities<Velocities<Dim>>;
    using Writes = Quantities<Positions<Dim>>;
    void run(double dt, const Velocities<Dim>& v, Positions<Dim>& x) const {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
    }
};

}  // namespace plumbline
