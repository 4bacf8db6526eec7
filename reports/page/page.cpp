#include "reports/page/page.h"

#include "reports/answers.h"
#include "reports/charts/chart_json.h"
#include "reports/files.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"
#include "solver/io/base64.h"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

#include <cmath>

namespace reports {

namespace {
namespace mustache = kainjow::mustache;

mustache::data data_of(const Json& json) {
    if (json.is_object()) {
        mustache::data object{mustache::data::type::object};
        for (const auto& [key, value] : json.items()) object.set(key, data_of(value));
        return object;
    }
    if (json.is_array()) {
        mustache::data list{mustache::data::type::list};
        for (const Json& value : json) list.push_back(data_of(value));
        return list;
    }
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_null()) return false;
    if (json.is_string()) {
        // An empty string would count as something to show.
        return json.get<std::string>().empty() ? mustache::data(false) : json.get<std::string>();
    }
    return short_number(json);
}

std::string rendered(const std::string& text, const Json& view) {
    mustache::mustache page{text};
    if (!page.is_valid()) throw std::logic_error("template of the page: " + page.error_message());
    mustache::data data = data_of(view);
    data.set("chart_figure", mustache::partial([] { return std::string(templates::chart); }));
    return page.render(data);
}

Json table_of(const Chart& chart) {
    const auto with_range = [](const Chart::Axis& axis, double v,
                               const std::vector<Chart::Range>& ranges, std::size_t k) {
        const std::string text = std::isfinite(v) ? text_of(axis, v, 4) : "failed";
        if (ranges.empty() || (ranges[k].low == v && ranges[k].high == v)) return text;
        return fmt::format("{} [{:.4g}, {:.4g}]", text, ranges[k].low, ranges[k].high);
    };
    Json rows = Json::array();
    for (const Chart::Series& s : chart.series) {
        for (std::size_t k = 0; k < s.x.size(); ++k)
            rows.push_back({{"name", s.name},
                            {"x_value", with_range(chart.x, s.x[k], s.x_range, k)},
                            {"y_value", with_range(chart.y, s.y[k], s.y_range, k) +
                                            (s.labels.empty() ? "" : ": " + s.labels[k])}});
        for (const double x : s.failures)
            rows.push_back(
                {{"name", s.name}, {"x_value", text_of(chart.x, x, 4)}, {"y_value", "failed"}});
    }
    return rows;
}

std::string heading(const Chart::Axis& axis) {
    return axis.label + (axis.unit.empty() ? "" : " [" + axis.unit + "]");
}

Json drawn(const Json& json, const std::filesystem::path& directory) {
    const Chart chart = chart_from(json);
    const DrawnChart files = draw(chart, directory, json["name"]);
    return {{"svg", plumbline::encode_base64(read_file(files.svg))},
            {"finding", chart.finding},
            {"caption", chart.caption},
            {"alt", chart.alt},
            {"command", chart.command},
            {"x_heading", heading(chart.x)},
            {"y_heading", heading(chart.y)},
            {"points", table_of(chart)}};
}

/// A file beside the charts, and the same in the page as what a link saves.
Json kept(const Json& file, const std::filesystem::path& directory) {
    const std::string name = file["name"], text = file["text"];
    std::filesystem::create_directories(directory);
    write_file(directory / name, text);
    return {{"name", name}, {"link", "data:text/csv;base64," + plumbline::encode_base64(text)}};
}

/// Adds "drawn" beside every "chart", at any depth, and replaces every "file" by its link.
void draw_charts(Json& view, const std::filesystem::path& directory) {
    if (view.is_object() && view.contains("chart")) view["drawn"] = drawn(view["chart"], directory);
    if (view.is_object() && view.contains("file")) view["file"] = kept(view["file"], directory);
    if (view.is_structured())
        for (auto& [key, value] : view.items())
            if (key != "chart" && key != "drawn" && key != "file") draw_charts(value, directory);
}
}  // namespace

std::string page_of(const Json& report, const std::filesystem::path& charts) {
    Json page = {{"style", templates::style}, {"sections", Json::array()}};
    for (const Section& section : sections()) {
        Json view = section.view(report);
        if (view.is_null()) continue;
        draw_charts(view, charts);
        page["sections"].push_back(
            {{"id", section.id}, {"title", section.title}, {"body", rendered(section.body, view)}});
    }
    page["tiles"] = tiles_of(report);
    page["answers"] = answers_of(report);
    page["version"] = report["provenance"]["version"];
    page["started"] = report["provenance"]["started"];
    page["processor"] = report["provenance"]["processor"];
    page["quick"] = report.value("quick", false);
    return rendered(templates::page, page);
}

}  // namespace reports
