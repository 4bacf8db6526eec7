#include "reports/stability_report.h"

#include "reports/charts/chart_json.h"
#include "reports/interrupt.h"
#include "reports/measurements.h"

#include <fmt/format.h>

namespace reports {

using namespace verification;

namespace {
Json numbers(const std::vector<double>& values) {
    Json all = Json::array();
    for (const double value : values) all.push_back(number(value));
    return all;
}

Json row_of(const LineResult& line) {
    Json points = Json::array();
    for (const BorderPoint& p : line.points)
        points.push_back({{"x", number(p.x)},
                          {"theory", number(p.theory)},
                          {"measured", number(p.measured)},
                          {"ratio", number(p.ratio())}});
    return {{"name", line.line.name},
            {"tested", !line.points.empty()},
            {"expected", json_of(line.line.ratio)},
            {"verdict", name_of(line.verdict)},
            {"theory", numbers(line.curve)},
            {"points", std::move(points)}};
}

/// The curve, then its points, both in style `index`.
void add_series(Chart& chart, const LineResult& line, const std::vector<double>& at, int index) {
    Chart::Series curve{.name = line.line.name, .x = {}, .y = {}, .style = index, .markers = false};
    for (std::size_t k = 0; k < at.size(); ++k) {
        if (chart.y.log && !(line.curve[k] > 0.0)) continue;
        curve.x.push_back(at[k]);
        curve.y.push_back(line.curve[k]);
    }
    Chart::Series runs{.name = line.line.name + ", runs",
                       .x = {},
                       .y = {},
                       .joined = false,
                       .style = index,
                       .in_key = false};
    for (const BorderPoint& p : line.points) {
        if (std::isnan(p.measured)) {
            runs.failures.push_back(p.x);
        } else {
            runs.x.push_back(p.x);
            runs.y.push_back(p.measured);
        }
    }
    chart.series.push_back(std::move(curve));
    if (!runs.x.empty() || !runs.failures.empty()) chart.series.push_back(std::move(runs));
}

Json piece_of(const Map& map, Effort effort) {
    const MapResult result = run(map, effort, [] { stop_if_interrupted(); });
    Json piece = json_of(result);
    piece["chart"] = json_of(chart_of(result), "stability_" + map.id);
    return piece;
}
}  // namespace

Json json_of(const MapResult& result) {
    Json lines = Json::array();
    for (const LineResult& line : result.lines) lines.push_back(row_of(line));
    return {{"id", result.map.id},
            {"source", json_of(result.map.source)},
            {"says", result.map.says},
            {"what_is_run", result.map.what_is_run},
            {"x", result.map.x.label},
            {"y", result.map.y.label},
            {"finding", result.finding},
            {"verdict", name_of(result.verdict)},
            {"worst", number(result.worst)},
            {"seconds", number(result.seconds)},
            {"theory_at", numbers(result.map.curve_at)},
            {"lines", std::move(lines)}};
}

Chart chart_of(const MapResult& result) {
    const Map& map = result.map;
    Chart chart{
        .finding = result.finding,
        .x = {map.x.label, map.x.unit, map.x.log},
        .y = {map.y.label, map.y.unit, map.y.log},
        .series = {},
        .caption = fmt::format("{}. Curves: theory; points: {}.", map.says, map.what_is_run),
        .alt = fmt::format("{} over {}, {} curves with measured borders. {}.", map.y.label,
                           map.x.label, map.lines.size(), result.finding),
        .command = "plumbline stability " + map.id};
    int index = 0;
    for (const LineResult& line : result.lines) add_series(chart, line, map.curve_at, index++);
    return chart;
}

Json run_maps(const std::vector<Map>& maps, Effort effort, Pieces& pieces) {
    constexpr double seconds_per_map = 3600.0;
    return one_by_one(maps, seconds_per_map, [&](const Map& map) {
        return pieces.get("maps/" + map.id, [&] { return piece_of(map, effort); });
    });
}

}  // namespace reports
