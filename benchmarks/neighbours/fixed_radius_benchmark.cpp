// How long do the fixed-radius searches take to build and to query, all points being queries?
// adams2009 Sec. 5.3 expects O(n log n) for a kd-tree to build and O(n) for a hash grid, which is to
// be the faster at a constant radius. Two runs are compared by Google Benchmark's compare.py.

#include "benchmarks/neighbours/comparison.h"
#include "verification/neighbours/searches.h"

#include <benchmark/benchmark.h>

namespace {
using namespace plumbline;
using namespace benchmarks;

constexpr Index sizes[] = {10000, 100000};

/// The cloud and its lists, of one size at a time.
const std::pair<PointCloud<3>, NeighbourLists>& cloud_of(const std::string& name, Index count) {
    static std::string current;
    static std::pair<PointCloud<3>, NeighbourLists> cloud;
    if (current != name + std::to_string(count)) {
        cloud.first = make_cloud<3>({.name = name, .count = count});
        CellGrid<3> search;
        search.build(cloud.first.points, cloud.first.radius);
        cloud.second = search.query(cloud.first.points);
        current = name + std::to_string(count);
    }
    return cloud;
}

void measure(benchmark::State& state, const std::string& search_name, const std::string& cloud_name,
             bool build) {
    const auto& [cloud, expected] = cloud_of(cloud_name, static_cast<Index>(state.range(0)));
    const auto search = make_contestant<3>(search_name);
    NeighbourLists lists;
    search->take(cloud.points);
    search->build(cloud.radius);
    search->query({}, lists);
    if (!search->is_single_precision() && search->answer(lists) != expected) {
        state.SkipWithError("a wrong search has no speed");
        return;
    }
    for (auto _ : state) {
        if (build)
            search->build(cloud.radius);
        else
            search->query({}, lists);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cloud.points.size()));
}

const bool registered = [] {
    for (const std::string cloud : {"jittered", "two_densities"})
        for (const Index size : sizes)
            for (const std::string& search : contestant_names())
                for (const bool build : {true, false}) {
                    const std::string name = cloud + (build ? "/build/" : "/query/") + search;
                    benchmark::RegisterBenchmark(name.c_str(), measure, search, cloud, build)
                        ->Arg(size)
                        ->Unit(benchmark::kMillisecond)
                        ->UseRealTime();
                }
    return true;
}();
}  // namespace
