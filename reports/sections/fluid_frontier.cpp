#include "reports/charts/chart_json.h"
#include "reports/fluid_frontier_report.h"
#include "reports/interrupt.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

namespace reports::fluid_frontier_section {
namespace {
using verification::Effort;

Json measured(const std::string& task, Effort effort) {
    const auto frontier = benchmarks::measure_fluids(task, effort, [] { stop_if_interrupted(); });
    Json piece = json_of(frontier);
    piece["chart"] = json_of(chart_of(frontier), "frontier_" + task);
    return piece;
}

void measure_fluids(ReportRun& run) {
    const Effort effort = run.quick ? Effort::quick : Effort::full;
    run.report["fluid_frontiers"] = Json::array();
    for (const std::string& task : benchmarks::fluid_tasks()) {
        const Json frontier = run.piece("frontier/" + task, "frontier of the fluid " + task,
                                        [&] { return measured(task, effort); });
        run.report["findings_cost"].push_back(
            fmt::format("{}: {}.", task, frontier["finding"].get<std::string>()));
        run.report["fluid_frontiers"].push_back(frontier);
    }
}

Json row_of(const Json& c) {
    return {{"method", c["method"]},
            {"kernel", c["kernel"]},
            {"resolution", c["resolution"]},
            {"support", short_number(c["support_in_spacings"])},
            {"sound", c["speed_of_sound"] == 0.0 ? "none" : short_number(c["speed_of_sound"])},
            {"courant", short_number(c["courant"])},
            {"error", short_number(c["error"])},
            {"seconds", short_number(c["seconds"])},
            {"front", c["on_front"].get<bool>() ? "on the front" : c["failure"].get<std::string>()},
            {"class", c["on_front"].get<bool>()                 ? "ok"
                      : c["failure"].get<std::string>().empty() ? ""
                                                                : "bad"}};
}

Json view(const Json& report) {
    if (report.value("fluid_frontiers", Json::array()).empty()) return nullptr;
    Json tasks = Json::array();
    for (const Json& frontier : report["fluid_frontiers"]) {
        Json task = {{"task", frontier["task"]},
                     {"finding", frontier["finding"]},
                     {"resolution_of", frontier["resolution_of"]},
                     {"chart", frontier["chart"]},
                     {"candidates", Json::array()}};
        for (const Json& c : frontier["candidates"]) task["candidates"].push_back(row_of(c));
        tasks.push_back(std::move(task));
    }
    return {{"tasks", tasks}};
}

const RegisterSection section{{35, "fluid_frontier", "What does accuracy cost in a fluid?",
                               measure_fluids, view, templates::fluid_frontier}};
}  // namespace
}  // namespace reports::fluid_frontier_section
