#include "reports/charts/chart_json.h"
#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/select.h"
#include "reports/stability_report.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <memory>

namespace reports::stability_command {
namespace {
using namespace verification;

struct Options {
    std::vector<std::string> patterns;
    std::string json, folder;
    bool quick = false;
};

void print(const Json& map) {
    fmt::print("\n{}: {}\n  {}\n  {} over {}, {:.1f} s; {}\n", map["id"].get<std::string>(),
               map["finding"].get<std::string>(), map["says"].get<std::string>(),
               map["y"].get<std::string>(), map["x"].get<std::string>(),
               map["seconds"].get<double>(), map["what_is_run"].get<std::string>());
    for (const Json& line : map["lines"]) {
        if (!line["tested"].get<bool>()) continue;
        fmt::print("  {:<12} {}\n", line["verdict"].get<std::string>(),
                   line["name"].get<std::string>());
        for (const Json& p : line["points"])
            fmt::print("    {:>10} theory {:>10} measured {:>10} ratio {}\n", short_number(p["x"]),
                       short_number(p["theory"]), short_number(p["measured"]),
                       p["ratio"].is_number() ? fmt::format("{:.3f}", p["ratio"].get<double>())
                                              : short_number(p["ratio"]));
        if (line["verdict"] != "verified" || line["expected"]["high"] != 1.02)
            fmt::print("    expected {}: {}\n", bound_in_words(line["expected"]),
                       line["expected"]["why"].get<std::string>());
    }
}

/// A border that the runs could not tell is not a pass.
ExitCode judge(const Json& maps) {
    ExitCode exit = ExitCode::ok;
    for (const Json& map : maps) {
        const std::string colour = colour_class(map["verdict"]);
        if (colour == "bad") return ExitCode::check_failed;
        if (colour == "open") exit = ExitCode::inconclusive;
    }
    return exit;
}

ExitCode stability(const Options& options) {
    const auto selected = select(maps(), options.patterns);
    if (selected.empty()) {
        fmt::print(stderr, "plumbline: no map matches; `plumbline list maps` names them\n");
        return ExitCode::inconclusive;
    }
    const std::filesystem::path folder = options.folder;
    Pieces pieces(folder.empty() ? folder : folder / "pieces",
                  fingerprint(options.quick ? "quick" : "full"));
    const Json results = run_maps(selected, options.quick ? Effort::quick : Effort::full, pieces);
    if (options.json != "-")
        for (const Json& map : results) print(map);
    if (!options.json.empty()) write_json(document("maps", results), options.json);
    if (!folder.empty())
        for (const Json& map : results) {
            const DrawnChart files = draw(chart_from(map["chart"]), folder, map["chart"]["name"]);
            fmt::print(stderr, "wrote {}\n", files.svg.string());
        }
    return judge(results);
}

const RegisterCommand command{
    {"stability", "where fluids break: borders found by runs beside the theory of the lattice",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("map", options->patterns,
                         "part of an id, or with the wildcards of a shell; all if none is given");
         line.add_flag("--quick", options->quick, "one or two runs per line instead of ten");
         line.add_option("-o,--output", options->folder,
                         "write a chart (SVG, PNG) and a table (CSV) of each map to this folder; a "
                         "run that was interrupted continues from what is there")
             .check(output_folder());
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return stability(*options); };
     }}};
}  // namespace
}  // namespace reports::stability_command
