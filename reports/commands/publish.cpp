#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/json.h"
#include "reports/read_json.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <memory>

namespace reports::publish_command {
namespace {
namespace fs = std::filesystem;

struct Options {
    std::string report, folder = "reports/published";
    std::vector<std::string> charts;
};

/// A published picture names the commit that draws it again, so that commit has to exist.
Json provenance_of_a_commit(const fs::path& file) {
    const Json report = read_json(file), none = Json::object();
    if (report.value("schema", "") != "plumbline.report/1")
        throw plumbline::InvalidInput(
            fmt::format("{}: expected a report with the schema plumbline.report/1", file.string()));
    Json provenance = report.value("provenance", none);
    const std::string version = provenance.value("version", "unknown");
    if (version == "unknown" || version.ends_with("-dirty"))
        throw plumbline::InvalidInput(fmt::format(
            "{}: expected the report of a clean commit, found one of the version \"{}\"",
            file.string(), version));
    return provenance;
}

ExitCode publish(const Options& options) {
    const fs::path report = options.report, folder = options.folder;
    const Json provenance = provenance_of_a_commit(report / "report.json");
    std::vector<std::string> pictures;  // all read before any is written
    for (const std::string& chart : options.charts)
        pictures.push_back(read_file(report / "charts" / (chart + ".png")));
    fs::create_directories(folder);
    for (std::size_t c = 0; c < pictures.size(); ++c)
        write_file(folder / (options.charts[c] + ".png"), pictures[c]);
    write_file(folder / "provenance.json", lines({{"schema", "plumbline.published/1"},
                                                  {"charts", options.charts},
                                                  {"provenance", provenance}}));
    return ExitCode::ok;
}

const RegisterCommand command{
    {"publish", "copies charts of a report, made from a clean commit, with their provenance",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("report", options->report, "the folder that `report` wrote").required();
         line.add_option("--chart", options->charts, "names in its folder charts, without .png")
             .required();
         line.add_option("-o,--output", options->folder, "the folder to copy into")
             .check(output_folder())
             .show_default();
         return [options] { return publish(*options); };
     }}};
}  // namespace
}  // namespace reports::publish_command
