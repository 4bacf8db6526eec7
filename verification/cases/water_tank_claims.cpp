#include "verification/cases/dam_break_impact.h"
#include "verification/framework/registry.h"

namespace water_tank_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// What walls and weight gave to the water of a breaking dam, less what it has, of its momentum, over all that walls gave.
double error_of_momentum(bool without_first_wall) {
    WaterTank tank = lobovsky_tank(8);
    tank.tank.x() = 0.8;
    Vec<2> given = Vec<2>::Zero(), held = Vec<2>::Zero(), before = Vec<2>::Zero();
    double all = 0.0, time = 0.0, size_before = 0.0;
    simulate(tank, 0.25, [&](const WaterTankState& s) {
        Vec<2> force = Vec<2>::Zero();
        held.setZero();
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (s.wall[i] == 0) {
                held += s.m[i] * s.v[i], force += s.m[i] * s.gravity;
            } else if (!without_first_wall || s.x[i].x() > 0.0) {
                force -= s.force[i];
            }
        }
        const double dt = s.time - time, size = force.norm();
        given += 0.5 * dt * (before + force), all += 0.5 * dt * (size_before + size);
        before = force, size_before = size, time = s.time;
    });
    return (given - held).norm() / all;
}

/// max |p − ρ g (H − z)| / (ρ g H) of the four sensors, in a tank that is full to the end, at rest.
double error_of_sensors(bool without_weight) {
    WaterTank tank = lobovsky_tank(10);
    tank.tank.x() = tank.water.x();
    const std::array heights{3e-3, 15e-3, 30e-3, 80e-3};
    std::vector<WallSensor> places;
    for (const double z : heights) places.emplace_back(tank.tank.x(), z, 4.2e-3);
    WallSensors sensors(tank, places);
    const double unit = tank.rest_density * tank.gravity;
    double worst = 0.0;
    simulate(tank, 0.0, [&](const WaterTankState& s) {
        const Vec<2> none = Vec<2>::Zero();
        const std::vector<double> p =
            sensors.read(without_weight ? WaterTankState{s.time, s.x, s.v, s.m, s.rho, s.p, s.wall,
                                                         s.force, none}
                                        : s);
        for (std::size_t k = 0; k < p.size(); ++k)
            worst = std::max(
                worst, std::abs(p[k] / unit - (tank.water.y() - heights[k])) / tank.water.y());
    });
    return worst;
}

const Register claims_of_water_tank{
    Claim{.id = "water_tank.walls_and_weight_make_the_momentum",
          .source = {Paper::plumbline, "docstring of KeepWallForces"},
          .says =
              "a dam break of 128 particles that meets the end wall: its momentum against the time "
              "integral of the forces of the walls and of its weight, over that of their size; "
              "wrong: the wall behind the water is forgotten",
          .bound = at_most(
              1e-4,
              "Leapfrog adds Δt/2 (a + a′), as the trapezoidal sum does; a pair is computed "
              "twice in single precision, with up to 30 roundings of 6e-8 in each: 1.8e-6 of "
              "it. 128 particles have 50 neighbours; each pair pushes as much as a particle's "
              "share of the walls' force at most, and of 3200 pairs with random signs √3200 count"),
          .measure = [] { return error_of_momentum(false); },
          .sabotaged = [] { return error_of_momentum(true); }},
    Claim{
        .id = "water_tank.sensors_read_the_weight_of_the_water",
        .source = {Paper::plumbline, "docstring of WallSensor"},
        .says = "sensors in the wall of a tank at rest, 10 particles deep: |p − ρ g (H − z)| / (ρ "
                "g H); "
                "wrong: the mean of the pressures around",
        .bound = at_most(1e-3,
                         "density is up to 1/400 above ρ₀, g H/c² at the floor, over a support of "
                         "0.4 H; the mean over the face of what is linear is exact"),
        .measure = [] { return error_of_sensors(false); },
        .sabotaged = [] { return error_of_sensors(true); }}};
}  // namespace
}  // namespace water_tank_claims
