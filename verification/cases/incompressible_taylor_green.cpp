#include "solver/fluid/dfsph.h"
#include "solver/fluid/particle_shifting.h"
#include "solver/fluid/sph_density.h"
#include "solver/kernels/cubic_spline.h"
#include "solver/scene/one_of.h"
#include "verification/cases/incompressible_tank.h"
#include "verification/cases/taylor_green.h"

namespace verification {

TaylorGreenErrors simulate_incompressible(const TaylorGreen& c, double duration) {
    using namespace plumbline;
    using Box = PeriodicBox<2>;
    using Search = CellGrid<2, Box>;
    using W = CubicSpline<2>;
    const Box box(Vec<2>::Zero(), Vec<2>::Ones());
    const double h = c.support * c.spacing, nu = 1.0 / c.reynolds;
    const W w(h);
    const auto points = lattice<2>({box.low(), box.high()}, c.spacing);
    const double rest_density = 1.0;
    const bool shifted = c.shifting > 0.0;
    using Correction = OneOf<Skip, ConstantDensity<2>>;
    using Shift = OneOf<Skip, ShiftParticles<W, Box>>;
    Scene scene{Given<Positions<2>, Velocities<2>, Masses>{},
                Given<GhostPositions<2>, GhostVelocities<2>, GhostMasses>{},
                WrapIntoBox<2>{box},
                FindNeighbours<2, Search>{h, Search(box)},
                FindGhosts<2, Search>{h, Search(box)},
                SphDensity<W, Box>{w},
                CollectGradients<W, double, Box>{w},
                ZeroDivergence<2>{rest_density, {.tolerance = 1e-3, .pulls = shifted}},
                BrookshawViscosity<W, Box>{w, nu},
                ViscousLimit{nu, h},
                Kick<2>{},
                shifted ? Correction(Skip{}) : Correction(ConstantDensity<2>{rest_density}),
                Drift<2>{},
                AdvectiveLimit<2>{c.spacing, c.courant},
                shifted ? Shift(ShiftParticles<W, Box>{w, c.shifting}) : Shift(Skip{})};
    scene.get<Positions<2>>().assign(points.begin(), points.end());
    for (const Vec<2>& x : points)
        scene.get<Velocities<2>>().push_back(taylor_green_velocity(x, 1.0));
    scene.get<Masses>().assign(points.size(), mass_on_lattice(w, c.spacing, rest_density));
    const Advance steps = advance_by_limits(scene, duration, 0.4 * c.courant * c.spacing);
    TaylorGreenErrors result = errors_of(scene, c, duration);
    result.steps = steps;
    return result;
}

}  // namespace verification
