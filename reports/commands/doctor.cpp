#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "reports/noise_floor.h"
#include "reports/process.h"

#include <fmt/format.h>

#include <memory>

namespace reports::doctor_command {
namespace {
struct Tool {
    const char *name, *needed_for, *install;
    bool required;
};
constexpr Tool tools[] = {
    {"gnuplot", "the charts of converge, neighbours, frontier and report", "gnuplot-nox", true},
    {"chromium", "the test of the page, nothing else", "chromium", false},
    {"xmllint", "the test of the JUnit file, nothing else", "libxml2-utils", false}};

/// First line of `name --version`, which some programs (xmllint) write to stderr, where others (chromium)
/// complain; empty if there is no such program.
std::string version_of(const char* name) {
    for (const Streams streams : {Streams::stdout_only, Streams::both}) {
        const auto result = run_process({name, "--version"}, streams);
        if (result && !result->output.empty())
            return result->output.substr(0, result->output.find('\n'));
    }
    return "";
}

Json examine() {
    Json found = json_of(provenance());
    found["tools"] = Json::array();
    for (const Tool& tool : tools)
        found["tools"].push_back({{"name", tool.name},
                                  {"version", version_of(tool.name)},
                                  {"needed_for", tool.needed_for},
                                  {"package", tool.install},
                                  {"required", tool.required}});
    const NoiseFloor floor = measure_noise_floor();
    found["noise"] = {{"relative", floor.relative},
                      {"spread", floor.spread},
                      {"seconds", floor.seconds},
                      {"rounds", floor.rounds},
                      {"runs", floor.runs}};
    return found;
}

void print(const Json& found) {
    const auto line = [](std::string_view what, const std::string& value) {
        fmt::print("{:<14} {}\n", what, value);
    };
    line("version", found["version"]);
    line("compiler",
         found["compiler"].get<std::string>() + " " + found["flags"].get<std::string>());
    line("processor",
         fmt::format("{}, {} cores, {} threads used", found["processor"].get<std::string>(),
                     found["cores"].get<int>(), found["threads"].get<int>()));
    line("memory", fmt::format("{:.1f} GB", found["memory_gb"].get<double>()));
    for (const auto& [name, version] : found["libraries"].items()) line(name, version);
    for (const Json& tool : found["tools"]) {
        const std::string version = tool["version"];
        line(tool["name"].get<std::string>(),
             version.empty() ? fmt::format("missing; for {}: sudo apt install {}",
                                           tool["needed_for"].get<std::string>(),
                                           tool["package"].get<std::string>())
                             : version);
    }
    line("noise floor",
         fmt::format("{:.2g} % between medians of the same work ({} rounds of {} A and {} B in "
                     "turns), {:.2g} % spread of one run",
                     100.0 * found["noise"]["relative"].get<double>(),
                     found["noise"]["rounds"].get<int>(), found["noise"]["runs"].get<int>(),
                     found["noise"]["runs"].get<int>(),
                     100.0 * found["noise"]["spread"].get<double>()));
}

ExitCode doctor(const std::string& json) {
    const Json found = examine();
    if (!json.empty()) {
        write_json(document("doctor", found), json);
    }
    if (json != "-") print(found);
    for (const Json& tool : found["tools"])
        if (tool["required"] && tool["version"].get<std::string>().empty())
            return ExitCode::check_failed;
    return ExitCode::ok;
}

const RegisterCommand command{
    {"doctor", "the machine, the versions, what is missing, and the noise floor of times",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto json = std::make_shared<std::string>();
         line.add_option("--json", *json, "write it to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [json] { return doctor(*json); };
     }}};
}  // namespace
}  // namespace reports::doctor_command
