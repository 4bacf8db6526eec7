#include "reports/charts/chart_json.h"
#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "reports/select.h"
#include "reports/study_pieces.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace reports::converge_command {
namespace {
using namespace verification;

struct Options {
    std::vector<std::string> patterns;
    std::string tag, json, folder;
    bool quick = false;
    double seconds_per_study = 3600.0;
};

std::string joined(const Json& values, const char* format) {
    std::string text;
    for (const Json& v : values)
        text +=
            fmt::format("{}{}", text.empty() ? "" : " ",
                        v.is_number() ? fmt::format(fmt::runtime(format), v.get<double>()) : "-");
    return text;
}

void print_series(const Json& s) {
    std::string expected =
        s["expected_saturation"].get<bool>() ? "to saturate" : bound_in_words(s["expected"]);
    if (s["expected_saturation"].get<bool>() && s["verdict"] == "verified")
        expected += fmt::format(", rests at {}", short_number(s["floor"]));
    fmt::print("  {:<24} {:<34} order {} in [{}], expected {:<18} errors {}\n",
               s["verdict"].get<std::string>(),
               s["name"].get<std::string>() + (s["sabotaged"].get<bool>() ? " (sabotaged)" : ""),
               short_number(s["order"]), joined(s["confidence"], "{:.2f}"), expected,
               joined(s["level_errors"], "{:.2e}"));
    if (s["verdict"] == "verified") return;
    fmt::print("    expected because {}; floor {}, local orders {}\n",
               s["expected"]["why"].get<std::string>(), short_number(s["floor"]),
               joined(s["local_orders"], "{:.2f}"));
}

void print_table(const Json& study) {
    fmt::print("\n{}: {}\n  {}, {} of spacing {}, {}, {:.1f} s\n", study["id"].get<std::string>(),
               study["says"].get<std::string>(), study["quantity"].get<std::string>(),
               counted(study["spacing"].size(), "level"), joined(study["spacing"], "{:.4g}"),
               counted(study["seeds"].get<std::size_t>(), "seed"), study["seconds"].get<double>());
    for (const char* remark : {"error", "warning"})
        if (study.contains(remark))
            fmt::print("  {}: {}\n", remark, study[remark].get<std::string>());
    for (const Json& s : study["series"]) print_series(s);
}

/// A study that cannot be told is not a pass: inconclusive and the like give exit code 3.
ExitCode judge(const Json& studies) {
    ExitCode exit = ExitCode::ok;
    for (const Json& study : studies) {
        if (study.contains("error")) return ExitCode::check_failed;
        for (const Json& series : study["series"]) {
            const std::string colour = colour_class(series["verdict"]);
            if (colour == "bad") return ExitCode::check_failed;
            if (colour == "open") exit = ExitCode::inconclusive;
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
    const std::filesystem::path folder = options.folder;
    Pieces pieces(folder.empty() ? folder : folder / "pieces",
                  fingerprint(options.quick ? "quick" : "full"));
    const Json results = run_studies(selected, options.quick ? Effort::quick : Effort::full,
                                     options.seconds_per_study, pieces);
    if (options.json != "-")
        for (const Json& study : results) print_table(study);
    if (!options.json.empty()) write_json(document("studies", results), options.json);
    if (!folder.empty())
        for (const Json& study : results)
            if (study.contains("chart"))
                draw(chart_from(study["chart"]), folder, study["chart"]["name"]);
    return judge(results);
}

const RegisterCommand command{
    {"converge", "run the convergence studies: orders with intervals, charts",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("pattern", options->patterns,
                         "part of an id, or with the wildcards of a shell; all if none is given");
         line.add_option("--tag", options->tag, "only studies with this tag");
         line.add_flag("--quick", options->quick, "only the coarser levels");
         line.add_option("-o,--output", options->folder,
                         "write a chart (SVG, PNG) and a table (CSV) of each study to this "
                         "folder; a run that was interrupted continues from what is there")
             .check(output_folder());
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         line.add_option("--time-limit", options->seconds_per_study,
                         "seconds that one study may take")
             .check(positive_number())
             .show_default();
         return [options] { return converge(*options); };
     }}};
}  // namespace
}  // namespace reports::converge_command
