#include "reports/frontier_report.h"

#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <algorithm>

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

/// The points of one method; where it failed, only the time is known.
template <class Time>
Chart::Series series_of(const std::string& name, const Frontier& frontier,
                        const std::string& method, Time time) {
    Chart::Series series{.name = name, .x = {}, .y = {}, .joined = false};
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
    return fmt::format(
        "{}, jittered samples, one thread. {} combinations of method, kernel, "
        "h/spacing and number of samples; {} failed (singular or no answer; on the upper rim), {} "
        "are on a floor, {} get worse with more samples. A/A noise {:.1f} %.",
        frontier.dim == 2 ? "Franke's function" : "Plane waves in space",
        frontier.candidates.size(), count([](const Candidate& c) { return c.failed(); }),
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
    for (const std::string& method : methods_of(frontier))
        chart.series.push_back(series_of(method, frontier, method, [](const Candidate& c) {
            return std::optional(c.per_field_s());
        }));
    Chart::Series front{.name = "Pareto front", .x = {}, .y = {}};
    for (const std::size_t k : pareto_front(frontier.candidates, &Candidate::per_field_s)) {
        front.x.push_back(frontier.candidates[k].per_field_s());
        front.y.push_back(frontier.candidates[k].error);
    }
    chart.series.push_back(std::move(front));
    return chart;
}

std::string precomputed_finding(const Frontier& frontier) {
    std::string finding;
    for (const PrecomputedRatio& r : frontier.precomputed)
        if (r.method.starts_with("MLS 2"))
            finding =
                fmt::format("computed once, {} costs {:.2g} SPH sums: \"as efficient as SPH\" {}",
                            r.method, r.over_sph_sum, r.verdict);
    return finding.empty() ? "no method with shape functions computed once" : finding;
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
    for (const std::string& method : methods_of(frontier))
        chart.series.push_back(series_of(method, frontier, method, [](const Candidate& c) {
            return std::optional(c.evaluation.median_s);
        }));
    for (const std::string& method : methods_of(frontier)) {
        Chart::Series applied = series_of(method + ", precomputed", frontier, method,
                                          [](const Candidate& c) -> std::optional<double> {
                                              if (!c.application) return std::nullopt;
                                              return c.application->median_s;
                                          });
        if (!applied.x.empty()) chart.series.push_back(std::move(applied));
    }
    return chart;
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

Json json_of(const Candidate& c) {
    return {{"method", c.method},
            {"kernel", c.kernel},
            {"support_in_spacings", number(c.support_in_spacings)},
            {"samples_per_metre", c.samples_per_metre},
            {"mean_neighbours", number(c.mean_neighbours)},
            {"error", number(c.error)},
            {"failures", c.failures},
            {"places", c.places},
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
            {"over_sph_sum", number(r.over_sph_sum)},
            {"lowest", number(r.lowest)},
            {"highest", number(r.highest)},
            {"over_precomputed_sph", number(r.over_precomputed_sph)},
            {"precomputation_in_sums", number(r.precomputation_in_sums)},
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

std::string csv_of(const Frontier& frontier) {
    const auto median = [](const std::optional<benchmarks::Timing>& t) {
        return t ? fmt::format("{}", t->median_s) : std::string();
    };
    std::string text =
        "method,kernel,support_in_spacings,samples_per_metre,mean_neighbours,error,failures,places,"
        "trend,on_front,search_s,volumes_s,evaluation_s,precomputation_s,application_s,per_place_s,"
        "per_field_s\n";
    for (const Candidate& c : frontier.candidates)
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", c.method,
                            c.kernel, c.support_in_spacings, c.samples_per_metre, c.mean_neighbours,
                            c.error, c.failures, c.places, name_of(c.trend), c.on_front, c.search_s,
                            c.volumes_s, c.evaluation.median_s, median(c.precomputation),
                            median(c.application), c.per_place_s(), c.per_field_s());
    return text;
}

}  // namespace reports
