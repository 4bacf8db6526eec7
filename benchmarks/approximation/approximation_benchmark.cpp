// What does one approximated value cost, per method: evaluated anew, or with the shape functions
// computed once? adams2009 Sec. 3.1 expects the latter to be "as efficient as" SPH for every method.

#include "benchmarks/approximation/frontier_methods.h"

#include <benchmark/benchmark.h>

namespace {
using namespace benchmarks;
using verification::Quantity;

constexpr int samples_per_metre = 80;
constexpr std::size_t most_places = 1000;

std::vector<PreparedMethod> methods_on(const Situation<2>& s) {
    std::vector<PreparedMethod> methods = sph_methods(s, Quantity::value);
    for (PreparedMethod& method : mls_methods(s, Quantity::value))
        methods.push_back(std::move(method));
    return methods;
}

template <class Work> void per_place(benchmark::State& state, const Situation<2>& s, Work work) {
    std::vector<double> out(s.places.size());
    for (auto _ : state) {
        work(out);
        benchmark::DoNotOptimize(out.data());
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * s.places.size()));
}

void register_all(const Situation<2>& s) {
    for (const PreparedMethod& method : methods_on(s)) {
        const std::string name =
            method.name + "/h=" + std::to_string(s.support / s.spacing).substr(0, 3);
        benchmark::RegisterBenchmark(
            (name + "/anew").c_str(), [&s, method](benchmark::State& state) {
                per_place(state, s, [&](std::vector<double>& out) { method.evaluate(out); });
            });
        if (!method.precompute) continue;
        benchmark::RegisterBenchmark(
            (name + "/precompute").c_str(), [&s, method](benchmark::State& state) {
                per_place(state, s, [&](std::vector<double>&) { method.precompute(); });
            });
        benchmark::RegisterBenchmark(
            (name + "/apply").c_str(), [&s, method](benchmark::State& state) {
                method.precompute();
                per_place(state, s, [&](std::vector<double>& out) { method.apply(out); });
            });
    }
}
}  // namespace

int main(int argc, char** argv) {
    const Situation<2> near(Quantity::value, "poly6", 2.5, samples_per_metre, most_places);
    const Situation<2> far(Quantity::value, "poly6", 3.5, samples_per_metre, most_places);
    register_all(near);
    register_all(far);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
