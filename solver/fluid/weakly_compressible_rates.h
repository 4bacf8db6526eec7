#pragma once

#include "solver/fluid/pair_records.h"
#include "solver/kernels/slope.h"

namespace plumbline {

/// Continuity, DensityDiffusion, PressureForce and ArtificialViscosity of one kernel in one loop, the
/// four sums of a dam break:
///   dρᵢ/dt += Σⱼ mⱼ (vᵢ − vⱼ)·∇ᵢωᵢⱼ + δ h c Σⱼ 2 (ρⱼ − ρᵢ) (−ω′/r) mⱼ/ρⱼ
///   aᵢ     += −Σⱼ mⱼ (pᵢ/ρᵢ² + pⱼ/ρⱼ² + Πᵢⱼ) ∇ᵢωᵢⱼ
/// Each pair is found, used and forgotten: no neighbour is stored, since nothing asks for it a second
/// time. Faster than the four passes, which are its plain form; same results but for rounding, with Real = float
/// that of single precision. Particles that are near in space should be near in memory: see
/// sort_particles.
template <RadialKernel K, class Real = double, class Space = OpenSpace<K::dim>>
struct WeaklyCompressibleRates {
    static constexpr int dim = K::dim;
    using Memory = PairMemory<Real, dim, Space>;
    using Reads = Quantities<Positions<dim>, Velocities<dim>, Masses, Density, Pressure>;
    using Writes = Quantities<Accelerations<dim>, Rate<Density>, Memory>;
    K w;
    double speed_of_sound;  // c [m/s]
    double alpha;           // of ArtificialViscosity
    double delta;           // of DensityDiffusion
    Space space = {};

    void run(double, const Positions<dim>& x, const Velocities<dim>& v, const Masses& m,
             const Density& rho, const Pressure& p, Accelerations<dim>& a, Rate<Density>& rate,
             Memory& memory) const {
        memory.records.pack(x, v, m, rho, p);
        if (!memory.grid) memory.grid.emplace(space);
        memory.grid->build(memory.records.positions(), w.support());
        const Sums sums(*this, memory.records);
        memory.grid->for_each_row([&](Index i, std::span<const Index> row) {
            const auto [force, density] = sums.of(i, row);
            a[i] += force;
            rate[i] += density;
        });
    }

private:
    class Sums {
        using Number = Lanes<Real>;
        using Vector = LaneVector<Real, dim>;

    public:
        Sums(const WeaklyCompressibleRates& rates, const FluidRecords<Real, dim>& records)
            : records_{records}, slope_(rates.w) {
            const double h = 0.5 * rates.w.support(), c = rates.speed_of_sound;
            viscosity_ = 2.0 * rates.alpha * c * h;
            diffusion_ = -2.0 * rates.delta * h * c;
            epsilon_ = 0.01 * h * h;
            if constexpr (Space::is_periodic)
                for (int d = 0; d < dim; ++d) edge_.x[d] = rates.space.edge()[d];
        }

        std::pair<Vec<dim>, double> of(Index particle, std::span<const Index> row) const {
            const auto i = records_.of(particle);
            Vector force = Vector::zero();
            Number density = 0.0;
            for_lanes_of<Real>(
                row, particle, [&](const Index* neighbours) __attribute__((always_inline)) {
                    const auto j = records_.of(neighbours);
                    const Vector x = difference(i.x, j.x), v = i.v - j.v;
                    const Number r2 = dot(x, x), slope = slope_(sqrt(r2));
                    const Vector gradient = slope * x;
                    const Number approach = min(dot(v, x), Number(0.0));
                    const Number Pi =
                        -(viscosity_ * approach) / ((r2 + epsilon_) * (i.rho + j.rho));
                    force -= j.m * (i.P + j.P + Pi) * gradient;
                    density += j.m * dot(v, gradient) + diffusion_ * slope * j.V * (j.rho - i.rho);
                });
            return {sum(force), sum(density)};
        }

    private:
        Vector difference(const Vector& a, const Vector& b) const {
            Vector d = a - b;
            if constexpr (Space::is_periodic)
                for_each_constant<dim>(
                    [&](auto axis) { d.x[axis] = nearest_image(d.x[axis], edge_.x[axis]); });
            return d;
        }

        const FluidRecords<Real, dim>& records_;
        SlopeOverRadius<K> slope_;
        Number viscosity_, diffusion_, epsilon_;
        Vector edge_;
    };
};

}  // namespace plumbline
