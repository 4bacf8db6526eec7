#include "reports/charts/chart_json.h"
#include "reports/interrupt.h"
#include "reports/neighbours_report.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

namespace reports {
namespace {
using plumbline::Index;

/// Enough rounds for a spread.
constexpr int rounds = 5;

Json measured(bool quick) {
    benchmarks::ComparisonOptions options;
    options.repeats = rounds;
    options.progress = [](const std::string&) { stop_if_interrupted(); };
    NeighbourComparison comparison;
    comparison.command = "plumbline neighbours";
    for (const Index count : {Index{1000}, Index{10000}, Index{100000}, Index{1000000}}) {
        if (quick && count > 100000) break;
        comparison.command += fmt::format(" --count {}", count);
        comparison.cases.push_back(compare(benchmarks::make_cloud<3>("jittered", count), options));
    }
    Json piece = json_of(comparison);
    piece["charts"] = Json::array();
    for (const NamedChart& named : charts_of(comparison))
        piece["charts"].push_back({{"chart", json_of(named.chart, named.name)}});
    return piece;
}

void measure_searches(ReportRun& run) {
    const Json piece = run.piece("neighbours", "comparison of the neighbour searches",
                                 [&] { return measured(run.quick); });
    run.report["neighbours"] = piece;
    run.report["findings_cost"].push_back(fmt::format(
        "neighbour search: {}.", piece["cases"].back()["recommendation"].get<std::string>()));
}

std::string nanoseconds_per_point(const Json& timing, const Json& count) {
    if (timing["median_s"].is_null()) return "not timed";
    return fmt::format("{:.0f}", timing["median_s"].get<double>() * 1e9 / count.get<double>());
}

Json row_of(const Json& search, const Json& count) {
    const bool agrees = search["wrong_pairs"] == 0;
    return {{"search", search["search"]},
            {"agrees", agrees ? "agrees" : "wrong pairs"},
            {"class", agrees ? "ok" : "bad"},
            {"build", nanoseconds_per_point(search["build"], count)},
            {"query", nanoseconds_per_point(search["query"], count)},
            {"of_fastest", short_number(search["over_fastest"])}};
}

Json view(const Json& report) {
    if (!report.contains("neighbours")) return nullptr;
    Json cases = Json::array();
    for (const Json& c : report["neighbours"]["cases"]) {
        Json rows = Json::array();
        for (const Json& search : c["searches"]) rows.push_back(row_of(search, c["count"]));
        cases.push_back({{"count", c["count"]},
                         {"neighbours", short_number(c["mean_neighbours"])},
                         {"threads", c["threads"]},
                         {"recommendation", c["recommendation"]},
                         {"rows", std::move(rows)}});
    }
    return {{"command", report["neighbours"]["command"]},
            {"charts", report["neighbours"]["charts"]},
            {"cases", std::move(cases)}};
}

const RegisterSection section{{60, "neighbours", "Which neighbour search is the fastest?",
                               measure_searches, view, templates::neighbours}};
}  // namespace
}  // namespace reports
