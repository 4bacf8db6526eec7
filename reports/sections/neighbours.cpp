#include "reports/charts/chart_json.h"
#include "reports/interrupt.h"
#include "reports/neighbours_charts.h"
#include "reports/neighbours_report.h"
#include "reports/page/templates.h"
#include "reports/sections/section.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <optional>

namespace reports::neighbours_section {
namespace {
using namespace benchmarks;

Json measured(const SearchStudy& study, bool quick) {
    ComparisonOptions how = effort(quick ? Level::quick : Level::usual);
    how.progress = [](const std::string&) { stop_if_interrupted(); };
    SearchStudyResult result{study.name, study.question, {}};
    for (const SearchSituation& situation : study.situations)
        result.cases.push_back(benchmarks::measure(situation, how));
    const std::string command =
        fmt::format("plumbline neighbours --study {}{}", study.name, quick ? " --quick" : "");
    Json piece = json_of(result);
    piece["command"] = command;
    piece["charts"] = Json::array();
    for (const NamedChart& named : charts_of(result, command))
        piece["charts"].push_back({{"chart", json_of(named.chart, named.name)}});
    return piece;
}

void measure_searches(ReportRun& run) {
    Json& report = run.report["neighbours"] = {{"studies", Json::array()}};
    for (const SearchStudy& study : search_studies(run.quick ? Level::quick : Level::usual))
        report["studies"].push_back(run.piece("neighbours/" + study.name,
                                              "neighbour searches: " + study.question,
                                              [&] { return measured(study, run.quick); }));
    const Json& largest = report["studies"][0]["cases"].back();
    run.report["findings_cost"].push_back(
        fmt::format("neighbour search, {} points: {}.", largest["count"].get<std::size_t>(),
                    largest["recommendation"].get<std::string>()));
    for (const Json& study : report["studies"])
        for (const Json& verdict : study["verdicts"])
            if (study["id"] == "contrast")
                run.report["findings_breaks"].push_back(fmt::format(
                    "{}: {}; {}", verdict["statement"].get<std::string>(),
                    verdict["verdict"].get<std::string>(), verdict["evidence"].get<std::string>()));
}

/// Nanoseconds per point of a phase; empty if it was not measured.
std::string per_point(const Json& search, const char* phase, const Json& count) {
    if (!search.contains(phase) || search[phase]["median_s"].is_null()) return "";
    return fmt::format("{:.0f}",
                       search[phase]["median_s"].get<double>() * 1e9 / count.get<double>());
}

Json bytes_per_point(const Json& bytes, const Json& count) {
    if (bytes.is_null()) return "";
    return fmt::format("{:.0f}", bytes.get<double>() / count.get<double>());
}

std::string ratio_in_words(const Json& search) {
    if (!search.contains("over_fastest")) return "";
    const Json& r = search["over_fastest"];
    if (r["low"] == r["high"]) return "1";
    return fmt::format("{} [{}, {}]", short_number(r["value"]), short_number(r["low"]),
                       short_number(r["high"]));
}

Json row_of(const Json& search, const Json& count) {
    const bool agrees = search["wrong_pairs"] == 0,
               left_out = !search.value("left_out", "").empty();
    Json row = {{"search", search["search"]},
                {"agrees", left_out ? "left out"
                           : agrees ? "agrees"
                                    : "wrong pairs: not timed"},
                {"class", agrees ? "ok" : "bad"},
                {"build", per_point(search, "build", count)},
                {"query", per_point(search, "query", count)},
                {"update", per_point(search, "update", count)},
                {"held", bytes_per_point(search["held_bytes"], count)},
                {"of_fastest", ratio_in_words(search)},
                {"place", ""}};
    if (search.contains("first_place")) {
        const auto first = search["first_place"].get<int>(), last = search["last_place"].get<int>();
        row["place"] =
            first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last);
    }
    return row;
}

Json view_of_case(const Json& c) {
    Json rows = Json::array();
    for (const Json& search : c["searches"]) rows.push_back(row_of(search, c["count"]));
    return {{"case", c["case"]},
            {"neighbours", short_number(c["mean_neighbours"])},
            {"recommendation", c["recommendation"]},
            {"rows", std::move(rows)}};
}

Json view_of_exponents(const Json& exponents) {
    Json rows = Json::array();
    for (const Json& e : exponents)
        rows.push_back(
            {{"search", e["search"]},
             {"phase", e["phase"]},
             {"exponent", fmt::format("{:.2f}", e["value"].get<double>())},
             {"interval", fmt::format("[{}, {}]", short_number(e["low"]), short_number(e["high"]))},
             {"n_log_n", short_number(e["n_log_n"])}});
    return rows;
}

Json view(const Json& report) {
    if (!report.contains("neighbours")) return nullptr;
    Json studies = Json::array(), verdicts = Json::array();
    for (const Json& study : report["neighbours"]["studies"]) {
        Json cases = Json::array();
        for (const Json& c : study["cases"]) cases.push_back(view_of_case(c));
        const Json exponents = view_of_exponents(study["exponents"]);
        studies.push_back({{"question", study["question"]},
                           {"command", study["command"]},
                           {"charts", study["charts"]},
                           {"has_exponents", !exponents.empty()},
                           {"exponents", exponents},
                           {"cases", std::move(cases)}});
        for (Json verdict : study["verdicts"]) {
            const std::string word = verdict["verdict"];
            verdict["class"] = word == "holds" ? "ok" : word == "cannot be told" ? "open" : "bad";
            verdicts.push_back(std::move(verdict));
        }
    }
    return {{"studies", std::move(studies)}, {"verdicts", std::move(verdicts)}};
}

const RegisterSection section{{60, "neighbours", "Which neighbour search is the fastest?",
                               measure_searches, view, templates::neighbours}};
}  // namespace
}  // namespace reports::neighbours_section
