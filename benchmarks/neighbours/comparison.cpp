#include "benchmarks/neighbours/comparison.h"

#include "benchmarks/framework/memory.h"
#include "benchmarks/neighbours/agreement.h"
#include "benchmarks/neighbours/local_radii.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/random.h"
#include "verification/framework/statistics.h"
#include "verification/neighbours/searches.h"

#include <fmt/format.h>

#include <cmath>

namespace benchmarks {

using namespace plumbline;

namespace {
/// The number of threads, until the end of the scope.
class Threads {
public:
    explicit Threads(int n) : before_{thread_count()} {
        if (n > 0) set_thread_count(n);
    }
    ~Threads() { set_thread_count(before_); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_;
};

/// The points after a step: so large a share of them moved by up to 0.05 spacings along each axis.
template <int Dim> PointCloud<Dim> moved_cloud(PointCloud<Dim> cloud, double share) {
    const double far = 0.05 * cloud.radius / usual_spacings;
    Random random(7);
    for (Vec<Dim>& x : cloud.points)
        if (random.uniform() < share)
            for (int axis = 0; axis < Dim; ++axis) x[axis] += random.uniform(-far, far);
    return cloud;
}

double unevenness_of(const NeighbourLists& lists) {
    std::vector<std::size_t> lengths;
    for (Index i = 0; i < lists.size(); ++i) lengths.push_back(lists.of(i).size());
    const auto percentile = [&](double share) {
        const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(
                                              share * static_cast<double>(lengths.size() - 1));
        std::ranges::nth_element(lengths, at);
        return static_cast<double>(std::max<std::size_t>(1, *at));
    };
    return percentile(0.99) / percentile(0.01);
}

/// Every search on one cloud: first whether they are right, then how fast they are.
template <int Dim> class Contest {
public:
    Contest(const PointCloud<Dim>& cloud, const ComparisonOptions& options, CaseResult& result)
        : cloud_{cloud}, options_{options}, result_{result} {}

    void check_agreement() {
        if (options_.moved) moved_ = moved_cloud(cloud_, *options_.moved);
        parallel_for(
            static_cast<std::size_t>(2 * thread_count()), [](std::size_t) {}, 1);
        for (const std::string& name : options_.searches) {
            options_.progress(name);
            result_.searches.push_back({.name = name});
            first_run(result_.searches.back());
        }
    }

    void time() {
        std::vector<double> again;  // the first search a second time: an A/A comparison
        const SearchResult* twice = nullptr;
        double spent = 0.0;
        for (int round = 0; round < options_.most; ++round) {
            if (round >= options_.least && spent > options_.seconds) break;
            options_.progress(fmt::format("round {}", round + 1));
            spent += seconds_of([&] {
                for (std::size_t turn = 0; turn < all_.size(); ++turn) {
                    const std::size_t k = round % 2 == 0 ? turn : all_.size() - 1 - turn;
                    SearchResult& search = result_.searches[k];
                    if (!search.agrees()) continue;
                    run(*all_[k], search.runs);
                    if (twice && twice != &search) continue;
                    twice = &search;
                    Runs second;
                    run(*all_[k], second);
                    again.push_back(second.total().front());
                }
            });
        }
        if (!twice) return;
        const std::vector<double> first = twice->runs.total();
        std::vector<double> factors;
        for (std::size_t k = 0; k < again.size(); ++k)
            factors.push_back(std::max(again[k], first[k]) / std::min(again[k], first[k]));
        result_.noise = verification::median(factors) - 1.0;
    }

private:
    /// Cold, counted, and compared with brute force or with the search that was.
    void first_run(SearchResult& search) {
        NeighbourLists lists;
        empty_caches();
        const PeakMemory peak;
        const std::size_t before = allocated_bytes();
        all_.push_back(make_contestant<Dim>(search.name));
        Contestant<Dim>& contestant = *all_.back();
        search.cold_build_s = seconds_of([&] { contestant.build(cloud_.points, cloud_.radius); });
        search.held_bytes = allocated_bytes() - before;
        search.cold_query_s =
            seconds_of([&] { contestant.query(cloud_.points, cloud_.radii, lists); });
        const std::size_t lists_bytes =
            lists.indices.size() * sizeof(Index) + lists.offsets.size() * sizeof(std::size_t);
        if (const auto most = peak.bytes())
            search.peak_bytes = *most > lists_bytes ? *most - lists_bytes : 0;
        if (result_.searches.size() == 1) {
            result_.brute_force_rows = affordable_rows(result_.count, options_.brute_force_pairs);
            result_.lists_bytes = lists_bytes;
            result_.mean_neighbours =
                static_cast<double>(lists.indices.size()) / static_cast<double>(result_.count);
            result_.unevenness = unevenness_of(lists);
            search.wrong_pairs = wrong_against_brute_force(cloud_, lists, result_.brute_force_rows);
            lists_ = lists;
        } else if (result_.searches.front().agrees()) {
            search.wrong_pairs = verification::wrong_pairs(lists, lists_);
        } else {
            search.wrong_pairs = wrong_against_brute_force(cloud_, lists, result_.brute_force_rows);
        }
        if (moved_.points.empty() || !contestant.has_update()) return;
        contestant.update(moved_.points);
        contestant.query(moved_.points, moved_.radii, lists);
        search.wrong_pairs += wrong_against_brute_force(moved_, lists, result_.brute_force_rows);
    }

    void run(Contestant<Dim>& search, Runs& runs) {
        runs.build.push_back(seconds_of([&] { search.build(cloud_.points, cloud_.radius); }));
        runs.query.push_back(
            seconds_of([&] { search.query(cloud_.points, cloud_.radii, lists_); }));
        if (moved_.points.empty()) return;
        runs.update.push_back(seconds_of([&] { search.update(moved_.points); }));
        runs.requery.push_back(
            seconds_of([&] { search.query(moved_.points, moved_.radii, lists_); }));
    }

    const PointCloud<Dim>& cloud_;
    const ComparisonOptions& options_;
    CaseResult& result_;
    std::vector<std::unique_ptr<Contestant<Dim>>> all_;
    NeighbourLists lists_;   // of the first search; then what all of them fill
    PointCloud<Dim> moved_;  // without points if nothing moves
};
}  // namespace

std::vector<double> Runs::total(double queries_per_build) const {
    std::vector<double> all(rounds());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = build[k] + queries_per_build * query[k];
    return all;
}

std::vector<double> Runs::step(double queries_per_update) const {
    std::vector<double> all(update.size());
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k] = update[k] + queries_per_update * requery[k];
    return all;
}

bool CaseResult::all_agree() const { return std::ranges::all_of(searches, &SearchResult::agrees); }

template <int Dim> CaseResult compare(PointCloud<Dim> cloud, const ComparisonOptions& options) {
    if (options.searches.empty() || options.least < 1)
        throw InvalidInput("comparison: expected at least one search and one repeat");
    const Threads threads(options.threads);
    if (options.spacings) cloud.radius *= *options.spacings / usual_spacings;
    if (options.own_radii) {
        cloud.radii = local_radii(cloud.points, usual_neighbours);
        for (double& r : cloud.radii)
            r *= options.spacings.value_or(usual_spacings) / usual_spacings;
        cloud.radius = verification::median(cloud.radii);
    }
    require_affordable(cloud);
    CaseResult result;
    result.cloud = cloud.name;
    result.order = cloud.order;
    result.dim = Dim;
    result.threads = thread_count();
    result.count = cloud.points.size();
    result.radius = cloud.radius;
    result.spacings = options.spacings.value_or(usual_spacings);
    result.own_radii = options.own_radii;
    result.moved = options.moved.value_or(0.0);
    result.points_bytes = cloud.points.size() * sizeof(Vec<Dim>);
    Contest<Dim> contest(cloud, options, result);
    contest.check_agreement();
    contest.time();
    return result;
}
template CaseResult compare<2>(PointCloud<2>, const ComparisonOptions&);
template CaseResult compare<3>(PointCloud<3>, const ComparisonOptions&);

}  // namespace benchmarks
