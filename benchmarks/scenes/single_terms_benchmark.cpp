// Does a scene of one term cost more than the loop that one would write by hand for that term?
// The two take turns, on one thread; `ratio` is the median of scene over loop, `low` to `high` its interval of 95 %,
// `noise` the same of the loop over itself. A scene pays nothing if the interval holds 1, or is within the noise of it.

#include "benchmarks/framework/timing.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/sph_density.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/jittered.h"
#include "solver/scene/scene.h"

#include <benchmark/benchmark.h>

namespace {
using namespace plumbline;

using W = WendlandC2<3>;
using Start = Given<Positions<3>, Velocities<3>, Masses, Density, Pressure>;
constexpr double support = 2.6;

/// Neighbours that are known, since it is not the search that is timed.
struct KnownNeighbours {
    using Reads = Quantities<>;
    using Writes = Quantities<Neighbourhood<3>>;
    void run(double, Neighbourhood<3>&) const {}
};

/// A jittered lattice of about 20,000 particles, sorted by cells, whose neighbours are known.
template <class Scene> void fill(Scene& scene) {
    const auto points = jittered<3>({Vec<3>::Zero(), Vec<3>::Constant(27.0)}, 1.0, 0.2, 1);
    CellGrid<3> grid;
    grid.build(points, support);
    auto& x = scene.template get<Positions<3>>();
    for (const Index k : grid.point_order()) x.push_back(points[k]);
    for (const Vec<3>& x_i : x) {
        scene.template get<Velocities<3>>().push_back(Vec<3>(x_i[1], -x_i[0], 1.0));
        scene.template get<Pressure>().push_back(1.0 + 0.01 * x_i[2]);
    }
    scene.template get<Masses>().assign(x.size(), 1.0);
    scene.template get<Density>().assign(x.size(), 1.0);
    grid.build(x, support);
    auto& near = scene.template get<Neighbourhood<3>>();
    grid.query(std::span<const Vec<3>>(x), near.lists);
    near.space.emplace();
}

// The loops: arrays, offsets and the kernel, nothing else.
struct ByHand {
    const Points<3>& x;
    const Points<3>& v;
    const std::vector<double>& m;
    const std::vector<double>& rho;
    const std::vector<double>& p;
    const NeighbourLists& lists;
    W w{support};

    void density(std::vector<double>& out) const {
        for (std::size_t i = 0; i < x.size(); ++i) {
            double total = 0.0;
            for (std::size_t k = lists.offsets[i]; k < lists.offsets[i + 1]; ++k) {
                const Index j = lists.indices[k];
                total += m[j] * w.value((x[i] - x[j]).norm());
            }
            out[i] = total;
        }
    }
    void continuity(std::vector<double>& out) const {
        for (std::size_t i = 0; i < x.size(); ++i) {
            double total = 0.0;
            for (std::size_t k = lists.offsets[i]; k < lists.offsets[i + 1]; ++k) {
                const Index j = lists.indices[k];
                const Vec<3> d = x[i] - x[j];
                const double r = d.norm();
                if (r > 0.0) total += m[j] * w.derivative(r) / r * (v[i] - v[j]).dot(d);
            }
            out[i] += total;
        }
    }
    void pressure(Points<3>& out) const {
        for (std::size_t i = 0; i < x.size(); ++i) {
            Vec<3> total = Vec<3>::Zero();
            const double own = p[i] / (rho[i] * rho[i]);
            for (std::size_t k = lists.offsets[i]; k < lists.offsets[i + 1]; ++k) {
                const Index j = lists.indices[k];
                const Vec<3> d = x[i] - x[j];
                const double r = d.norm();
                if (r > 0.0)
                    total += m[j] * (own + p[j] / (rho[j] * rho[j])) * (w.derivative(r) / r) * d;
            }
            out[i] -= total;
        }
    }
    void gravity(Points<3>& out) const {
        for (Vec<3>& a : out) a += Vec<3>(0.0, 0.0, -9.81);
    }
};

template <class Scene> ByHand by_hand(const Scene& s) {
    return {s.template get<Positions<3>>(), s.template get<Velocities<3>>(),
            s.template get<Masses>(),       s.template get<Density>(),
            s.template get<Pressure>(),     s.template get<Neighbourhood<3>>().lists};
}

template <class Scene, class Loop>
void compare(benchmark::State& state, Scene scene, Loop loop, int repeats) {
    set_thread_count(1);
    fill(scene);
    const auto many = [&](auto once) {
        return benchmarks::seconds_of([&] {
            for (int k = 0; k < repeats; ++k) once();
        });
    };
    const auto step = [&] { scene.step(0.0); };
    const auto hand = [&] { loop(scene); };
    many(step), many(hand);
    std::vector<double> of_scene, of_loop, of_loop_again;
    for (auto _ : state) {
        of_loop.push_back(many(hand));
        of_scene.push_back(many(step));
        of_loop_again.push_back(many(hand));
    }
    const auto ratio = benchmarks::ratio_of(of_scene, of_loop);
    const auto again = benchmarks::ratio_of(of_loop_again, of_loop);
    state.counters["ratio"] = ratio.value;
    state.counters["low"] = ratio.low;
    state.counters["high"] = ratio.high;
    state.counters["noise_low"] = again.low;
    state.counters["noise_high"] = again.high;
}

void density(benchmark::State& state) {
    compare(
        state, Scene{Start{}, KnownNeighbours{}, SphDensity<W>{W(support)}},
        [out = std::vector<double>()](const auto& scene) mutable {
            out.resize(scene.template get<Masses>().size());
            by_hand(scene).density(out);
            benchmark::DoNotOptimize(out.data());
        },
        1);
}
void continuity(benchmark::State& state) {
    compare(
        state, Scene{Start{}, KnownNeighbours{}, Continuity<W>{W(support)}},
        [out = std::vector<double>()](const auto& scene) mutable {
            out.resize(scene.template get<Masses>().size());
            by_hand(scene).continuity(out);
            benchmark::DoNotOptimize(out.data());
        },
        1);
}
void pressure(benchmark::State& state) {
    compare(
        state, Scene{Start{}, KnownNeighbours{}, PressureForce<W>{W(support)}},
        [out = Points<3>()](const auto& scene) mutable {
            out.resize(scene.template get<Masses>().size(), Vec<3>::Zero());
            by_hand(scene).pressure(out);
            benchmark::DoNotOptimize(out.data());
        },
        1);
}
void gravity(benchmark::State& state) {
    compare(
        state, Scene{Start{}, KnownNeighbours{}, Gravity<3>{{0.0, 0.0, -9.81}}},
        [out = Points<3>()](const auto& scene) mutable {
            out.resize(scene.template get<Masses>().size(), Vec<3>::Zero());
            by_hand(scene).gravity(out);
            benchmark::DoNotOptimize(out.data());
        },
        200);
}
BENCHMARK(density)->Iterations(30);
BENCHMARK(continuity)->Iterations(30);
BENCHMARK(pressure)->Iterations(30);
BENCHMARK(gravity)->Iterations(30);
}  // namespace
