#include "reports/frontier_report.h"

#include "benchmarks/framework/figures.h"
#include "solver/foundation/errors.h"
#include "solver/io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace reports {

using benchmarks::Candidate;
using benchmarks::Frontier;
using benchmarks::PrecomputedRatio;
using verification::Quantity;

namespace {
constexpr std::array quantities{Quantity::value, Quantity::gradient, Quantity::laplacian};

std::vector<std::string> methods_of(const Frontier& frontier) {
    std::vector<std::string> methods;
    for (const Candidate& c : frontier.candidates)
        if (std::ranges::find(methods, c.method) == methods.end()) methods.push_back(c.method);
    return methods;
}

std::string command_of(const Frontier& frontier) {
    return fmt::format("plumbline frontier {} --dim {}", task_of(frontier.quantity), frontier.dim);
}

Chart::Axis error_axis(const Frontier& frontier) {
    return {fmt::format("{} error, root mean square", name_of(frontier.quantity)),
            std::string(unit_of(frontier.quantity)), true};
}

/// The points of one method, whose number is its style; where it failed, only the time is known.
template <class Time>
Chart::Series series_of(const std::string& name, const Frontier& frontier, int number, Time time) {
    Chart::Series series{.name = name, .x = {}, .y = {}, .joined = false, .style = number};
    const std::string method = methods_of(frontier).at(static_cast<std::size_t>(number));
    for (const Candidate& c : frontier.candidates) {
        const std::optional<double> seconds = c.method == method ? time(c) : std::nullopt;
        if (!seconds) continue;
        if (c.failed()) {
            series.failures.push_back(*seconds);
        } else {
            series.x.push_back(*seconds);
            series.y.push_back(c.error);
        }
    }
    return series;
}

std::string counts_of(const Frontier& frontier) {
    const auto count = [&](auto what) { return std::ranges::count_if(frontier.candidates, what); };
    const auto widest = [&](bool mls) {
        double most = 0.0;
        for (const Candidate& c : frontier.candidates)
            if (c.method.starts_with("MLS") == mls) most = std::max(most, c.support_in_spacings);
        return most;
    };
    return fmt::format(
        "{}, jittered samples, one thread. {} combinations of method, kernel, "
        "h/spacing (up to {:g}, of MLS to {:g}) and number of samples (up to {} per metre); {} "
        "failed (singular or no answer; crossed out on the upper rim), {} "
        "are on a floor, {} get worse with more samples. A/A noise {:.1f} %.",
        frontier.dim == 2 ? "Franke's function" : "Plane waves in space",
        frontier.candidates.size(), widest(false), widest(true),
        std::ranges::max(frontier.candidates, {}, &Candidate::samples_per_metre).samples_per_metre,
        count([](const Candidate& c) { return c.failed(); }),
        count([](const Candidate& c) { return c.trend == benchmarks::Trend::saturated; }),
        count([](const Candidate& c) { return c.trend == benchmarks::Trend::grows; }),
        100.0 * frontier.noise);
}

Chart field_chart(const Frontier& frontier) {
    Chart chart{
        .finding = frontier.finding,
        .x = {fmt::format("time for all samples of the unit {}: search, densities, evaluation",
                          frontier.dim == 2 ? "square" : "cube"),
              "s", true},
        .y = error_axis(frontier),
        .series = {},
        .caption = counts_of(frontier),
        .alt = fmt::format("Error against time of every method for the {} in {}D; {}.",
                           name_of(frontier.quantity), frontier.dim, frontier.finding),
        .command = command_of(frontier)};
    int number = 0;
    for (const std::string& method : methods_of(frontier))
        chart.series.push_back(series_of(method, frontier, number++, [](const Candidate& c) {
            return std::optional(c.per_field_s());
        }));
    Chart::Series front{
        .name = "Pareto front", .x = {}, .y = {}, .style = Chart::Series::black, .markers = false};
    for (const std::size_t k : pareto_front(frontier.candidates, &Candidate::per_field_s)) {
        front.x.push_back(frontier.candidates[k].per_field_s());
        front.y.push_back(frontier.candidates[k].error);
    }
    chart.series.push_back(std::move(front));
    return chart;
}

std::string precomputed_finding(const Frontier& frontier) {
    for (const PrecomputedRatio& r : frontier.precomputed)
        if (r.method.starts_with("MLS 2"))
            return fmt::format(
                "computed once, {} takes {:.2f} times as long as SPH computed once: \"as efficient "
                "as "
                "SPH\" {} within the noise of {:.0f} %; {:.2f} of an SPH sum, over which it is "
                "paid "
                "back after {} evaluations",
                r.method, r.over_precomputed_sph.median, r.verdict, 100.0 * frontier.noise,
                r.over_sph_sum.median, evaluations(r.pays_over_sph));
    return "no method with shape functions computed once";
}

Chart place_chart(const Frontier& frontier) {
    const std::string finding = precomputed_finding(frontier);
    Chart chart{.finding = finding,
                .x = {"time per place, neighbours known", "s", true},
                .y = error_axis(frontier),
                .series = {},
                .caption = counts_of(frontier),
                .alt = fmt::format("Error against time per place, evaluated anew and with shape "
                                   "functions computed once; {}.",
                                   finding),
                .command = command_of(frontier)};
    int number = 0;
    for (const std::string& method : methods_of(frontier))
        chart.series.push_back(series_of(method, frontier, number++, [](const Candidate& c) {
            return std::optional(c.evaluation.median_s);
        }));
    number = 0;
    for (const std::string& method : methods_of(frontier)) {
        Chart::Series applied = series_of(method + ", precomputed", frontier, number++,
                                          [](const Candidate& c) -> std::optional<double> {
                                              if (!c.application) return std::nullopt;
                                              return c.application->median_s;
                                          });
        applied.open = true;
        if (!applied.x.empty()) chart.series.push_back(std::move(applied));
    }
    return chart;
}

Json json_of(const benchmarks::RatioRange& r) {
    return {
        {"median", number(r.median)}, {"lowest", number(r.lowest)}, {"highest", number(r.highest)}};
}

Json json_of_timing(const std::optional<benchmarks::Timing>& timing) {
    if (!timing) return nullptr;
    return {{"median_s", number(timing->median_s)}, {"mad_s", number(timing->mad_s)}};
}
}  // namespace

std::string task_of(Quantity quantity) {
    return quantity == Quantity::value ? "approximation" : std::string(name_of(quantity));
}

Quantity quantity_of(const std::string& task) {
    for (const Quantity quantity : quantities)
        if (task == task_of(quantity)) return quantity;
    throw plumbline::InvalidInput(
        "frontier: expected a task of approximation, gradient, laplacian, taylor_green, "
        "hydrostatic, dam_break, found \"" +
        task + "\"");
}

std::string status_of(const Candidate& c) {
    if (c.failures > 0)
        return fmt::format("no answer or a singular matrix at {} of {} places", c.failures,
                           c.places);
    return c.failed() ? "not a number" : "ok";
}

Json json_of(const Candidate& c) {
    return {{"method", c.method},
            {"kernel", c.kernel},
            {"support_in_spacings", number(c.support_in_spacings)},
            {"samples_per_metre", c.samples_per_metre},
            {"samples", std::lround(std::pow(c.samples_per_metre, c.dim))},
            {"mean_neighbours", number(c.mean_neighbours)},
            {"error", number(c.error)},
            {"largest_error", number(c.largest_error)},
            {"failures", c.failures},
            {"places", c.places},
            {"status", status_of(c)},
            {"trend", name_of(c.trend)},
            {"on_front", c.on_front},
            {"search_s", number(c.search_s)},
            {"volumes_s", number(c.volumes_s)},
            {"evaluation", json_of_timing(c.evaluation)},
            {"precomputation", json_of_timing(c.precomputation)},
            {"application", json_of_timing(c.application)},
            {"per_place_s", number(c.per_place_s())},
            {"per_field_s", number(c.per_field_s())}};
}

Json json_of(const PrecomputedRatio& r) {
    return {{"method", r.method},
            {"over_precomputed_sph", json_of(r.over_precomputed_sph)},
            {"over_sph_sum", json_of(r.over_sph_sum)},
            {"precomputation_in_sums", number(r.precomputation_in_sums)},
            {"pays_over_itself", number(r.pays_over_itself)},
            {"pays_over_sph", number(r.pays_over_sph)},
            {"verdict", r.verdict}};
}

Json json_of(const Frontier& frontier) {
    Json ratios = Json::array(), candidates = Json::array();
    for (const PrecomputedRatio& r : frontier.precomputed) ratios.push_back(json_of(r));
    for (const Candidate& c : frontier.candidates) candidates.push_back(json_of(c));
    return {{"task", task_of(frontier.quantity)},
            {"dim", frontier.dim},
            {"finding", frontier.finding},
            {"noise", number(frontier.noise)},
            {"statement",
             {{"source", "adams2009 Sec. 3, 3.1"},
              {"says", "with shape functions computed once, MLS is as efficient as SPH"},
              {"measured", std::move(ratios)}}},
            {"candidates", std::move(candidates)}};
}

std::string name_of(const Frontier& frontier) {
    return fmt::format("{}_{}d", task_of(frontier.quantity), frontier.dim);
}

std::vector<NamedChart> charts_of(const Frontier& frontier) {
    const std::string name = "frontier_" + name_of(frontier);
    return {{name + "_per_field", field_chart(frontier)},
            {name + "_per_place", place_chart(frontier)}};
}

std::string evaluations(double count) {
    return count < HUGE_VAL ? benchmarks::factor_in_words(count) : "never";
}

std::string candidates_csv(const Json& frontier) {
    const auto field = [](const Json& value) -> std::string {
        if (value.is_null()) return "";
        if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
        if (value.is_string()) return value.get<std::string>();
        return fmt::format("{}", value.get<double>());
    };
    std::ostringstream text;
    std::optional<plumbline::CsvWriter> csv;
    for (const Json& c : frontier.at("candidates")) {
        std::vector<std::string> names, values;
        for (const auto& [key, value] : c.items()) {
            const bool timed =
                key == "evaluation" || key == "precomputation" || key == "application";
            names.push_back(timed ? key + "_s" : key);
            values.push_back(field(timed && !value.is_null() ? value.at("median_s") : value));
        }
        if (!csv) csv.emplace(text, names);
        for (const std::string& value : values) csv->add(value);
        csv->end_row();
    }
    return text.str();
}

}  // namespace reports
