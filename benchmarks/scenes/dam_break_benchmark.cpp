// How many particle-steps per second does a dam break take, all included, and in what part of them are
// pairs found? Tank 5.366 x 0.5 x 2 m, open; water 2 x 0.5 x 1 m; spacing 0.02 m: 125,000 particles of water
// and about 67,000 of the walls in one layer, which are counted and computed like the others. Wendland C2, support
// 2.6 spacings, c0 = 20 sqrt(g H), artificial viscosity 0.1, density diffusion 0.1, gamma 7,
// dt = 0.2 min(sqrt(h/a), h/(c + v)), one evaluation of the forces per step (leapfrog).

#include "benchmarks/framework/memory.h"
#include "benchmarks/framework/timing.h"
#include "verification/cases/dam_break.h"
#include "verification/cases/incompressible_tank.h"

#include <benchmark/benchmark.h>

namespace {
using namespace plumbline;
using namespace verification;

constexpr int steps_between_sorts = 20;

template <class Scene> void step(Scene& scene) {
    scene.step(scene.template get<TimeStepLimits>().smallest());
}

template <class Real> void measure(benchmark::State& state) {
    set_thread_count(static_cast<int>(state.range(0)));
    const std::size_t before = benchmarks::allocated_bytes();
    const DamBreak<3> c{.tank = {5.366, 0.5, 2.0}, .water = {2.0, 0.5, 1.0}, .spacing = 0.02};
    auto scene = scene_of<3, Real>(c);
    const double support = c.support * c.spacing;
    scene.step(0.0);
    sort_particles<3>(scene, support);
    step(scene);
    int steps = 0;
    for (auto _ : state) {
        if (steps++ % steps_between_sorts == 0) sort_particles<3>(scene, support);
        step(scene);
    }
    const auto& wall = scene.template get<IsWall>();
    const auto n = static_cast<double>(wall.size());
    const auto walls = static_cast<double>(std::ranges::count(wall, char{1}));
    const auto rate = benchmark::Counter::kIsIterationInvariantRate;
    state.counters["particle_steps/s"] = {n, rate};
    state.counters["of_water/s"] = {n - walls, rate};
    state.counters["particles"] = n;
    state.counters["dt"] = scene.template get<TimeStepLimits>().smallest();
    state.counters["bytes/particle"] =
        static_cast<double>(benchmarks::allocated_bytes() - before) / n;
    // The same pairs once more, and nothing done with them.
    using Rates = WeaklyCompressibleRates<WendlandC2<3>, Real>;
    auto& memory = scene.template get<typename Rates::Memory>();
    std::vector<double> search;
    for (int k = 0; k < 5; ++k)
        search.push_back(benchmarks::seconds_of([&] {
            memory.grid->build(memory.records.positions(), support);
            memory.grid->for_each_row(
                [](Index, std::span<const Index> row) { benchmark::DoNotOptimize(row.data()); });
        }));
    state.counters["search_ns/particle"] = 1e9 * benchmarks::summarise(search).median_s / n;
}

/// The same dam break with a spacing of 0.04 m to t = 0.45 s, incompressible: support 2 spacings, steps of up to
/// 4 ms. The tank is one spacing wider, so that it is whole spacings wide.
void incompressible(benchmark::State& state) {
    set_thread_count(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const IncompressibleTank<3> c{
            .tank = {5.366, 0.52, 2.0}, .water = {2.0, 0.52, 1.0}, .spacing = 0.04};
        auto scene = scene_of<3, float>(c);
        sort_particles<3>(scene, c.support * c.spacing);
        const Advance advance = advance_by_limits(scene, 0.45, 4e-3);
        const auto& report = scene.get<DensityReport>();
        state.counters["steps"] = advance.steps;
        state.counters["iterations/step"] =
            static_cast<double>(report.all_iterations) / report.solves;
        state.counters["not_converged"] = report.failures;
        state.counters["particles"] = static_cast<double>(scene.get<Masses>().size());
    }
}

BENCHMARK(incompressible)
    ->Name("dam_break/incompressible_to_0.45_s")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_TEMPLATE(measure, float)->Name("dam_break/single")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_TEMPLATE(measure, double)->Name("dam_break/double")->Arg(1)->Arg(2)->UseRealTime();
}  // namespace
