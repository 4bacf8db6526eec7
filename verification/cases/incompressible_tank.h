#pragma once

#include "solver/fluid/dfsph.h"
#include "solver/fluid/ghost_density.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/sph_density.h"
#include "solver/kernels/cubic_spline.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/sort_particles.h"

namespace verification {

/// Water in the corner of an open tank, by DFSPH; up is the last axis. Two layers of ghosts, of the masses of the
/// particles, continue the lattice of the water.
template <int Dim> struct IncompressibleTank {
    plumbline::Vec<Dim> tank, water;  // edges [m]
    double spacing;                   // [m]
    double support = 2.0;             // in spacings
    double courant = 0.4;             // spacings per step of the fastest particle
    plumbline::ProjectionLimits density = {.tolerance = 1e-4};
    plumbline::ProjectionLimits divergence = {.tolerance = 1e-3};
    bool walls = true;
    double gravity = 9.81, rest_density = 1000.0;
};

/// The mass with which a cubic lattice has the density ρ₀, to the last bit or so.
template <class K> double mass_on_lattice(const K& w, double spacing, double rest_density) {
    using plumbline::Vec;
    const double reach = (std::ceil(w.support() / spacing) + 0.5) * spacing;
    const auto around = Vec<K::dim>::Constant(reach);
    double sum = 0.0;
    for (const Vec<K::dim>& x : plumbline::lattice<K::dim>({-around, around}, spacing))
        sum += w.value(x.norm());
    return rest_density / sum;
}

/// With further forces, as viscosity.
template <int Dim, class Real, class... Forces>
auto scene_of(const IncompressibleTank<Dim>& c, Forces... forces) {
    using namespace plumbline;
    using W = CubicSpline<Dim>;
    using Search = CellGrid<Dim>;
    const double d = c.spacing, h = c.support * d;
    const W w(h);
    Scene scene{Given<Positions<Dim>, Velocities<Dim>, Masses>{},
                Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses>{},
                FindNeighbours<Dim, Search>{h},
                FindGhosts<Dim, Search>{h},
                SphDensity<W>{w},
                AddGhostDensity<W>{w},
                CollectGradients<W, Real>{w},
                ZeroDivergence<Dim, Real>{c.rest_density, c.divergence},
                Gravity<Dim>{-c.gravity * Vec<Dim>::Unit(Dim - 1)},
                forces...,
                ForceLimit<Dim>{h},
                Kick<Dim>{},
                ConstantDensity<Dim, Real>{c.rest_density, c.density},
                AddPressureOfDivergence{},
                Drift<Dim>{},
                AdvectiveLimit<Dim>{d, c.courant}};
    auto& x = scene.template get<Positions<Dim>>();
    auto& ghosts = scene.template get<GhostPositions<Dim>>();
    const auto water = lattice<Dim>({Vec<Dim>::Zero(), c.water}, d);
    x.assign(water.begin(), water.end());
    const Vec<Dim> margin = Vec<Dim>::Constant(2.0 * d);
    for (const Vec<Dim>& g : lattice<Dim>({-margin, c.tank + margin}, d)) {
        const bool inside = (g.array() > 0.0).all() && (g.array() < c.tank.array()).all();
        if (c.walls && !inside && g[Dim - 1] < c.tank[Dim - 1]) ghosts.push_back(g);
    }
    const double mass = mass_on_lattice(w, d, c.rest_density);
    scene.template get<Velocities<Dim>>().assign(x.size(), Vec<Dim>::Zero());
    scene.template get<Masses>().assign(x.size(), mass);
    scene.template get<GhostVelocities<Dim>>().assign(ghosts.size(), Vec<Dim>::Zero());
    scene.template get<GhostMasses>().assign(ghosts.size(), mass);
    return scene;
}

/// The root mean square of p/(ρ₀ g H) − (1 − y/H), over what is farther than 3/20 H from floor and surface and a spacing from
/// the sides, of a column 12 spacings wide, 1 m high, with g = 1 m/s² and ν = 0.02 m²/s, after 1 s.
double error_of_column(double spacing, double support, double longest_step);

/// The same norm of Z/Z_D − 1, the fronts of Martin and Moyce 1952 (see dam_break.cpp).
double error_of_front(int particles_per_base, double support, double courant);

}  // namespace verification
