#include "reports/charts/chart_json.h"
#include "reports/frontier_report.h"
#include "reports/interrupt.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace reports::frontier_section {
namespace {
using verification::Effort;
using verification::Quantity;

constexpr std::array quantities{Quantity::value, Quantity::gradient};
constexpr std::array dimensions{2, 3};

Json measured(Quantity quantity, int dim, Effort effort) {
    const auto frontier =
        benchmarks::measure_frontier(quantity, dim, effort, [](double) { stop_if_interrupted(); });
    Json piece = json_of(frontier);
    piece["charts"] = Json::array();
    for (const NamedChart& named : charts_of(frontier))
        piece["charts"].push_back({{"chart", json_of(named.chart, named.name)}});
    return piece;
}

void measure_frontiers(ReportRun& run) {
    const Effort effort = run.quick ? Effort::quick : Effort::full;
    run.report["frontiers"] = Json::array();
    for (const Quantity quantity : quantities)
        for (const int dim : dimensions) {
            const std::string task = fmt::format("{} in {}D", task_of(quantity), dim);
            const Json frontier = run.piece(fmt::format("frontier/{}_{}d", task_of(quantity), dim),
                                            "frontier of the " + task,
                                            [&] { return measured(quantity, dim, effort); });
            run.report["findings_cost"].push_back(
                fmt::format("{}: {}.", task, frontier["finding"].get<std::string>()));
            run.report["frontiers"].push_back(frontier);
        }
}

std::string ratio_in_words(const Json& ratio) {
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", ratio["median"].get<double>(),
                       ratio["lowest"].get<double>(), ratio["highest"].get<double>());
}

std::string evaluations_in(const Json& count) { return evaluations(value_of(count)); }

Json row_of_ratio(const Json& ratio) {
    const std::string verdict = ratio["verdict"];
    return {{"method", ratio["method"]},
            {"like_with_like", ratio_in_words(ratio["over_precomputed_sph"])},
            {"over_sum", ratio_in_words(ratio["over_sph_sum"])},
            {"precomputation", short_number(ratio["precomputation_in_sums"])},
            {"pays_over_itself", evaluations_in(ratio["pays_over_itself"])},
            {"pays_over_sph", evaluations_in(ratio["pays_over_sph"])},
            {"verdict", verdict},
            {"class", verdict == "holds"           ? "ok"
                      : verdict == "does not hold" ? "bad"
                                                   : ""}};
}

Json row_of_candidate(const Json& c) {
    const auto median = [](const Json& timing) {
        return timing.is_null() ? std::string("none") : short_number(timing["median_s"]);
    };
    return {{"method", c["method"]},
            {"kernel", c["kernel"]},
            {"support", short_number(c["support_in_spacings"])},
            {"samples", c["samples"]},
            {"neighbours", short_number(c["mean_neighbours"])},
            {"error", short_number(c["error"])},
            {"largest", short_number(c["largest_error"])},
            {"per_field", short_number(c["per_field_s"])},
            {"evaluation", median(c["evaluation"])},
            {"precomputation", median(c["precomputation"])},
            {"application", median(c["application"])},
            {"trend", c["trend"]}};
}

/// Those on the front, the cheapest first.
Json front_of(const Json& candidates) {
    std::vector<Json> front;
    for (const Json& c : candidates)
        if (c["on_front"].get<bool>()) front.push_back(c);
    std::ranges::sort(front, {}, [](const Json& c) { return c["per_field_s"].get<double>(); });
    Json rows = Json::array();
    for (const Json& c : front) rows.push_back(row_of_candidate(c));
    return rows;
}

Json view(const Json& report) {
    if (report.value("frontiers", Json::array()).empty()) return nullptr;
    Json tasks = Json::array();
    for (const Json& frontier : report["frontiers"]) {
        const std::string name = fmt::format("frontier_{}_{}d", frontier["task"].get<std::string>(),
                                             frontier["dim"].get<int>());
        Json task = {{"task", frontier["task"]},
                     {"dim", frontier["dim"]},
                     {"finding", frontier["finding"]},
                     {"charts", frontier["charts"]},
                     {"front", front_of(frontier["candidates"])},
                     {"measured", frontier["candidates"].size()},
                     {"file", {{"name", name + ".csv"}, {"text", candidates_csv(frontier)}}},
                     {"ratios", Json::array()}};
        for (const Json& ratio : frontier["statement"]["measured"])
            task["ratios"].push_back(row_of_ratio(ratio));
        tasks.push_back(std::move(task));
    }
    return {{"tasks", tasks}};
}

const RegisterSection section{
    {30, "frontier", "What does accuracy cost?", measure_frontiers, view, templates::frontier}};
}  // namespace
}  // namespace reports::frontier_section
