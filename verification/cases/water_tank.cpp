#include "verification/cases/water_tank.h"

#include "solver/fluid/weakly_compressible_rates.h"
#include "solver/foundation/random.h"
#include "solver/particles/lattice.h"
#include "solver/scene/advance.h"
#include "solver/scene/leapfrog.h"
#include "solver/scene/scene.h"
#include "solver/scene/sort_particles.h"

#include <numbers>

namespace water_tank_scene {
namespace {
using namespace verification;
using namespace plumbline;
using W = WendlandC2<2>;

TaitEquation tait(const WaterTank& c) { return {c.rest_density, c.speed_of_sound(), 7.0}; }

auto empty_scene(const WaterTank& c) {
    const W w = c.kernel();
    return Scene{
        Given<Positions<2>, Velocities<2>, Masses, Density, IsWall>{}, KeepTime{},
        Leapfrog{
            Evolve<2, Density>{},
            SwayingFrame<2>{{0.0, -c.gravity}, {c.sway, 0.0}, 2.0 * std::numbers::pi / c.period},
            TaitPressure{tait(c)}, ExtrapolateToWalls<W>{w, tait(c)},
            WeaklyCompressibleRates<W, float>{w, c.speed_of_sound(), c.alpha, c.diffusion},
            KeepWallForces<2>{}, HoldWalls<2>{c.rest_density}},
        AcousticLimit<2>{tait(c), w.support(), c.courant}, ForceLimit<2>{w.support()}};
}

/// The cells of a box, of nearly the spacing, a whole number of them in each edge.
Vec<2> cell_in(const Vec<2>& edges, double spacing) {
    const Vec<2> along = (edges / spacing).array().round();
    return edges.array() / along.array();
}
Points<2> centres(const Box<2>& box, const Vec<2>& cell) {
    return cell_centres<2>(box, cell, [](const auto&) { return true; });
}

template <class Scene> void fill(Scene& scene, const WaterTank& c) {
    const double layers = std::ceil(c.support);
    const auto add = [&](const Vec<2>& x, const Vec<2>& v, double rho, double area, bool wall) {
        scene.template get<Positions<2>>().push_back(x);
        scene.template get<Velocities<2>>().push_back(v);
        scene.template get<Density>().push_back(rho);
        scene.template get<Masses>().push_back(rho * area);
        scene.template get<IsWall>().push_back(wall ? 1 : 0);
    };
    Random random(c.seed);
    const auto shift = [&] { return random.uniform(-c.jitter, c.jitter) * c.spacing; };
    const Vec<2> cell = cell_in(c.water, c.spacing);
    for (Vec<2> x : centres({Vec<2>::Zero(), c.water}, cell)) {
        for (const int axis : {0, 1}) x[axis] += shift();
        const double p = c.rest_density * c.gravity * (c.water.y() - x.y());
        add(x, c.velocity ? c.velocity(x) : Vec<2>::Zero(), tait(c).density(p), cell.prod(), false);
    }
    const Vec<2> wall = cell_in(c.tank, c.spacing), layer{layers * wall.x(), layers * wall.y()};
    for (const Vec<2>& x : centres({-layer, {c.tank.x() + layer.x(), c.tank.y()}}, wall))
        if (x.x() < 0.0 || x.x() > c.tank.x() || x.y() < 0.0)
            add(x, Vec<2>::Zero(), c.rest_density, wall.prod(), true);
}
}  // namespace
}  // namespace water_tank_scene

namespace verification {

void simulate(const WaterTank& tank, double duration,
              const std::function<void(const WaterTankState&)>& observe) {
    using namespace plumbline;
    auto scene = water_tank_scene::empty_scene(tank);
    water_tank_scene::fill(scene, tank);
    scene.step(0.0);
    const auto show = [&](double time) {
        observe({time, scene.template get<Positions<2>>(), scene.template get<Velocities<2>>(),
                 scene.template get<Masses>(), scene.template get<Density>(),
                 scene.template get<Pressure>(), scene.template get<IsWall>(),
                 scene.template get<WallForces<2>>(),
                 scene.template get<ApparentGravity<2>>().value});
    };
    show(0.0);
    constexpr int steps_between_sorts = 50;
    double time = 0.0;
    for (int n = 0; time < duration; ++n) {
        if (n % steps_between_sorts == 0) sort_particles<2>(scene, tank.kernel().support());
        const double limit = scene.template get<TimeStepLimits>().smallest();
        if (!(limit > 1e-9 * duration))
            throw InvalidInput("water tank: the state has blown up at t = " + std::to_string(time));
        const bool last = time + limit * (1.0 + 1e-9) >= duration;
        scene.step(last ? duration - time : limit);
        time = last ? duration : time + limit;
        show(time);
    }
}

double largest_x(const WaterTankState& state) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i)
        if (state.wall[i] == 0) farthest = std::max(farthest, state.x[i].x());
    return farthest;
}

double height_between(const WaterTankState& state, double rest_density, double left, double right) {
    double area = 0.0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (state.wall[i] != 0) continue;
        const double volume = state.m[i] / rest_density, half = 0.5 * std::sqrt(volume);
        const double x = state.x[i].x();
        area += volume * std::max(0.0, std::min(x + half, right) - std::max(x - half, left)) /
                (2.0 * half);
    }
    return area / (right - left);
}

}  // namespace verification
