#include "reports/neighbours_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace reports {

using namespace benchmarks;
using Cases = NeighbourCases;

const CaseResult& largest(const Cases& cases) {
    return *std::ranges::max_element(cases, {}, &CaseResult::count);
}

Estimate estimate(const std::vector<double>& values) {
    const Ratio r = ratio_of(values, std::vector<double>(values.size(), 1.0));
    const auto [low, high] = std::ranges::minmax(values);
    return {r.value, {std::max(r.low, low), std::min(r.high, high)}};
}

Estimate exactly(double value) { return {value, {value, value}}; }

std::vector<double> nanoseconds_per_point(std::vector<double> seconds, const CaseResult& c) {
    for (double& s : seconds) s *= 1e9 / static_cast<double>(c.count);
    return seconds;
}

std::string wins_in_words(const std::vector<Standing>& standings) {
    std::map<std::string, std::vector<double>> margins;  // of each winner
    std::size_t ties = 0;
    for (const Standing& s : standings) {
        if (s.best.size() == 1)
            margins[s.best.front()->name].push_back(s.next ? s.margin.value : 0.0);
        else
            ++ties;
    }
    std::string text;
    for (const auto& [name, all] : margins) {
        const auto [least, most] = std::ranges::minmax(all);
        text += fmt::format("{}{} is the fastest in {} of {}", text.empty() ? "" : ", ", name,
                            all.size(), standings.size());
        if (least > 0.0) text += fmt::format(", by {:.2g}x", least);
        if (least > 0.0 && most > least) text += fmt::format(" to {:.2g}x", most);
    }
    if (ties > 0)
        text += fmt::format("{}in {} of {} the fastest cannot be told", text.empty() ? "" : "; ",
                            ties, standings.size());
    return text;
}

std::string wins_in_words(const Cases& cases) {
    std::vector<Standing> standings;
    for (const CaseResult& c : cases)
        if (Standing s = standing_of(c); !s.best.empty()) standings.push_back(std::move(s));
    return wins_in_words(standings);
}

std::string how_measured(const CaseResult& c) {
    return fmt::format(
        "Lists equal brute force for {} rows and one another for all; rounds interleaved, medians, "
        "bars: 95 % interval of the median (sign test); A/A noise {:.1f} %.",
        c.brute_force_rows, 100.0 * c.noise);
}

void add_searches(const Cases& cases, Chart& chart, const At& at) {
    for (const SearchResult& search : cases.front().searches) {
        Chart::Series series{.name = search.name, .x = {}, .y = {}};
        for (const CaseResult& c : cases) {
            const SearchResult* s = find_search(c, search.name);
            const std::optional<Place> place = s ? at(c, *s) : std::nullopt;
            if (!place) continue;
            series.x.push_back(place->x.value);
            series.y.push_back(place->y.value);
            series.x_range.push_back(place->x.range);
            series.y_range.push_back(place->y.range);
        }
        chart.series.push_back(std::move(series));
    }
    const auto no_bars = [](const std::vector<Chart::Range>& ranges) {
        return std::ranges::all_of(ranges, [](const auto& r) { return r.low == r.high; });
    };
    for (Chart::Series& s : chart.series) {
        if (no_bars(s.x_range)) s.x_range.clear();
        if (no_bars(s.y_range)) s.y_range.clear();
    }
    std::erase_if(chart.series, [](const auto& s) { return s.x.empty(); });
}

}  // namespace reports
