#include "reports/neighbours_charts.h"

#include "benchmarks/neighbours/verdicts.h"
#include "reports/charts/spread_ellipse.h"
#include "reports/neighbours_maps.h"
#include "reports/neighbours_report.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <cmath>

namespace reports {

namespace {
using namespace benchmarks;
using Cases = NeighbourCases;

std::string alt_of(const Chart& chart) {
    std::string text = chart.y.label + " over " + chart.x.label + ": ";
    for (const Chart::Series& s : chart.series)
        if (!s.x.empty())
            text += fmt::format("{} {} at {}; ", s.name, text_of(chart.y, s.y.back(), 3),
                                text_of(chart.x, s.x.back(), 3));
    return text;
}

Chart rate_chart(const Cases& cases) {
    const CaseResult& most = largest(cases);
    Chart chart{.finding = fmt::format("{} points: {}", most.count, recommendation(most)),
                .x = {"points", "1", true},
                .y = {"built and queried", "million points/s", true},
                .series = {},
                .caption = fmt::format("{}. {}", in_words(most), how_measured(most)),
                .alt = "",
                .command = ""};
    add_searches(cases, chart, [](const CaseResult& c, const SearchResult& s) {
        const Estimate ns = estimate(nanoseconds_per_point(s.runs.total(), c));
        const Estimate rate{1e3 / ns.value, {1e3 / ns.range.high, 1e3 / ns.range.low}};
        return std::optional<Place>({exactly(static_cast<double>(c.count)), rate});
    });
    return chart;
}

Chart memory_chart(const Cases& cases) {
    constexpr std::size_t least_for_peak = 90000;  // pages are too coarse for fewer points
    const CaseResult& c = largest(cases);
    const auto per_point = [](std::size_t bytes, const CaseResult& of) {
        return static_cast<double>(bytes) / static_cast<double>(of.count);
    };
    const SearchResult *least = nullptr, *most = nullptr;
    for (const SearchResult& s : c.searches) {
        if (!s.agrees()) continue;
        if (!least || s.held_bytes < least->held_bytes) least = &s;
        if (!most || s.held_bytes > most->held_bytes) most = &s;
    }
    Chart chart{
        .finding = "no search agrees with brute force",
        .x = {"points", "1", true},
        .y = {"beside points and lists", "bytes per point", false},
        .series = {},
        .caption = fmt::format(
            "Held between queries, as the allocator counts; bars reach up to the peak while "
            "building and querying, from {} points on. The points themselves are {:.0f} B "
            "each, the lists {:.0f} B.",
            least_for_peak, per_point(c.points_bytes, c), per_point(c.lists_bytes, c)),
        .alt = "",
        .command = ""};
    if (least)
        chart.finding = fmt::format(
            "{} holds the least, {:.0f} bytes per point, {} the most, {:.0f}, beside {:.0f} of "
            "points "
            "and lists",
            least->name, per_point(least->held_bytes, c), most->name,
            per_point(most->held_bytes, c), per_point(c.points_bytes + c.lists_bytes, c));
    add_searches(cases, chart, [&](const CaseResult& of, const SearchResult& s) {
        const double held = per_point(s.held_bytes, of);
        const bool has_peak = s.peak_bytes && of.count >= least_for_peak;
        const double peak = has_peak ? std::max(held, per_point(*s.peak_bytes, of)) : held;
        return std::optional<Place>({exactly(static_cast<double>(of.count)), {held, {held, peak}}});
    });
    return chart;
}

Chart phases_chart(const CaseResult& c) {
    Chart chart{
        .finding = fmt::format("Build against query at {} points: {}", c.count, recommendation(c)),
        .x = {"build, per point", "ns", true},
        .y = {"query, per point", "ns", true},
        .series = {},
        .caption = fmt::format("{}. Ellipses: 95 % of the spread of the rounds. {}", in_words(c),
                               how_measured(c)),
        .alt = "",
        .command = ""};
    for (const SearchResult& s : c.searches) {
        if (!s.agrees() || s.runs.rounds() == 0) continue;
        const auto build = nanoseconds_per_point(s.runs.build, c),
                   query = nanoseconds_per_point(s.runs.query, c);
        Chart::Series series{.name = s.name,
                             .x = {estimate(build).value},
                             .y = {estimate(query).value},
                             .joined = false};
        if (s.runs.rounds() > 2) series.outlines.push_back(spread_ellipse(build, query));
        chart.series.push_back(std::move(series));
    }
    return chart;
}

Chart contrast_chart(const Cases& cases) {
    Cases of_largest;
    for (const CaseResult& c : cases)
        if (c.count == largest(cases).count) of_largest.push_back(c);
    std::ranges::sort(of_largest, {}, [](const CaseResult& c) { return *c.contrast; });
    Chart chart{.finding = crossover_in_words(cases),
                .x = {"highest over lowest number density", "1", true},
                .y = {"time over that of kd_tree", "1", true},
                .series = {},
                .caption = fmt::format(
                    "{} points, build and query. Above 1 the kd-tree is faster (adams2009 "
                    "Sec. 5.3). {}",
                    largest(cases).count, how_measured(largest(cases))),
                .alt = "",
                .command = ""};
    add_searches(
        of_largest, chart, [](const CaseResult& c, const SearchResult& s) -> std::optional<Place> {
            const SearchResult* tree = find_search(c, "kd_tree");
            if (!tree) return {};
            const Ratio r = &s == tree ? Ratio{1, 1, 1} : ratio_of(s, *tree, total_cost, c.noise);
            if (!std::isfinite(r.high)) return Place{exactly(*c.contrast), exactly(r.value)};
            return Place{exactly(*c.contrast), {r.value, {r.low, r.high}}};
        });
    return chart;
}

/// Time per point over something with names, one row each.
Chart rows_chart(const Cases& cases, const std::string& what,
                 const std::function<std::string(const CaseResult&)>& name_of) {
    Chart chart{.finding = wins_in_words(cases),
                .x = {"build and query, per point", "ns", true},
                .y = {what, "", false},
                .series = {},
                .caption = fmt::format("{} points in {}D. {}", cases.front().count,
                                       cases.front().dim, how_measured(cases.front())),
                .alt = "",
                .command = ""};
    for (auto c = cases.rbegin(); c != cases.rend(); ++c) chart.y.names.push_back(name_of(*c));
    add_searches(cases, chart, [&](const CaseResult& c, const SearchResult& s) {
        const auto row = static_cast<double>(cases.data() + cases.size() - &c);
        const auto rank = static_cast<double>(&s - c.searches.data());
        const auto searches = static_cast<double>(c.searches.size());
        const double beside = 0.6 * (0.5 - (rank + 0.5) / searches);  // bars must not overlap
        return std::optional<Place>(
            {estimate(nanoseconds_per_point(s.runs.total(), c)), exactly(row + beside)});
    });
    for (Chart::Series& s : chart.series) s.joined = false;
    return chart;
}

/// Cost over that of the fastest against the number of queries per build.
Chart queries_chart(const CaseResult& c) {
    Chart chart{.finding = "",
                .x = {"queries of all points per build", "1", true},
                .y = {"time over that of the fastest", "1", true},
                .series = {},
                .caption = fmt::format("{}. {}", in_words(c), how_measured(c)),
                .alt = "",
                .command = ""};
    std::string before;
    for (const SearchResult& search : c.searches)
        if (search.agrees() && search.runs.rounds() > 0)
            chart.series.push_back({.name = search.name, .x = {}, .y = {}});
    for (const double queries : {0.001, 0.01, 0.1, 1.0, 10.0, 100.0}) {
        const Cost cost = [queries](const Runs& runs) { return runs.total(queries); };
        const Standing standing = standing_of(c, cost);
        if (standing.best.empty()) continue;
        std::string now;
        for (const SearchResult* s : standing.best) now += (now.empty() ? "" : " or ") + s->name;
        if (now != before)
            chart.finding += fmt::format("{}{} from {:g} queries per build on",
                                         chart.finding.empty() ? "" : ", ", now, queries);
        before = now;
        for (Chart::Series& series : chart.series) {
            const SearchResult *s = find_search(c, series.name), *best = standing.best.front();
            const Ratio r = s == best ? Ratio{1, 1, 1} : ratio_of(*s, *best, cost, c.noise);
            series.x.push_back(queries);
            series.y.push_back(r.value);
            if (std::isfinite(r.high)) series.y_range.push_back({r.low, r.high});
        }
    }
    for (Chart::Series& s : chart.series)
        if (s.y_range.size() < s.y.size()) s.y_range.clear();
    if (!chart.finding.empty()) chart.finding = "The fastest: " + chart.finding;
    return chart;
}

Chart radius_chart(const Cases& cases) {
    const CaseResult& widest = *std::ranges::max_element(cases, {}, &CaseResult::spacings);
    Chart chart{.finding = fmt::format("Over the radius, up to {:g} spacings: {}", widest.spacings,
                                       wins_in_words(cases)),
                .x = {"radius", "spacings", false},
                .y = {"build and query, per point", "ns", true},
                .series = {},
                .caption = fmt::format("{} points. {}", widest.count, how_measured(widest)),
                .alt = "",
                .command = ""};
    add_searches(cases, chart, [](const CaseResult& c, const SearchResult& s) {
        return std::optional<Place>(
            {exactly(c.spacings), estimate(nanoseconds_per_point(s.runs.total(), c))});
    });
    return chart;
}
}  // namespace

std::vector<NamedChart> charts_of(const SearchStudyResult& study, const std::string& command) {
    std::vector<NamedChart> charts;
    const Cases& cases = study.cases;
    if (cases.empty()) return charts;
    const auto add = [&](const std::string& name, Chart chart) {
        if (std::ranges::all_of(chart.series, [](const auto& s) { return s.x.empty(); })) return;
        chart.alt = alt_of(chart);
        chart.command = command;
        charts.push_back({"neighbours_" + study.name + name, std::move(chart)});
    };
    if (study.name == "size") {
        add("_rate", rate_chart(cases));
        add("_phases", phases_chart(largest(cases)));
        add("_queries", queries_chart(largest(cases)));
        add("_memory", memory_chart(cases));
    } else if (study.name == "contrast" || study.name == "own_radii") {
        add("_map", contrast_map(cases));
        add("_over_kd_tree", contrast_chart(cases));
    } else if (study.name == "moved") {
        add("_map", moved_map(cases));
    } else if (study.name == "cloud") {
        add("", rows_chart(cases, "cloud", [](const auto& c) { return c.cloud; }));
    } else if (study.name == "order") {
        add("", rows_chart(cases, "order of the points", [](const auto& c) { return c.order; }));
    } else if (study.name == "threads") {
        add("", rows_chart(cases, "threads",
                           [](const auto& c) { return counted(c.threads, "thread"); }));
    } else if (study.name == "radius") {
        add("", radius_chart(cases));
    } else {
        add("_phases", phases_chart(cases.front()));
        add("_queries", queries_chart(cases.front()));
    }
    return charts;
}

}  // namespace reports
