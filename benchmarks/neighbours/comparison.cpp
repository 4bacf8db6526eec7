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

/// How many steps an update of a search's own is averaged over: it may be dear now and then.
constexpr int steps_per_round = 8;

/// The points after each of the steps: so large a share of them moves, always the same way, by up to 0.05
/// spacings per step along each axis.
template <int Dim>
std::vector<PointCloud<Dim>> moved_clouds(const PointCloud<Dim>& cloud, double share) {
    const double far = 0.05 * cloud.radius / usual_spacings;
    std::vector<PointCloud<Dim>> steps(steps_per_round, cloud);
    Random random(7);
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (!(random.uniform() < share)) continue;
        Vec<Dim> velocity;
        for (int axis = 0; axis < Dim; ++axis) velocity[axis] = random.uniform(-far, far);
        for (std::size_t k = 0; k < steps.size(); ++k)
            steps[k].points[i] += static_cast<double>(k + 1) * velocity;
    }
    return steps;
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
    /// `lists_bytes` is about what the lists of one search take.
    Contest(const PointCloud<Dim>& cloud, const ComparisonOptions& options, double lists_bytes,
            CaseResult& result)
        : cloud_{cloud}, options_{options}, lists_bytes_{lists_bytes}, result_{result} {
        constexpr double usual_bytes = 300.0;  // that a search takes per point, its copies included
        const double all = static_cast<double>(options.searches.size()) *
                           (lists_bytes + usual_bytes * static_cast<double>(cloud.points.size()));
        result_.one_at_a_time = all > 0.5 * memory_bytes();
    }

    void check_agreement() {
        if (options_.moved) moved_ = moved_clouds(cloud_, *options_.moved);
        parallel_for(
            static_cast<std::size_t>(2 * thread_count()), [](std::size_t) {}, 1);
        for (const std::string& name : options_.searches) {
            options_.progress(name);
            auto contestant = make_contestant<Dim>(name);
            if (!cloud_.radii.empty() && !contestant->has_own_radii()) continue;
            result_.searches.push_back({.name = name,
                                        .form = contestant->form(),
                                        .is_full_answer = contestant->is_full_answer(),
                                        .left_out = too_large(name)});
            if (result_.searches.back().left_out.empty())
                first_run(*contestant, result_.searches.back());
            if (result_.one_at_a_time) contestant.reset();
            all_.push_back(std::move(contestant));
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
                    const auto contestant = ready(k);
                    run(*contestant, search.runs);
                    if (!twice || twice == &search) {
                        twice = &search;
                        Runs second;
                        run(*contestant, second);
                        again.push_back(second.total().front());
                    }
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
    /// Why a search cannot be run, if so: by its memory for the first points of a large cloud.
    std::string too_large(const std::string& name) const {
        constexpr std::size_t sample = 100000;
        const std::size_t n = cloud_.points.size();
        if (!result_.one_at_a_time || n <= sample) return {};
        const auto contestant = make_contestant<Dim>(name);
        contestant->take(std::span(cloud_.points).first(sample));
        const std::size_t before = allocated_bytes();
        contestant->build(cloud_.radius);
        const double held =
            static_cast<double>(allocated_bytes() - before) * (static_cast<double>(n) / sample);
        constexpr double copies = 3.0;  // of the lists: its answer, sorted, and the first one's
        const double needed = 1.5 * held + copies * lists_bytes_;
        if (needed < free_memory_bytes()) return {};
        return fmt::format("would need about {:.1f} GB, {:.1f} are free", 1e-9 * needed,
                           1e-9 * free_memory_bytes());
    }

    /// A contestant that has run before.
    std::shared_ptr<Contestant<Dim>> ready(std::size_t k) {
        if (!result_.one_at_a_time) return all_[k];
        std::shared_ptr<Contestant<Dim>> fresh = make_contestant<Dim>(result_.searches[k].name);
        Runs before;
        run(*fresh, before);
        return fresh;
    }

    /// Cold, counted, and compared with brute force or with the search that was.
    void first_run(Contestant<Dim>& contestant, SearchResult& search) {
        NeighbourLists lists;
        contestant.take(cloud_.points);
        empty_caches();
        const PeakMemory peak;
        const std::size_t before = allocated_bytes();
        search.cold_build_s = seconds_of([&] { contestant.build(cloud_.radius); });
        search.held_bytes = allocated_bytes() - before;
        search.cold_query_s = seconds_of([&] { contestant.query(cloud_.radii, lists); });
        search.lists_bytes = contestant.answer_bytes(lists);
        if (const auto most = peak.bytes())
            search.peak_bytes = *most > search.lists_bytes ? *most - search.lists_bytes : 0;
        NeighbourLists answer = contestant.answer(lists);
        search.wrong_pairs = wrong_pairs(contestant, cloud_, answer);
        if (reference_ == Reference::none) {
            reference_ = contestant.is_single_precision() || !search.agrees() ? Reference::unfit
                                                                              : Reference::fit;
            keep(std::move(answer), search);
        }
        if (moved_.empty() || !contestant.has_update()) return;
        for (const PointCloud<Dim>& step : moved_) {
            contestant.take(step.points);
            contestant.update();
            contestant.query(step.radii, lists);
            search.wrong_pairs += wrong_against_brute_force(step, contestant.answer(lists),
                                                            affordable_rows(result_.count, 1e7));
        }
    }

    std::size_t wrong_pairs(const Contestant<Dim>& contestant, const PointCloud<Dim>& cloud,
                            const NeighbourLists& answer) const {
        const std::size_t rows = affordable_rows(result_.count, options_.brute_force_pairs);
        if (contestant.is_single_precision())
            return wrong_against_brute_force<float>(cloud, answer, rows);
        if (reference_ != Reference::fit) return wrong_against_brute_force(cloud, answer, rows);
        return verification::wrong_pairs(answer, lists_);
    }

    /// The lists of the first search are what the others are compared with.
    void keep(NeighbourLists answer, const SearchResult& search) {
        lists_ = std::move(answer);
        const auto pairs = static_cast<double>(lists_.indices.size());
        result_.brute_force_rows = affordable_rows(result_.count, options_.brute_force_pairs);
        result_.lists_bytes = search.lists_bytes;
        result_.mean_neighbours = pairs / static_cast<double>(result_.count);
        result_.unevenness = unevenness_of(lists_);
    }

    void run(Contestant<Dim>& search, Runs& runs) {
        search.take(cloud_.points);
        runs.build.push_back(seconds_of([&] { search.build(cloud_.radius); }));
        runs.query.push_back(seconds_of([&] { search.query(cloud_.radii, lists_); }));
        if (moved_.empty()) return;
        const std::size_t steps = search.has_update() ? moved_.size() : 1;
        double update = 0.0, requery = 0.0;
        for (std::size_t k = 0; k < steps; ++k) {
            search.take(moved_[k].points);
            update += seconds_of([&] { search.update(); });
            requery += seconds_of([&] { search.query(moved_[k].radii, lists_); });
        }
        runs.update.push_back(update / static_cast<double>(steps));
        runs.requery.push_back(requery / static_cast<double>(steps));
    }

    const PointCloud<Dim>& cloud_;
    const ComparisonOptions& options_;
    double lists_bytes_;
    CaseResult& result_;
    std::vector<std::shared_ptr<Contestant<Dim>>> all_;
    enum class Reference { none, unfit, fit } reference_ = Reference::none;
    NeighbourLists lists_;                // of the first search; then what all of them fill
    std::vector<PointCloud<Dim>> moved_;  // after each step; empty if nothing moves
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

bool CaseResult::all_agree() const {
    return std::ranges::all_of(searches, [](const SearchResult& s) { return s.wrong_pairs == 0; });
}

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
    const double lists_bytes = affordable_lists(cloud);
    CaseResult result;
    result.cloud = cloud.name;
    result.order = cloud.order;
    result.dim = Dim;
    result.threads = thread_count();
    result.count = cloud.points.size();
    result.radius = cloud.radius;
    result.spacings = options.spacings.value_or(usual_spacings);
    result.own_radii = !cloud.radii.empty();
    result.moved = options.moved.value_or(0.0);
    result.points_bytes = cloud.points.size() * sizeof(Vec<Dim>);
    Contest<Dim> contest(cloud, options, lists_bytes, result);
    contest.check_agreement();
    contest.time();
    return result;
}
template CaseResult compare<2>(PointCloud<2>, const ComparisonOptions&);
template CaseResult compare<3>(PointCloud<3>, const ComparisonOptions&);

}  // namespace benchmarks
