#include "benchmarks/scenes/fluid_tasks.h"

#include "solver/kernels/cubic_spline.h"
#include "solver/kernels/wendland_c4.h"
#include "verification/cases/channel.h"
#include "verification/cases/dam_break.h"
#include "verification/cases/incompressible_tank.h"
#include "verification/cases/taylor_green.h"

namespace benchmarks {

namespace {
using namespace plumbline;
using namespace verification;

constexpr const char *plain = "WCSPH", *delta = "delta-SPH", *shifted = "shifted delta-SPH",
                     *dfsph = "DFSPH", *projected = "shifted projection";

double taylor_green(const FluidCandidate& c) {
    constexpr double duration = 0.5;
    const TaylorGreen flow{.spacing = 1.0 / c.resolution,
                           .shifting = c.method == shifted || c.method == projected ? 20.0 : 0.0,
                           .support = c.support_in_spacings,
                           .speed_of_sound = c.sound,
                           .diffusion = c.method == plain ? 0.0 : 0.1,
                           .courant = c.courant};
    if (c.method == dfsph || c.method == projected)
        return simulate_incompressible(flow, duration).velocity;
    if (c.kernel == "cubic_spline") return simulate<CubicSpline>(flow, duration).velocity;
    if (c.kernel == "wendland_c4") return simulate<WendlandC4>(flow, duration).velocity;
    return simulate<WendlandC2>(flow, duration).velocity;
}

/// c₀ in units of √(g H) = 1 m/s.
double hydrostatic(const FluidCandidate& c) {
    const double spacing = 1.0 / c.resolution;
    if (c.method == dfsph)
        return error_of_column(spacing, c.support_in_spacings, c.courant / 0.4 * 0.2 * spacing);
    const ChannelState end = simulate(Channel{.spacing = spacing,
                                              .support = c.support_in_spacings,
                                              .gravity = {0.0, -1.0},
                                              .viscosity = 0.02,
                                              .slip = true,
                                              .lid = false,
                                              .speed_of_sound = c.sound,
                                              .diffusion = c.method == plain ? 0.0 : 0.1,
                                              .courant = c.courant},
                                      1.0);
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < end.x.size(); ++i) {
        const double y = end.x[i][1];
        if (y < 0.15 || y > 0.85) continue;
        squares += std::pow(end.pressure[i] - (1.0 - y), 2), count += 1.0;
    }
    return std::sqrt(squares / count);
}

/// c₀ in units of √(g H); steps of the same share of h/(c + v), h being the support.
double dam_break(const FluidCandidate& c) {
    if (c.method == dfsph) return error_of_front(c.resolution, c.support_in_spacings, c.courant);
    DamBreak<2> how;
    how.support = c.support_in_spacings;
    how.diffusion = c.method == plain ? 0.0 : 0.1;
    how.courant = 2.0 * c.courant;
    how.sound = c.sound;
    return error_of_front(c.resolution, how);
}
}  // namespace

const std::vector<FluidTask>& all_fluid_tasks() {
    static const std::vector<FluidTask> all{
        {"taylor_green",
         "velocity error",
         "mean ‖v − exact‖ / largest exact speed, Re = 100, t = 0.5",
         "particles per edge of the box",
         {16, 24},
         {16, 24, 32, 48, 64},
         {{plain, "wendland_c2", 0, 3.0, 10.0, 0.4},
          {delta, "wendland_c2", 0, 3.0, 10.0, 0.4},
          {shifted, "wendland_c2", 0, 3.0, 10.0, 0.4},
          {shifted, "wendland_c2", 0, 4.0, 10.0, 0.4},
          {shifted, "wendland_c4", 0, 4.0, 10.0, 0.4},
          {shifted, "cubic_spline", 0, 3.0, 10.0, 0.4},
          {shifted, "wendland_c2", 0, 4.0, 20.0, 0.4},
          {shifted, "wendland_c2", 0, 4.0, 10.0, 0.2},
          {shifted, "wendland_c2", 0, 4.0, 7.0, 0.3},
          {projected, "cubic_spline", 0, 4.0, 0.0, 0.4},
          {projected, "cubic_spline", 0, 3.0, 0.0, 0.4},
          {dfsph, "cubic_spline", 0, 2.6, 0.0, 0.4}},
         taylor_green},
        {"hydrostatic",
         "pressure error",
         "rms of p/(ρ₀ g H) − (1 − y/H) away from floor and surface, t = 1 = √(H/g)",
         "particles per height of the column",
         {10, 20},
         {10, 20, 40, 80},
         {{plain, "wendland_c2", 0, 3.0, 10.0, 0.4},
          {delta, "wendland_c2", 0, 3.0, 10.0, 0.4},
          {delta, "wendland_c2", 0, 2.6, 10.0, 0.4},
          {delta, "wendland_c2", 0, 3.0, 20.0, 0.4},
          {delta, "wendland_c2", 0, 3.0, 10.0, 0.2},
          {dfsph, "cubic_spline", 0, 2.0, 0.0, 0.4},
          {dfsph, "cubic_spline", 0, 2.0, 0.0, 0.2},
          {dfsph, "cubic_spline", 0, 2.6, 0.0, 0.4}},
         hydrostatic},
        {"dam_break",
         "error of the front",
         "rms of Z/Z_D − 1, fronts of Martin and Moyce 1952, n² = 2",
         "particles per base of the water",
         {8, 12},
         {8, 12, 16, 24, 32},
         {{plain, "wendland_c2", 0, 2.6, 20.0, 0.1},
          {delta, "wendland_c2", 0, 2.6, 20.0, 0.1},
          {delta, "wendland_c2", 0, 3.0, 20.0, 0.1},
          {delta, "wendland_c2", 0, 2.6, 10.0, 0.1},
          {delta, "wendland_c2", 0, 2.6, 20.0, 0.2},
          {dfsph, "cubic_spline", 0, 2.0, 0.0, 0.4},
          {dfsph, "cubic_spline", 0, 2.6, 0.0, 0.4},
          {dfsph, "cubic_spline", 0, 2.0, 0.0, 0.2}},
         dam_break}};
    return all;
}

}  // namespace benchmarks
