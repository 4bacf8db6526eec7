#include "benchmarks/neighbours/comparison.h"

#include "solver/foundation/parallel.h"
#include "solver/neighbours/brute_force.h"
#include "verification/framework/statistics.h"
#include "verification/neighbours/searches.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace benchmarks {

using namespace plumbline;

namespace {
/// Pairs of points that brute force may look at.
constexpr double affordable_pairs = 1e9;

/// Rows of `lists` that are not those of brute force, as pairs, over a sample that is all if affordable.
template <int Dim>
std::size_t wrong_in_sample(const PointCloud<Dim>& cloud, const NeighbourLists& lists,
                            std::size_t rows) {
    Points<Dim> queries;
    NeighbourLists found{{0}, {}};
    for (std::size_t k = 0; k < rows; ++k) {
        const auto i = static_cast<Index>(k * cloud.points.size() / rows);
        queries.push_back(cloud.points[i]);
        found.indices.insert(found.indices.end(), lists.of(i).begin(), lists.of(i).end());
        found.offsets.push_back(found.indices.size());
    }
    BruteForce<Dim> oracle;
    oracle.build(cloud.points, cloud.radius);
    return verification::wrong_pairs(found, oracle.query(queries));
}

/// Throws InvalidInput if the lists, extrapolated from a sample of rows, would not fit into memory next
/// to those of a second search.
template <int Dim> void check_memory(const PointCloud<Dim>& cloud) {
    const std::size_t n = cloud.points.size(), sample = std::min<std::size_t>(n, 100);
    double neighbours = 0.0;
    for (std::size_t s = 0; s < sample; ++s)
        for (const Vec<Dim>& x : cloud.points)
            if (squared_distance(OpenSpace<Dim>{}, cloud.points[s * n / sample], x) <
                cloud.radius * cloud.radius)
                neighbours += 1.0;
    const double lists = neighbours / static_cast<double>(std::max<std::size_t>(1, sample)) *
                         static_cast<double>(n) * sizeof(Index);
    const double memory =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    constexpr double copies = 4.0;  // two searches, each with what it fills its lists from
    if (copies * lists > memory)
        throw InvalidInput(
            fmt::format("comparison: a radius of {:.17g} makes lists of {:.3g} GB, expected at "
                        "most a quarter of the memory, {:.3g} GB",
                        cloud.radius, lists * 1e-9, memory / copies * 1e-9));
}

struct Runs {
    std::vector<double> build, query, total;
};

template <int Dim>
void run_once(Contestant<Dim>& search, const PointCloud<Dim>& cloud, NeighbourLists& lists,
              Runs& runs) {
    runs.build.push_back(seconds_of([&] { search.build(cloud.points, cloud.radius); }));
    runs.query.push_back(seconds_of([&] { search.query(cloud.points, lists); }));
    runs.total.push_back(runs.build.back() + runs.query.back());
}

/// The median of a[k] / b[k], and 1.96 standard errors of it from the median absolute deviation.
Timing median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < a.size(); ++k) ratios.push_back(a[k] / b[k]);
    const Timing ratio = summarise(ratios);
    constexpr double sigma_over_mad = 1.4826, median_over_mean = 1.2533;
    return {ratio.median_s, 1.96 * median_over_mean * sigma_over_mad * ratio.mad_s /
                                std::sqrt(static_cast<double>(ratios.size()))};
}

double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mx = 0, my = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) mx += std::log(x[k]) / n, my += std::log(y[k]) / n;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sxx += std::pow(std::log(x[k]) - mx, 2);
        sxy += (std::log(x[k]) - mx) * (std::log(y[k]) - my);
    }
    return sxy / sxx;
}
}  // namespace

bool CaseResult::all_agree() const { return std::ranges::all_of(searches, &SearchResult::agrees); }

std::optional<std::size_t> CaseResult::fastest() const {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < searches.size(); ++k)
        if (searches[k].agrees() &&
            (!best || searches[k].total.median_s < searches[*best].total.median_s))
            best = k;
    return best;
}

template <int Dim>
CaseResult compare(const PointCloud<Dim>& cloud, const ComparisonOptions& options) {
    if (options.searches.empty() || options.repeats < 1)
        throw InvalidInput("comparison: expected at least one search and one repeat");
    check_radius(OpenSpace<Dim>{}, cloud.radius);
    check_memory(cloud);
    CaseResult result{.cloud = cloud.name,
                      .dim = Dim,
                      .threads = thread_count(),
                      .count = cloud.points.size(),
                      .radius = cloud.radius,
                      .searches = {}};
    std::vector<std::unique_ptr<Contestant<Dim>>> all;
    std::vector<NeighbourLists> lists(options.searches.size());
    NeighbourLists& first = lists.front();
    for (std::size_t k = 0; k < options.searches.size(); ++k) {
        options.progress(
            fmt::format("{} points, {}: agreement", result.count, options.searches[k]));
        all.push_back(make_contestant<Dim>(options.searches[k]));
        SearchResult search{.name = all[k]->name()};
        Runs cold;
        run_once(*all[k], cloud, lists[k], cold);
        search.cold_build_s = cold.build.front();
        search.cold_query_s = cold.query.front();
        search.memory = all[k]->memory();
        if (k == 0) {
            const auto n = static_cast<double>(result.count);
            result.brute_force_rows = static_cast<std::size_t>(
                std::min(n, std::ceil(affordable_pairs / std::max(n, 1.0))));
            search.wrong_pairs = wrong_in_sample(cloud, first, result.brute_force_rows);
            result.mean_neighbours = static_cast<double>(first.indices.size()) / std::max(n, 1.0);
            result.lists_memory =
                first.indices.size() * sizeof(Index) + first.offsets.size() * sizeof(std::size_t);
        } else {
            search.wrong_pairs = verification::wrong_pairs(lists[k], first);
            if (result.searches.front().wrong_pairs > 0)
                search.wrong_pairs = wrong_in_sample(cloud, lists[k], result.brute_force_rows);
        }
        result.searches.push_back(search);
        if (k > 0) lists[k] = {};
    }

    std::vector<Runs> runs(all.size());
    Runs again;  // the first search a second time: what two runs of the same differ by
    for (int round = 0; round < options.repeats; ++round) {
        options.progress(
            fmt::format("{} points: round {} of {}", result.count, round + 1, options.repeats));
        for (std::size_t turn = 0; turn < all.size(); ++turn) {
            const std::size_t k = round % 2 == 0 ? turn : all.size() - 1 - turn;
            if (!result.searches[k].agrees()) continue;
            run_once(*all[k], cloud, first, runs[k]);
            if (k == 0) run_once(*all[k], cloud, first, again);
        }
    }
    if (!again.total.empty()) {
        std::vector<double> differences;
        for (std::size_t k = 0; k < again.total.size(); ++k)
            differences.push_back(std::abs(again.total[k] / runs[0].total[k] - 1.0));
        result.noise = verification::median(differences);
    }
    for (std::size_t k = 0; k < all.size(); ++k)
        if (result.searches[k].agrees()) {
            result.searches[k].build = summarise(runs[k].build);
            result.searches[k].query = summarise(runs[k].query);
            result.searches[k].total = summarise(runs[k].total);
        }
    if (const auto best = result.fastest())
        for (std::size_t k = 0; k < all.size(); ++k)
            if (result.searches[k].agrees() && k != *best) {
                const Timing ratio = median_ratio(runs[k].total, runs[*best].total);
                result.searches[k].over_fastest = ratio.median_s;
                result.searches[k].over_fastest_spread =
                    std::max(ratio.mad_s, result.noise * ratio.median_s);
            }
    return result;
}
template CaseResult compare<2>(const PointCloud<2>&, const ComparisonOptions&);
template CaseResult compare<3>(const PointCloud<3>&, const ComparisonOptions&);

std::vector<Exponents> exponents(const std::vector<CaseResult>& cases) {
    std::vector<Exponents> all;
    if (cases.size() < 2) return all;
    for (const SearchResult& search : cases.front().searches) {
        std::vector<double> n, build, query;
        for (const CaseResult& c : cases)
            for (const SearchResult& s : c.searches)
                if (s.name == search.name && s.agrees()) {
                    n.push_back(static_cast<double>(c.count));
                    build.push_back(s.build.median_s);
                    query.push_back(s.query.median_s);
                }
        if (n.size() >= 2 && n.front() != n.back())
            all.push_back({search.name, slope(n, build), slope(n, query)});
    }
    return all;
}

std::string recommendation(const CaseResult& result) {
    const auto best = result.fastest();
    if (!best) return "no search agrees with brute force";
    const SearchResult& fastest = result.searches[*best];
    const SearchResult *next = nullptr, *slowest = nullptr;
    for (const SearchResult& s : result.searches) {
        if (!s.agrees() || &s == &fastest) continue;
        if (!next || s.over_fastest < next->over_fastest) next = &s;
        if (!slowest || s.over_fastest > slowest->over_fastest) slowest = &s;
    }
    if (!next) return fmt::format("{}, the only one compared", fastest.name);
    if (next->over_fastest - next->over_fastest_spread <= 1.0)
        return fmt::format("{} or {}: cannot tell which is faster (ratio {:.2f} ± {:.2f})",
                           fastest.name, next->name, next->over_fastest, next->over_fastest_spread);
    std::string text = fmt::format("{}, {:.3g} (± {:.2g}) times faster than {}", fastest.name,
                                   next->over_fastest, next->over_fastest_spread, next->name);
    if (slowest != next)
        text += fmt::format(" and {:.3g} (± {:.2g}) times than {}", slowest->over_fastest,
                            slowest->over_fastest_spread, slowest->name);
    return text + fmt::format(" at {:.0f} neighbours", result.mean_neighbours);
}

}  // namespace benchmarks
