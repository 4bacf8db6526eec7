#include "reports/neighbours_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace reports {

namespace {
using namespace benchmarks;
using Cases = NeighbourCases;

/// A map of who is the fastest: the cells of one winner are a series, those without one another.
struct Cell {
    double x, y;
    Standing standing;
};
void add_cells(const std::vector<Cell>& cells, Chart& chart) {
    constexpr const char* nobody = "cannot be told";
    std::set<std::string> winners;
    const auto winner = [](const Cell& cell) {
        return cell.standing.best.size() == 1 ? cell.standing.best.front()->name
                                              : std::string(nobody);
    };
    for (const Cell& cell : cells) winners.insert(winner(cell));
    for (const std::string& name : winners) {
        Chart::Series series{.name = name, .x = {}, .y = {}, .joined = false};
        const auto& all = contestant_names();
        const auto style = std::ranges::find(all, name) - all.begin();
        series.style = static_cast<int>(style);
        for (const Cell& cell : cells) {
            if (winner(cell) != name) continue;
            series.x.push_back(cell.x);
            series.y.push_back(cell.y);
            const Standing& s = cell.standing;
            series.labels.push_back(s.best.size() > 1 ? fmt::format("{} alike", s.best.size())
                                    : s.next          ? fmt::format("{:.2g}x", s.margin.value)
                                                      : "alone");
        }
        chart.series.push_back(std::move(series));
    }
}

std::string wins_in_words(const std::vector<Cell>& cells) {
    std::vector<Standing> standings;
    for (const Cell& cell : cells) standings.push_back(cell.standing);
    return reports::wins_in_words(standings);
}
}  // namespace

Chart contrast_map(const Cases& cases) {
    std::vector<Cell> cells;
    for (const CaseResult& c : cases) {
        const Standing standing = standing_of(c);
        if (!standing.best.empty())
            cells.push_back({*c.contrast, static_cast<double>(c.count), standing});
    }
    const char* radius =
        cases.front().own_radii ? "a radius of each point's own" : "one radius for all";
    Chart chart{
        .finding = fmt::format("Over the density contrast, {}: {}", radius, wins_in_words(cells)),
        .x = {"highest over lowest number density", "1", true},
        .y = {"points", "1", true},
        .series = {},
        .caption = fmt::format("The fastest to build and query, and by what factor the next one "
                               "takes longer. {}",
                               how_measured(largest(cases))),
        .alt = "",
        .command = ""};
    add_cells(cells, chart);
    return chart;
}

Chart moved_map(const Cases& cases) {
    std::vector<Cell> cells;
    for (const CaseResult& c : cases)
        for (const double queries : {0.01, 0.1, 1.0, 10.0, 100.0}) {
            const Standing standing =
                standing_of(c, [queries](const Runs& runs) { return runs.step(queries); });
            if (!standing.best.empty()) cells.push_back({queries, 100.0 * c.moved, standing});
        }
    const CaseResult& c = cases.front();
    Chart chart{.finding = fmt::format("Moving points: {}", wins_in_words(cells)),
                .x = {"queries of all points per update", "1", true},
                .y = {"points moved per update", "%", true},
                .series = {},
                .caption = fmt::format("{} points. The fastest to update and query, and by what "
                                       "factor the next one takes longer; a "
                                       "search without an update of its own is built anew. {}",
                                       c.count, how_measured(c)),
                .alt = "",
                .command = ""};
    add_cells(cells, chart);
    return chart;
}

}  // namespace reports
