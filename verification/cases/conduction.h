#pragma once

#include "solver/fluid/heat_conduction.h"
#include "solver/fluid/sph_density.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/scene/find_neighbours.h"

namespace verification {

/// Points of equal mass at rest in a periodic box, of density about 1 and heat capacity 1.
template <int Dim> struct Solid {
    plumbline::PeriodicBox<Dim> box;
    double spacing;  // [m]
    double support;  // h [m]
    plumbline::Points<Dim> x;
    std::vector<double> temperature, conductivity;
};

/// The temperatures after `duration`, by the midpoint rule. Nothing moves, so neighbours and densities are found
/// once. Steps are at most 0.04 h²/k: their error, of second order in them, is of fourth order in h.
template <int Dim, class Conduction>
plumbline::Temperature conduct(const Solid<Dim>& solid, const Conduction& conduction,
                               double duration) {
    using namespace plumbline;
    using Box = PeriodicBox<Dim>;
    using Search = CellGrid<Dim, Box>;
    const double h = solid.support;
    const auto filled = [&]<class Q>(Q q, const auto& values) {
        q.assign(values.begin(), values.end());
        return q;
    };
    const std::vector<double> ones(solid.x.size(), 1.0);
    const auto x = filled(Positions<Dim>{}, solid.x);
    Masses m;
    m.assign(x.size(), std::pow(solid.spacing, Dim));
    Density rho = filled(Density{}, ones);
    Neighbourhood<Dim, Box> near;
    FindNeighbours<Dim, Search>{h, Search(solid.box)}.run(0.0, x, near);
    SphDensity<WendlandC2<Dim>, Box>{WendlandC2<Dim>(h)}.run(0.0, x, m, near, rho);

    const auto k = filled(Conductivity{}, solid.conductivity);
    const auto c = filled(HeatCapacity{}, ones);
    auto T = filled(Temperature{}, solid.temperature);
    Temperature between = T;
    Rate<Temperature> rate;
    const auto advance_by = [&](double dt, const Temperature& at, Temperature& to) {
        rate.assign(x.size(), 0.0);
        conduction.run(dt, x, m, rho, at, k, c, near, rate);
        for (std::size_t i = 0; i < x.size(); ++i) to[i] = T[i] + dt * rate[i];
    };
    const double steps =
        std::ceil(duration * std::ranges::max(solid.conductivity) / (0.04 * h * h));
    for (double n = 0.0; n < steps; ++n) {
        advance_by(0.5 * duration / steps, T, between);
        advance_by(duration / steps, between, T);
    }
    return T;
}

}  // namespace verification
