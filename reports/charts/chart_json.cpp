#include "reports/charts/chart_json.h"

namespace reports {

namespace {
Json numbers(const std::vector<double>& values) {
    Json all = Json::array();
    for (const double v : values) all.push_back(number(v));
    return all;
}
std::vector<double> values_of(const Json& json) {
    std::vector<double> all;
    for (const Json& v : json) all.push_back(value_of(v));
    return all;
}

Json pairs(const std::vector<Chart::Range>& ranges) {
    Json all = Json::array();
    for (const auto& r : ranges) all.push_back({number(r.low), number(r.high)});
    return all;
}
std::vector<Chart::Range> ranges_of(const Json& json) {
    std::vector<Chart::Range> all;
    for (const Json& r : json) all.push_back({value_of(r[0]), value_of(r[1])});
    return all;
}

Json json_of(const Chart::Axis& axis) {
    return {{"label", axis.label}, {"unit", axis.unit}, {"log", axis.log}, {"names", axis.names}};
}
Chart::Axis axis_from(const Json& json) {
    return {json["label"], json["unit"], json["log"],
            json.value("names", std::vector<std::string>{})};
}

Json json_of(const Chart::Series& s) {
    Json json = {{"name", s.name},
                 {"x", numbers(s.x)},
                 {"y", numbers(s.y)},
                 {"x_range", pairs(s.x_range)},
                 {"y_range", pairs(s.y_range)},
                 {"failures", numbers(s.failures)},
                 {"joined", s.joined},
                 {"labels", s.labels},
                 {"outlines", Json::array()}};
    for (const Chart::Outline& o : s.outlines)
        json["outlines"].push_back({{"x", numbers(o.x)}, {"y", numbers(o.y)}});
    if (s.shaded) json["shaded"] = true;
    if (s.style) json["style"] = *s.style;
    if (!s.markers) json["markers"] = false;
    if (!s.in_key) json["in_key"] = false;
    if (s.open) json["open"] = true;
    return json;
}
Chart::Series series_from(const Json& json) {
    Chart::Series s{.name = json["name"],
                    .x = values_of(json["x"]),
                    .y = values_of(json["y"]),
                    .x_range = ranges_of(json["x_range"]),
                    .y_range = ranges_of(json["y_range"]),
                    .failures = values_of(json["failures"]),
                    .joined = json["joined"],
                    .style = {},
                    .labels = json.value("labels", std::vector<std::string>{}),
                    .outlines = {},
                    .shaded = json.value("shaded", false),
                    .markers = json.value("markers", true),
                    .in_key = json.value("in_key", true),
                    .open = json.value("open", false)};
    for (const Json& o : json.value("outlines", Json::array()))
        s.outlines.push_back({values_of(o["x"]), values_of(o["y"])});
    if (json.contains("style")) s.style = json["style"].get<int>();
    return s;
}
}  // namespace

Json json_of(const Chart& chart, const std::string& name) {
    Json series = Json::array();
    for (const Chart::Series& s : chart.series) series.push_back(json_of(s));
    return {{"name", name},
            {"finding", chart.finding},
            {"x", json_of(chart.x)},
            {"y", json_of(chart.y)},
            {"series", std::move(series)},
            {"slopes", numbers(chart.slopes)},
            {"caption", chart.caption},
            {"alt", chart.alt},
            {"command", chart.command}};
}

Chart chart_from(const Json& json) {
    Chart chart{.finding = json["finding"],
                .x = axis_from(json["x"]),
                .y = axis_from(json["y"]),
                .series = {},
                .slopes = values_of(json["slopes"]),
                .caption = json["caption"],
                .alt = json["alt"],
                .command = json["command"]};
    for (const Json& s : json["series"]) chart.series.push_back(series_from(s));
    return chart;
}

}  // namespace reports
