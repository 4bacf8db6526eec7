#pragma once

#include "benchmarks/framework/timing.h"
#include "benchmarks/neighbours/contestants.h"
#include "benchmarks/neighbours/point_clouds.h"

#include <functional>
#include <optional>

namespace benchmarks {

/// How one search did on one cloud. Times are for all points, each of which is a query; `query`
/// reuses the memory of its lists, as a simulation does, `cold_query_s` was the first of all.
struct SearchResult {
    std::string name;
    std::size_t wrong_pairs = 0;  // if any, nothing was timed: a wrong search has no speed
    Timing build{}, query{}, total{};
    double cold_build_s = 0.0, cold_query_s = 0.0;
    std::size_t memory = 0;  // bytes held between queries, without the lists
    /// total / total of the fastest search: the median over the rounds, each a ratio of two runs next
    /// to each other, and the spread that no closer ratio can be told from.
    double over_fastest = 1.0, over_fastest_spread = 0.0;

    bool agrees() const { return wrong_pairs == 0; }
};

/// All searches on one cloud, in one run.
struct CaseResult {
    std::string cloud;
    int dim = 0, threads = 0;
    std::size_t count = 0;
    double radius = 0.0, mean_neighbours = 0.0;
    std::size_t lists_memory = 0;  // bytes
    /// How many rows of the first search were compared with brute force; the others were compared
    /// with the first in full.
    std::size_t brute_force_rows = 0;
    double noise = 0.0;  // median relative difference of two runs of one and the same search
    std::vector<SearchResult> searches;

    bool all_agree() const;
    /// The index of the fastest search that agrees, none if none does.
    std::optional<std::size_t> fastest() const;
};

struct ComparisonOptions {
    std::vector<std::string> searches = contestant_names();
    int repeats = 9;
    std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// Agreement first, then rounds in which every search builds and queries once, forwards in one round
/// and backwards in the next, so that a slow spell of the machine meets all of them.
template <int Dim>
CaseResult compare(const PointCloud<Dim>& cloud, const ComparisonOptions& options);

/// How the time of one search grows with the number of points, over cases of one cloud: the slope of
/// log t over log n. O(n log n) is about 1.07 from 1e4 to 1e6.
struct Exponents {
    std::string search;
    double build, query;
};
std::vector<Exponents> exponents(const std::vector<CaseResult>& cases);

/// One sentence: the fastest search, by what factor over the next and over the slowest, ± the spread; or that
/// they cannot be told apart.
std::string recommendation(const CaseResult& result);

}  // namespace benchmarks
