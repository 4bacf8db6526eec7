#include "reports/charts/chart_json.h"
#include "reports/frontier_report.h"
#include "reports/interrupt.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

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

Json row_of(const Json& ratio) {
    const std::string verdict = ratio["verdict"];
    return {
        {"method", ratio["method"]},
        {"over_sph_sum", fmt::format("{:.2f}", ratio["over_sph_sum"].get<double>())},
        {"lowest", fmt::format("{:.2f}", ratio["lowest"].get<double>())},
        {"highest", fmt::format("{:.2f}", ratio["highest"].get<double>())},
        {"precomputation", fmt::format("{:.0f}", ratio["precomputation_in_sums"].get<double>())},
        {"verdict", verdict},
        {"class", verdict == "holds" ? "ok" : "bad"}};
}

Json view(const Json& report) {
    if (report.value("frontiers", Json::array()).empty()) return nullptr;
    Json tasks = Json::array();
    for (const Json& frontier : report["frontiers"]) {
        Json task = {{"task", frontier["task"]},
                     {"dim", frontier["dim"]},
                     {"finding", frontier["finding"]},
                     {"charts", frontier["charts"]},
                     {"ratios", Json::array()}};
        for (const Json& ratio : frontier["statement"]["measured"])
            task["ratios"].push_back(row_of(ratio));
        tasks.push_back(std::move(task));
    }
    return {{"tasks", tasks}};
}

const RegisterSection section{
    {30, "frontier", "What does accuracy cost?", measure_frontiers, view, templates::frontier}};
}  // namespace
}  // namespace reports::frontier_section
