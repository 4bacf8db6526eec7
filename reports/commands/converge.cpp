#include "reports/charts/study_chart.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "reports/measurements.h"
#include "reports/select.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace reports {
namespace {
using namespace verification;

struct Options {
    std::vector<std::string> patterns;
    std::string tag, json, folder;
    bool quick = false;
    double seconds_per_study = 3600.0;
};

std::string joined(const std::vector<double>& values, const char* format) {
    std::string text;
    for (const double v : values)
        text += fmt::format("{}{}", text.empty() ? "" : " ", fmt::format(fmt::runtime(format), v));
    return text;
}

void print_table(const StudyResult& result) {
    fmt::print("\n{}: {}\n  {}, {} levels of spacing {}, {} seeds, {:.1f} s\n", result.study.id,
               result.study.says, result.study.quantity, result.spacing.size(),
               joined(result.spacing, "{:.4g}"), result.seeds, result.seconds);
    if (!result.error.empty()) fmt::print("  error: {}\n", result.error);
    if (!result.warning.empty()) fmt::print("  {}\n", result.warning);
    for (const SeriesResult& s : result.series) {
        const std::string expected =
            s.expected_saturation
                ? "to saturate"
                : fmt::format("in [{:.2f}, {:.2f}]", s.expected_order.low, s.expected_order.high);
        fmt::print(
            "  {:<24} {:<34} order {:5.2f} in [{:5.2f}, {:5.2f}], expected {:<18} errors {}\n",
            name_of(s.verdict), s.name + (s.sabotaged ? " (sabotaged)" : ""), s.fit.order,
            s.fit.confidence.low, s.fit.confidence.high, expected, joined(s.fit.error, "{:.2e}"));
        if (s.verdict == Verdict::verified) continue;
        fmt::print("    expected because {}; floor {:.2e}, local orders {}\n", s.expected_order.why,
                   s.fit.floor, joined(s.fit.local_orders, "{:.2f}"));
    }
}

/// A study that cannot be told is not a pass: inconclusive and the like give exit code 3.
ExitCode judge(const std::vector<StudyResult>& results) {
    ExitCode exit = ExitCode::ok;
    for (const StudyResult& result : results) {
        if (!result.error.empty()) return ExitCode::check_failed;
        for (const SeriesResult& s : result.series) {
            if (passed(s.verdict)) continue;
            const bool undecided =
                s.verdict == Verdict::inconclusive || s.verdict == Verdict::not_in_asymptotic_range;
            if (!undecided) return ExitCode::check_failed;
            exit = ExitCode::inconclusive;
        }
    }
    return exit;
}

ExitCode converge(const Options& options) {
    const auto selected = select(studies(), options.patterns, options.tag);
    if (selected.empty()) {
        fmt::print(stderr, "plumbline: no study matches; `plumbline list studies` names them\n");
        return ExitCode::inconclusive;
    }
    const Effort effort = options.quick ? Effort::quick : Effort::full;
    const auto results = run_all(selected, effort, options.seconds_per_study);
    if (options.json != "-")
        for (const StudyResult& result : results) print_table(result);
    if (!options.json.empty()) write_json(document("studies", json_array(results)), options.json);
    if (!options.folder.empty())
        for (const StudyResult& result : results)
            if (result.error.empty())
                draw(chart_of(result), options.folder, file_name_of(result.study));
    return judge(results);
}

const RegisterCommand command{
    {"converge", "run the convergence studies: orders with intervals, charts",
     [](CLI::App& app) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         app.add_option("pattern", options->patterns,
                        "part of an id, or with the wildcards of a shell; all if none is given");
         app.add_option("--tag", options->tag, "only studies with this tag");
         app.add_flag("--quick", options->quick, "only the coarser levels");
         app.add_option("-o,--output", options->folder,
                        "write a chart (SVG, PNG) and a table (CSV) of each study to this folder");
         app.add_option("--json", options->json, "write the results to this file, - for stdout")
             ->expected(0, 1)
             ->default_str("-");
         app.add_option("--time-limit", options->seconds_per_study,
                        "seconds that one study may take")
             ->check(CLI::PositiveNumber)
             ->capture_default_str();
         return [options] { return converge(*options); };
     }}};
}  // namespace
}  // namespace reports
