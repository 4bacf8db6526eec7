#include "reports/neighbours_report.h"

#include <fmt/format.h>

namespace reports {

using benchmarks::CaseResult;
using benchmarks::SearchResult;

namespace {
Json json_of_timing(const benchmarks::Timing& timing) {
    return {{"median_s", number(timing.median_s)}, {"mad_s", number(timing.mad_s)}};
}

double nanoseconds_per_point(double seconds, const CaseResult& c) {
    return 1e9 * seconds / static_cast<double>(std::max<std::size_t>(1, c.count));
}
double million_points_per_second(double seconds, const CaseResult& c) {
    return 1e-6 * static_cast<double>(c.count) / seconds;
}

std::string alt_of(const CaseResult& largest) {
    std::string text;
    for (const SearchResult& s : largest.searches)
        text += s.agrees() ? fmt::format("{} {:.0f} ns per point; ", s.name,
                                         nanoseconds_per_point(s.total.median_s, largest))
                           : fmt::format("{} disagrees; ", s.name);
    return text;
}

std::string caption_of(const CaseResult& largest) {
    return fmt::format(
        "{} points in {}D, up to {} of them, {:.0f} neighbours each; {} thread{}. Lists equal "
        "those of brute "
        "force for {} points and one another for all; runs interleaved, medians, bars: median "
        "absolute deviation; A/A noise {:.1f} %.",
        largest.cloud, largest.dim, largest.count, largest.mean_neighbours, largest.threads,
        largest.threads == 1 ? "" : "s", largest.brute_force_rows, 100.0 * largest.noise);
}

Chart rate_chart(const NeighbourComparison& comparison) {
    const CaseResult& largest = comparison.cases.back();
    Chart chart{.finding = benchmarks::recommendation(largest),
                .x = {"points", "1", true},
                .y = {"built and queried", "million points/s", true},
                .series = {},
                .caption = caption_of(largest),
                .alt = alt_of(largest),
                .command = comparison.command};
    for (std::size_t k = 0; k < largest.searches.size(); ++k) {
        Chart::Series series{.name = largest.searches[k].name, .x = {}, .y = {}};
        for (const CaseResult& c : comparison.cases) {
            const SearchResult& s = c.searches[k];
            if (!s.agrees()) {
                series.failures.push_back(static_cast<double>(c.count));
                continue;
            }
            const double low = s.total.median_s - s.total.mad_s,
                         high = s.total.median_s + s.total.mad_s;
            series.x.push_back(static_cast<double>(c.count));
            series.y.push_back(million_points_per_second(s.total.median_s, c));
            series.y_range.push_back(
                {million_points_per_second(high, c), million_points_per_second(low, c)});
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

Chart phases_chart(const NeighbourComparison& comparison) {
    const CaseResult& c = comparison.cases.back();
    Chart chart{.finding = fmt::format("Build against query at {} points: {}", c.count,
                                       benchmarks::recommendation(c)),
                .x = {"build, per point", "ns", true},
                .y = {"query, per point", "ns", true},
                .series = {},
                .caption = caption_of(c),
                .alt = alt_of(c),
                .command = comparison.command};
    for (const SearchResult& s : c.searches) {
        if (!s.agrees()) continue;
        const auto ns = [&](double seconds) { return nanoseconds_per_point(seconds, c); };
        const auto range = [&](const benchmarks::Timing& t) {
            return Chart::Range{ns(t.median_s - t.mad_s), ns(t.median_s + t.mad_s)};
        };
        chart.series.push_back({.name = s.name,
                                .x = {ns(s.build.median_s)},
                                .y = {ns(s.query.median_s)},
                                .x_range = {range(s.build)},
                                .y_range = {range(s.query)},
                                .joined = false});
    }
    return chart;
}
template <class Results> Json all_of(const Results& results) {
    Json all = Json::array();
    for (const auto& result : results) all.push_back(reports::json_of(result));
    return all;
}
}  // namespace

Json json_of(const SearchResult& s) {
    return {{"search", s.name},
            {"wrong_pairs", s.wrong_pairs},
            {"build", json_of_timing(s.build)},
            {"query", json_of_timing(s.query)},
            {"total", json_of_timing(s.total)},
            {"cold_build_s", number(s.cold_build_s)},
            {"cold_query_s", number(s.cold_query_s)},
            {"memory_bytes", s.memory},
            {"over_fastest", number(s.over_fastest)},
            {"over_fastest_spread", number(s.over_fastest_spread)}};
}

Json json_of(const CaseResult& c) {
    return {{"cloud", c.cloud},
            {"dim", c.dim},
            {"threads", c.threads},
            {"count", c.count},
            {"radius", number(c.radius)},
            {"mean_neighbours", number(c.mean_neighbours)},
            {"lists_bytes", c.lists_memory},
            {"brute_force_rows", c.brute_force_rows},
            {"noise", number(c.noise)},
            {"recommendation", benchmarks::recommendation(c)},
            {"searches", all_of(c.searches)}};
}

Json json_of(const NeighbourComparison& comparison) {
    Json exponents = Json::array();
    for (const auto& e : benchmarks::exponents(comparison.cases))
        exponents.push_back(
            {{"search", e.search}, {"build", number(e.build)}, {"query", number(e.query)}});
    return {{"command", comparison.command},
            {"cases", all_of(comparison.cases)},
            {"exponents", std::move(exponents)}};
}

std::string csv_of(const NeighbourComparison& comparison) {
    std::string text =
        "cloud,dim,threads,points,radius,neighbours,noise,search,wrong_pairs,build_s,build_mad_s,"
        "query_s,query_mad_s,total_s,cold_build_s,cold_query_s,memory_bytes,lists_bytes,"
        "over_fastest,over_fastest_spread\n";
    for (const CaseResult& c : comparison.cases)
        for (const SearchResult& s : c.searches)
            text += fmt::format(
                "{},{},{},{},{:.17g},{:.6g},{:.4g},{},{},{:.6g},{:.3g},{:.6g},{:.3g},{:.6g},"
                "{:.6g},{:.6g},{},{},{:.6g},{:.3g}\n",
                c.cloud, c.dim, c.threads, c.count, c.radius, c.mean_neighbours, c.noise, s.name,
                s.wrong_pairs, s.build.median_s, s.build.mad_s, s.query.median_s, s.query.mad_s,
                s.total.median_s, s.cold_build_s, s.cold_query_s, s.memory, c.lists_memory,
                s.over_fastest, s.over_fastest_spread);
    return text;
}

std::vector<NamedChart> charts_of(const NeighbourComparison& comparison) {
    const CaseResult& c = comparison.cases.back();
    const std::string name = fmt::format("neighbours_{}_{}d", c.cloud, c.dim);
    std::vector<NamedChart> charts;
    if (comparison.cases.size() > 1) charts.push_back({name + "_rate", rate_chart(comparison)});
    charts.push_back({name + "_phases", phases_chart(comparison)});
    return charts;
}

}  // namespace reports
