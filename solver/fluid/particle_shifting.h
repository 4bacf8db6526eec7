#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

/// How far each particle is moved to where there are fewer of them [m].
template <int Dim> struct Shift : Each<Vec<Dim>> {
    static constexpr std::string_view name = "shift";
};

/// xᵢ += −A h ‖vᵢ‖ Δt ∇Cᵢ,  ∇Cᵢ = Σⱼ mⱼ/ρⱼ ∇ᵢωᵢⱼ                      Lind et al. 2012, Skillen et al. 2013
/// with their smoothing length h, taken as support / 2, and at most h/5 per step: particles that
/// follow streamlines clump, which this undoes. Nothing but positions changes, so momentum stays, angular
/// momentum and energy do not, exactly. For fluids without a free surface, from which it would
/// drive the particles away. Before the integrator.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct ShiftParticles {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Velocities<dim>, Masses, Density, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Positions<dim>, Shift<dim>>;
    K w;
    double strength = 2.0;  // A

    void run(double dt, const Velocities<dim>& v, const Masses& m, const Density& rho,
             const Neighbourhood<dim, Space>& near, Positions<dim>& x, Shift<dim>& shift) const {
        const double h = 0.5 * w.support(), largest = 0.2 * h;
        parallel_for(x.size(), [&](std::size_t i) {
            const Vec<dim> crowding = near.template sum<Vec<dim>>(
                x, Index(i),
                [&](const auto& n) -> Vec<dim> { return m[n.j] / rho[n.j] * gradient(w, n); });
            const Vec<dim> wanted = -strength * h * v[i].norm() * dt * crowding;
            const double length = wanted.norm();
            shift[i] = length > largest ? Vec<dim>(largest / length * wanted) : wanted;
        });
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += shift[i];
    }
};

}  // namespace plumbline
