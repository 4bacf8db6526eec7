#include "reports/validation_report.h"

#include "reports/charts/chart_json.h"
#include "reports/measurements.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace reports {

using namespace verification;

namespace {
Json numbers(const std::vector<double>& values) {
    Json all = Json::array();
    for (const double value : values) all.push_back(number(value));
    return all;
}
std::vector<double> values_of(const Json& numbers) {
    std::vector<double> values;
    for (const Json& n : numbers) values.push_back(value_of(n));
    return values;
}

Json piece_of(const Validation& validation, double spacing) {
    const auto start = std::chrono::steady_clock::now();
    const Validation::Observation o = validation.observe(spacing);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    Json curves = Json::array();
    for (const Curve& c : o.curves) curves.push_back({{"x", numbers(c.x)}, {"y", numbers(c.y)}});
    return {{"quantities", numbers(o.quantities)},
            {"curves", std::move(curves)},
            {"seconds", time.count()}};
}
Validation::Observation observation_from(const Json& piece) {
    Validation::Observation o{values_of(piece["quantities"]), {}};
    for (const Json& c : piece["curves"])
        o.curves.push_back({values_of(c["x"]), values_of(c["y"])});
    return o;
}

std::string goal_in_words(const Bound& goal, bool reached) {
    if (goal.why.empty()) return "";
    return fmt::format("{}: {}", bound_in_words(json_of(goal)), reached ? "reached" : "missed");
}

Json json_of(const QuantityResult& r) {
    return {{"name", r.quantity.name},
            {"unit", r.quantity.unit},
            {"simulated", numbers(r.simulated)},
            {"measured", number(r.quantity.measured)},
            {"error", number(r.error)},
            {"u_num", number(r.u_num)},
            {"u_input", number(r.quantity.u_input)},
            {"u_data", number(r.quantity.u_data)},
            {"u_val", number(r.u_val)},
            {"why", r.quantity.why},
            {"verdict", name_of(r.agreement)},
            {"goal", goal_in_words(r.quantity.goal, r.reaches_goal)},
            {"goal_why", r.quantity.goal.why}};
}

Json json_of(const PanelResult& r) {
    return {{"name", r.panel.name},
            {"deviation", number(r.deviation)},
            {"inside_band", r.inside_band ? number(*r.inside_band) : Json()},
            {"goal", goal_in_words(r.panel.goal, r.reaches_goal)},
            {"goal_why", r.panel.goal.why}};
}

/// One sentence: the quantities, or the signals if there are none.
std::string finding_of(const ValidationResult& result) {
    std::string text;
    for (const QuantityResult& q : result.quantities)
        text += fmt::format("{}{} {:+.2g} % ({})", text.empty() ? "" : ", ", q.quantity.name,
                            100.0 * q.error / std::abs(q.quantity.measured), name_of(q.agreement));
    for (const PanelResult& p : result.panels)
        if (result.quantities.empty())
            text += fmt::format("{}{} {:.2g} % rms", text.empty() ? "" : ", ", p.panel.name,
                                100.0 * p.deviation);
    return text;
}

std::string finding_of(const PanelResult& r, const Validation& v) {
    std::string text = fmt::format("{}: {:.2g} % of its range (rms) from {}", r.panel.name,
                                   100.0 * r.deviation, v.source.place);
    if (r.inside_band)
        text += fmt::format(", {:.0f} % of the samples inside the band", 100.0 * *r.inside_band);
    return text;
}

Chart::Series series_of(const Validation::Panel& panel) {
    Chart::Series data{.name = "measured",
                       .x = panel.measured.x,
                       .y = panel.measured.y,
                       .style = Chart::Series::black,
                       .markers = false};
    if (panel.low.empty()) {
        data.joined = false, data.markers = true, data.open = true;
        return data;
    }
    Chart::Outline band{panel.measured.x, panel.low};
    band.x.insert(band.x.end(), panel.measured.x.rbegin(), panel.measured.x.rend());
    band.y.insert(band.y.end(), panel.high.rbegin(), panel.high.rend());
    data.name = "measured, 95 %", data.shaded = true;
    data.outlines.push_back(std::move(band));
    return data;
}
}  // namespace

Chart chart_of(const ValidationResult& result, std::size_t index) {
    const PanelResult& r = result.panels[index];
    const Validation& v = result.validation;
    Chart chart{.finding = finding_of(r, v),
                .x = {r.panel.x_label, r.panel.x_unit},
                .y = {r.panel.y_label, r.panel.y_unit},
                .series = {series_of(r.panel)},
                .caption = fmt::format("{}. Run: {}.", v.says, v.what_is_run),
                .alt = fmt::format("{} over {}, measured and simulated. {}.", r.panel.y_label,
                                   r.panel.x_label, finding_of(r, v)),
                .command = "plumbline validate " + v.id};
    const std::size_t first = r.curves.size() - std::min<std::size_t>(3, r.curves.size());
    for (std::size_t level = r.curves.size(); level-- > first;)
        chart.series.push_back({.name = fmt::format("spacing {:.3g} m", result.spacing[level]),
                                .x = r.curves[level].x,
                                .y = r.curves[level].y,
                                .style = static_cast<int>(r.curves.size() - 1 - level),
                                .markers = false});
    return chart;
}

Json json_of(const ValidationResult& result) {
    const Validation& v = result.validation;
    Json json = {{"id", v.id},
                 {"source", json_of(v.source)},
                 {"says", v.says},
                 {"what_is_run", v.what_is_run},
                 {"spacing", numbers(result.spacing)},
                 {"finding", finding_of(result)},
                 {"quantities", Json::array()},
                 {"panels", Json::array()}};
    for (const QuantityResult& q : result.quantities) json["quantities"].push_back(json_of(q));
    for (std::size_t p = 0; p < result.panels.size(); ++p) {
        Json panel = json_of(result.panels[p]);
        panel["chart"] = json_of(chart_of(result, p), fmt::format("validation_{}_{}", v.id, p + 1));
        json["panels"].push_back(std::move(panel));
    }
    return json;
}

Json run_validations(const std::vector<Validation>& validations, Effort effort, Pieces& pieces) {
    constexpr double seconds_each = 7200.0;
    std::vector<Validation> with_levels;
    for (const Validation& v : validations)
        if (!levels_of(v, effort).empty()) with_levels.push_back(v);
    return one_by_one(with_levels, seconds_each, [&](const Validation& v) {
        const std::vector<double> spacing = levels_of(v, effort);
        std::vector<Validation::Observation> observed;
        double seconds = 0.0;
        for (const double s : spacing) {
            stop_if_interrupted();
            const Json piece = pieces.get(fmt::format("validations/{}/{:.6g}", v.id, s),
                                          [&] { return piece_of(v, s); });
            observed.push_back(observation_from(piece));
            seconds += piece["seconds"].get<double>();
        }
        Json result = json_of(judge(v, spacing, observed));
        result["seconds"] = seconds;
        return result;
    });
}

std::string with_uncertainty(const Json& value, const Json& uncertainty, const std::string& unit) {
    return fmt::format("{} ± {}{}{}", short_number(value), short_number(uncertainty),
                       unit.empty() || unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

}  // namespace reports
