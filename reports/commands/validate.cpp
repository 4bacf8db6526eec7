#include "reports/charts/chart_json.h"
#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/select.h"
#include "reports/validation_report.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <memory>

namespace reports::validate_command {
namespace {
using namespace verification;

struct Options {
    std::vector<std::string> patterns;
    std::string json, folder;
    bool quick = false;
};

void print(const Json& validation) {
    fmt::print("\n{}: {}\n  {}; {:.1f} s; spacing {} m\n", validation["id"].get<std::string>(),
               validation["says"].get<std::string>(), validation["what_is_run"].get<std::string>(),
               validation["seconds"].get<double>(), in_words(validation["spacing"]));
    for (const Json& q : validation["quantities"]) {
        fmt::print("  {:<12} {}: {}, measured {}; E = {}\n", q["verdict"].get<std::string>(),
                   q["name"].get<std::string>(), in_words(q["simulated"]),
                   short_number(q["measured"]),
                   with_uncertainty(q["error"], q["u_val"], q["unit"]));
        fmt::print("    u_num {}, u_input {}, u_D {}: {}\n", short_number(q["u_num"]),
                   short_number(q["u_input"]), short_number(q["u_data"]),
                   q["why"].get<std::string>());
        if (const std::string goal = q["goal"]; !goal.empty())
            fmt::print("    goal E/D {}\n", goal);
    }
    for (const Json& p : validation["panels"]) {
        fmt::print("  {}\n", p["chart"]["finding"].get<std::string>());
        if (const std::string goal = p["goal"]; !goal.empty())
            fmt::print("    goal share inside {}\n", goal);
    }
}

/// How well a model does is no check of the program; a comparison that says nothing is told.
ExitCode judge(const Json& validations) {
    for (const Json& validation : validations)
        if (count_verdict(validation["quantities"], "inconclusive") > 0)
            return ExitCode::inconclusive;
    return ExitCode::ok;
}

ExitCode validate(const Options& options) {
    const auto selected = select(validations(), options.patterns);
    if (selected.empty()) {
        fmt::print(stderr,
                   "plumbline: no validation matches; `plumbline list validations` names them\n");
        return ExitCode::inconclusive;
    }
    const std::filesystem::path folder = options.folder;
    Pieces pieces(folder.empty() ? folder : folder / "pieces",
                  fingerprint(options.quick ? "quick" : "full"));
    const Json results =
        run_validations(selected, options.quick ? Effort::quick : Effort::full, pieces);
    if (results.empty()) {
        fmt::print(stderr, "plumbline: what matches takes minutes; without --quick it is run\n");
        return ExitCode::inconclusive;
    }
    if (options.json != "-")
        for (const Json& validation : results) print(validation);
    if (!options.json.empty()) write_json(document("validations", results), options.json);
    if (!folder.empty())
        for (const Json& validation : results)
            for (const Json& panel : validation["panels"]) {
                const DrawnChart files =
                    draw(chart_from(panel["chart"]), folder, panel["chart"]["name"]);
                fmt::print(stderr, "wrote {}\n", files.svg.string());
            }
    return judge(results);
}

const RegisterCommand command{
    {"validate", "against experiment: error E beside u_num, u_input and u_D (ASME V&V 20)",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("validation", options->patterns,
                         "part of an id, or with the wildcards of a shell; all if none is given");
         line.add_flag("--quick", options->quick, "the coarse levels only: seconds, not minutes");
         line.add_option("-o,--output", options->folder,
                         "write a chart (SVG, PNG) and a table (CSV) of each signal to this "
                         "folder; a run that was interrupted continues from what is there")
             .check(output_folder());
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return validate(*options); };
     }}};
}  // namespace
}  // namespace reports::validate_command
