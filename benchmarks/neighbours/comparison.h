#pragma once

#include "benchmarks/framework/timing.h"
#include "benchmarks/neighbours/contestants.h"
#include "benchmarks/neighbours/point_clouds.h"

#include <functional>
#include <optional>

namespace benchmarks {

/// Seconds of each phase in each round, warm: memory is that of the round before. All points are
/// queries. `update` brings the structure to points of which some have moved, `requery` asks it then; an
/// update of a search's own is averaged over some steps.
struct Runs {
    std::vector<double> build, query, update, requery;

    std::size_t rounds() const { return build.size(); }
    /// Of each round, with so many queries of all points per build; a query of 1 % counts 0.01.
    std::vector<double> total(double queries_per_build = 1.0) const;
    std::vector<double> step(double queries_per_update = 1.0) const;
};

/// How one search did on one cloud.
struct SearchResult {
    std::string name;
    std::string form = "sorted lists";  // of its answer
    bool is_full_answer = true;         // all neighbours, in double precision: it may be ranked
    std::string left_out = {};          // why it was not run, if it was not
    std::size_t wrong_pairs = 0;        // if any, nothing was timed: a wrong search has no speed
    Runs runs = {};
    double cold_build_s = 0.0, cold_query_s = 0.0;  // the first: new memory, empty caches
    std::size_t held_bytes = 0;                     // allocated after the build
    std::size_t lists_bytes = 0;                    // of its answer
    /// Beyond the points and lists while it built and queried; empty where it cannot be told.
    std::optional<std::size_t> peak_bytes = {};

    bool agrees() const { return wrong_pairs == 0 && left_out.empty(); }
    Timing build() const { return summarise(runs.build); }
    Timing query() const { return summarise(runs.query); }
    Timing update() const { return summarise(runs.update); }
    Timing total() const { return summarise(runs.total()); }
};

/// What is compared: the points and what is asked of them.
struct Case {
    std::string cloud, order;
    int dim = 0, threads = 0;
    std::size_t count = 0;
    std::optional<double> contrast = {};  // of the cloud, if it has one
    double radius = 0.0, spacings = 0.0;  // the radius also in units of half the usual one
    bool own_radii = false;               // each point asks with a radius of its own
    double moved = 0.0;                   // share of the points that move before an update

    bool operator==(const Case&) const = default;
};

/// All searches on one cloud, in one run.
struct CaseResult : Case {
    double mean_neighbours = 0.0;
    /// The 99th over the 1st percentile of the number of neighbours: how uneven the points are.
    double unevenness = 1.0;
    std::size_t points_bytes = 0, lists_bytes = 0;
    /// How many rows of the first search were compared with brute force; the others were compared
    /// with the first in full.
    std::size_t brute_force_rows = 0;
    /// By how much two successive runs of one and the same search differ, the median over the rounds:
    /// no interval of a ratio is made narrower.
    double noise = 0.0;
    /// Whether the searches are too large to be in memory side by side: then each is made anew for each of
    /// its runs, and run once before it is timed.
    bool one_at_a_time = false;
    std::vector<SearchResult> searches = {};

    /// All that were run.
    bool all_agree() const;
};

struct ComparisonOptions {
    std::vector<std::string> searches = contestant_names();
    /// Rounds go on for `seconds`, but there are at least and at most so many of them.
    int least = 9, most = 49;
    double seconds = 1.0;
    double brute_force_pairs = 1e9;       // that brute force may test
    std::optional<double> spacings = {};  // set: the radius is so many, 2 being the usual one
    int threads = 0;                      // 0: as many as there are
    /// Share of the points that move by at most 0.05 spacings before each update; empty: no update.
    std::optional<double> moved = {};
    bool own_radii = false;  // the radius in proportion to the distance of the 30th neighbour
    std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// Agreement first, then rounds in which every search builds and queries once, forwards in one round
/// and backwards in the next, so that a slow spell of the machine meets all of them.
/// Throws InvalidInput for no search, no point, a radius that is none or makes lists too large for the
/// memory.
template <int Dim> CaseResult compare(PointCloud<Dim> cloud, const ComparisonOptions& options);

}  // namespace benchmarks
