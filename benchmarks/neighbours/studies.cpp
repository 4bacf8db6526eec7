#include "benchmarks/neighbours/studies.h"

#include "benchmarks/neighbours/particle_order.h"
#include "solver/foundation/parallel.h"

#include <fmt/format.h>

namespace benchmarks {

namespace {
using plumbline::Index;

template <int Dim> CaseResult measure_in(const SearchSituation& s, const ComparisonOptions& how) {
    PointCloud<Dim> cloud = make_cloud<Dim>(s.cloud);
    if (s.radius) cloud.radius = *s.radius;
    reorder(cloud, s.order);
    CaseResult result = compare(std::move(cloud), how);
    if (has_contrast(s.cloud.name)) result.contrast = s.cloud.contrast;
    return result;
}

/// One situation for each value, set by change(situation, value).
template <class Value, class Change>
std::vector<SearchSituation> varied(const SearchSituation& from, const std::vector<Value>& values,
                                    Change change) {
    std::vector<SearchSituation> all;
    for (const Value& value : values) {
        SearchSituation s = from;
        change(s, value);
        all.push_back(s);
    }
    return all;
}

/// The graded cloud over density contrast and number of points.
std::vector<SearchSituation> over_contrast(bool quick, bool own_radii) {
    const std::vector<Index> counts =
        quick ? std::vector<Index>{1000, 10000} : std::vector<Index>{1000, 10000, 100000};
    const std::vector<double> contrasts =
        quick ? std::vector<double>{1, 100, 10000} : std::vector<double>{1, 10, 100, 1000, 10000};
    std::vector<SearchSituation> all;
    for (const Index count : counts)
        for (const double contrast : contrasts) {
            SearchSituation s{.cloud = {"graded", count, contrast}};
            s.own_radii = own_radii;
            all.push_back(s);
        }
    return all;
}
}  // namespace

std::string SearchSituation::in_words() const {
    return fmt::format("{} {}D, {} points", cloud.name, dim, cloud.count);
}

CaseResult measure(const SearchSituation& s, ComparisonOptions how) {
    how.spacings = s.spacings;
    how.moved = s.moved;
    how.own_radii = s.own_radii;
    how.threads = s.threads;
    return s.dim == 2 ? measure_in<2>(s, how) : measure_in<3>(s, how);
}

std::vector<SearchStudy> search_studies(Level level) {
    const bool quick = level == Level::quick;
    const SearchSituation usual{.cloud = {.count = quick ? 5000u : 100000u}};
    std::vector<Index> sizes{1000, 3000, 10000, 30000, 100000};
    if (!quick)  // at least three in each cache and beyond, for verdicts on growth
        sizes = {1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000};
    std::vector<double> spacings{1.2, 2.0, 4.0}, moved{0.01, 0.1, 1.0};
    if (!quick) spacings = {1.2, 1.5, 2.0, 3.0, 4.0}, moved = {0.001, 0.01, 0.1, 1.0};
    std::vector<int> threads{1};
    if (plumbline::thread_count() > 1) threads.push_back(plumbline::thread_count());
    return {
        {"size", "How does the time grow with the number of points?",
         varied(usual, sizes, [](SearchSituation& s, Index n) { s.cloud.count = n; })},
        {"cloud", "Which is the fastest on which kind of cloud?",
         varied(usual, cloud_names(),
                [](SearchSituation& s, const std::string& name) { s.cloud.name = name; })},
        {"order", "What does the order of the points in memory change?",
         varied(usual, order_names(),
                [](SearchSituation& s, const std::string& order) { s.order = order; })},
        {"radius", "What does the radius change?",
         varied(usual, spacings, [](SearchSituation& s, double r) { s.spacings = r; })},
        {"contrast", "From which density contrast on is a kd-tree the faster one, at one radius?",
         over_contrast(quick, false)},
        {"own_radii", "And if each point has a radius of its own, with as many neighbours?",
         over_contrast(quick, true)},
        {"moved", "Which is the fastest when points move, and how often is it asked?",
         varied(usual, moved, [](SearchSituation& s, double share) { s.moved = share; })},
        {"threads", "What do more threads give?",
         varied(usual, threads, [](SearchSituation& s, int n) { s.threads = n; })}};
}

ComparisonOptions effort(Level level) {
    ComparisonOptions how;
    if (level == Level::quick) {
        how.least = least_rounds;
        how.most = 25;
        how.seconds = 0.15;
        how.brute_force_pairs = 2e7;
    }
    return how;
}

}  // namespace benchmarks
