#pragma once

#include "solver/fluid/artificial_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/tension.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/two_stage.h"

namespace verification {

/// A round drop of radius 1 m that stretches itself, v = 100/s (−x, y); its exact shape is an ellipse.
struct EllipticalDrop {
    double spacing = 0.05;         // [m]
    double support = 3.6;          // in spacings
    double speed_of_sound = 1400;  // [m/s]
    double alpha = 0.0;            // of the artificial viscosity
    double diffusion = 0.1;        // of the density
    double zeta = 1.0;             // how much of a tension is kept
};

struct DropResult {
    double half_axis_x,
        half_axis_y;        // of the ellipse with the same second moments, initially 1 [m]
    double kinetic_energy;  // over that of the start
    plumbline::Advance steps;
};

/// The scene of the drop, without particles.
inline auto empty_scene_of(const EllipticalDrop& c) {
    using namespace plumbline;
    using Search = CellGrid<2>;
    using W = WendlandC2<2>;
    const double h = c.support * c.spacing;
    const W w(h);
    const TaitEquation tait(1000.0, c.speed_of_sound, 7.0);
    return Scene{Given<Positions<2>, Velocities<2>, Masses, Density>{},
                 TwoStage{Evolve<2, Density>{}, FindNeighbours<2, Search>{h}, Continuity<W>{w},
                          DensityDiffusion<W>{w, c.diffusion, c.speed_of_sound}, TaitPressure{tait},
                          ScaleTension{c.zeta}, PressureForce<W>{w},
                          ArtificialViscosity<W>{w, c.alpha, c.speed_of_sound}},
                 AcousticLimit<2>{tait, h}};
}

inline DropResult simulate(const EllipticalDrop& c, double duration) {
    using namespace plumbline;
    auto scene = empty_scene_of(c);
    for (const Vec<2>& x : lattice<2>({Vec<2>::Constant(-1.0), Vec<2>::Constant(1.0)}, c.spacing)) {
        if (x.norm() > 1.0) continue;
        scene.get<Positions<2>>().push_back(x);
        scene.get<Velocities<2>>().push_back(100.0 * Vec<2>(-x[0], x[1]));
    }
    const std::size_t n = scene.get<Positions<2>>().size();
    scene.get<Masses>().assign(n, 1000.0 * c.spacing * c.spacing);
    scene.get<Density>().assign(n, 1000.0);

    const auto second_moments = [&] {
        Vec<2> sum = Vec<2>::Zero();
        for (const Vec<2>& x : scene.get<Positions<2>>()) sum += x.cwiseProduct(x);
        return sum;
    };
    const auto energy = [&] {
        double sum = 0.0;
        for (const Vec<2>& v : scene.get<Velocities<2>>()) sum += v.squaredNorm();
        return sum;
    };
    const Vec<2> moments = second_moments();
    const double energy_at_start = energy();
    DropResult result;
    result.steps = advance_by_limits(scene, duration);
    const Vec<2> axes = second_moments().cwiseQuotient(moments).cwiseSqrt();
    result.half_axis_x = axes[0], result.half_axis_y = axes[1];
    result.kinetic_energy = energy() / energy_at_start;
    return result;
}

}  // namespace verification
