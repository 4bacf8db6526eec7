#include "verification/cases/gresho.h"

#include "solver/fluid/artificial_viscosity.h"
#include "solver/fluid/averaged_pressure_force.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/particle_shifting.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/two_stage.h"
#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

namespace verification {

double velocity_of_gresho(double r) { return std::max(0.0, std::min(5.0 * r, 2.0 - 5.0 * r)); }

double pressure_of_gresho(double r) {
    if (r <= 0.2) return 12.5 * r * r;
    const double s = std::min(r, 0.4);
    return 4.0 + 12.5 * s * s - 20.0 * s + 4.0 * std::log(5.0 * s);
}

double error_of_gresho(const Gresho& c, double duration) {
    using namespace plumbline;
    using Box = PeriodicBox<2>;
    using Search = CellGrid<2, Box>;
    using W = WendlandC2<2>;
    const Box box(Vec<2>::Constant(-0.5), Vec<2>::Constant(0.5));
    const double h = c.support * c.spacing, c0 = c.speed_of_sound;
    const W w(h);
    const TaitEquation tait(1.0, c0, 7.0);
    Scene scene{
        Given<Positions<2>, Velocities<2>, Masses, Density>{}, WrapIntoBox<2>{box},
        TwoStage{Evolve<2, Density>{}, WrapIntoBox<2>{box},
                 FindNeighbours<2, Search>{h, Search(box)}, Continuity<W, Box>{w},
                 DensityDiffusion<W, Box>{w, c.diffusion, c0}, TaitPressure{tait},
                 AveragedPressureForce<W, Box>{w}, ArtificialViscosity<W, Box>{w, c.viscosity, c0}},
        AcousticLimit<2>{tait, h, 0.3}, ShiftParticles<W, Box>{w, c.shifting}};
    auto& x = scene.get<Positions<2>>();
    auto& v = scene.get<Velocities<2>>();
    for (const Vec<2>& at : lattice<2>({box.low(), box.high()}, c.spacing)) {
        const double r = at.norm();
        x.push_back(at);
        v.push_back(velocity_of_gresho(r) / r * Vec<2>(-at[1], at[0]));
        scene.get<Density>().push_back(tait.density(pressure_of_gresho(r)));
        scene.get<Masses>().push_back(scene.get<Density>().back() * c.spacing * c.spacing);
    }
    advance_by_limits(scene, duration);
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double r = x[i].norm();
        sum += std::abs((x[i][0] * v[i][1] - x[i][1] * v[i][0]) / r - velocity_of_gresho(r));
    }
    return sum / static_cast<double>(x.size());
}

}  // namespace verification

namespace gresho_claims {
namespace {
using namespace verification;

/// With `alpha` of artificial viscosity instead of diffusion and shifting.
Gresho viscous(double spacing, double alpha) {
    return {.spacing = spacing, .viscosity = alpha, .diffusion = 0.0, .shifting = 0.0};
}

/// max |printed − ours| of the profiles.
double error_of_profiles(double sign) {
    const Reference table("gresho_vortex");
    double worst = 0.0;
    for (std::size_t k = 0; k < table.rows(); ++k) {
        const double r = table["r"][k];
        worst = std::max({worst, std::abs(velocity_of_gresho(r) - table["v_phi"][k]),
                          std::abs(sign * pressure_of_gresho(r) + 5.0 - table["p"][k])});
    }
    return worst;
}

const Register claims_of_gresho{
    Claim{.id = "gresho.start",
          .source = {Paper::literature, "Gresho and Chan 1990"},
          .says = "velocity and pressure that the vortex starts with, against the table",
          .bound = at_most(5.1e-9, "10 printed digits of numbers up to 5.77"),
          .measure = [] { return error_of_profiles(1.0); },
          .sabotaged = [] { return error_of_profiles(-1.0); }},
    Claim{
        .id = "gresho.lasts",
        .source = {Paper::literature, "Gresho and Chan 1990"},
        .says =
            "mean |v_φ − exact| at t = 3, after more than two turns, with 16² particles; "
            "artificial viscosity with α = 0.1 in place of diffusion and shifting eats the vortex",
        .bound = at_most(0.125,
                         "the target is half of the mean speed, 0.251: half of the vortex is left"),
        .measure = [] { return error_of_gresho({.spacing = 1.0 / 16.0}, 3.0); },
        .sabotaged = [] { return error_of_gresho(viscous(1.0 / 16.0, 0.1), 3.0); }},
    Study{.id = "gresho.error_over_spacing",
          .source = {Paper::literature, "Gresho and Chan 1990"},
          .says = "a vortex of which nothing should be lost; with artificial viscosity for shocks, "
                  "α = 1, nothing is left "
                  "of it",
          .quantity = "mean |v_φ − exact| at t = 1, largest speed 1 [m/s]",
          .spacing = {1.0 / 10, 1.0 / 12, 1.0 / 16, 1.0 / 20, 1.0 / 28, 1.0 / 40, 1.0 / 64},
          .quick_levels = 5,
          .seeds = 1,
          .series = {{"diffusion and shifting",
                      between(0.5, 1.5,
                              "1: next to the kinks of the profile, in a ring as wide as the "
                              "support, smoothing errs "
                              "by the support; all around disordered particles have the velocity "
                              "of a place beside "
                              "theirs, which at worst halves the order (Dehnen and Aly 2012: noise "
                              "limits it)")},
                     {"artificial viscosity",
                      between(0.5, 1.5, "as before, were it not for the viscosity"), false, true}},
          .errors = [](double spacing, std::uint64_t) {
              return std::vector{error_of_gresho({.spacing = spacing}, 1.0),
                                 error_of_gresho(viscous(spacing, 1.0), 1.0)};
          }}};
}  // namespace
}  // namespace gresho_claims
