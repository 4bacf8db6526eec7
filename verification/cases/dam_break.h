#pragma once

#include "solver/fluid/dynamic_boundary.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/weakly_compressible_rates.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/leapfrog.h"
#include "solver/scene/scene.h"
#include "solver/scene/sort_particles.h"

namespace verification {

/// Water in a corner of an open tank, let go at once. Up is the last axis; the walls are one layer of particles that
/// continue the lattice of the water.
template <int Dim> struct DamBreak {
    plumbline::Vec<Dim> tank, water;  // edges [m]
    double spacing;                   // [m]
    double support = 2.6;             // in spacings
    double alpha = 0.1;               // artificial viscosity
    double diffusion = 0.1;           // of the density
    double courant = 0.2;  // Δt over h/(c₀ + v) and √(h/a), h being half of the support
    double sound = 20.0;   // c₀ over √(g H)
    double gravity = 9.81, rest_density = 1000.0;

    double speed_of_sound() const { return sound * std::sqrt(gravity * water[Dim - 1]); }
    plumbline::TaitEquation equation() const { return {rest_density, speed_of_sound(), 7.0}; }
};

template <int Dim, class Real> auto scene_of(const DamBreak<Dim>& c) {
    using namespace plumbline;
    using W = WendlandC2<Dim>;
    const double h = c.support * c.spacing, courant = 0.5 * c.courant;
    const TaitEquation tait = c.equation();
    Scene scene{
        Given<Positions<Dim>, Velocities<Dim>, Masses, Density, IsWall>{},
        Leapfrog{Evolve<Dim, Density>{}, TaitPressure{tait},
                 WeaklyCompressibleRates<W, Real>{W(h), c.speed_of_sound(), c.alpha, c.diffusion},
                 Gravity<Dim>{-c.gravity * Vec<Dim>::Unit(Dim - 1)},
                 HoldWalls<Dim>{c.rest_density}},
        AcousticLimit<Dim>{tait, h, courant}, ForceLimit<Dim>{h, std::sqrt(0.5) * c.courant}};
    fill(scene, c);
    return scene;
}

/// Water with the density of a column at rest, and walls with that of the water.
template <int Dim, class Scene> void fill(Scene& scene, const DamBreak<Dim>& c) {
    using namespace plumbline;
    constexpr int up = Dim - 1;
    const double d = c.spacing, height = c.water[up];
    const TaitEquation tait = c.equation();
    const auto add = [&](const Vec<Dim>& x, double depth, bool wall) {
        const double p = c.rest_density * c.gravity * std::max(depth, 0.0);
        scene.template get<Positions<Dim>>().push_back(x);
        scene.template get<Density>().push_back(wall ? c.rest_density : tait.density(p));
        scene.template get<Masses>().push_back(scene.template get<Density>().back() *
                                               std::pow(d, Dim));
        scene.template get<IsWall>().push_back(wall ? 1 : 0);
    };
    for (const Vec<Dim>& x : lattice<Dim>({Vec<Dim>::Zero(), c.water}, d))
        add(x, height - x[up], false);
    Vec<Dim> low = Vec<Dim>::Constant(-d), high = c.tank + Vec<Dim>::Constant(d);
    high[up] -= d;  // open
    for (const Vec<Dim>& x : lattice<Dim>({low, high}, d))
        if ((x.array() < 0.0).any() || (x.array() > c.tank.array()).any()) add(x, 0.0, true);
    const std::size_t n = scene.template get<Positions<Dim>>().size();
    scene.template get<Velocities<Dim>>().assign(n, Vec<Dim>::Zero());
}

/// How far the water has come along x [m].
template <int Dim, class Scene> double front(const Scene& scene) {
    const auto& x = scene.template get<plumbline::Positions<Dim>>();
    const auto& wall = scene.template get<plumbline::IsWall>();
    double farthest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (wall[i] == 0) farthest = std::max(farthest, x[i][0]);
    return farthest;
}

/// √ mean (Z/Z_D − 1)² over the fronts of Martin and Moyce 1952, n² = 2, in the plane; the tank, the water and the
/// spacing are set, what else `how` has is taken.
double error_of_front(int particles_per_base, const DamBreak<2>& how);

}  // namespace verification
