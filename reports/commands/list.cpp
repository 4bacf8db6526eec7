#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/json.h"
#include "reports/scenes.h"
#include "solver/kernels/all_kernels.h"
#include "solver/particles/samplings.h"
#include "verification/framework/registry.h"
#include "verification/framework/traceability.h"
#include "verification/stability/map.h"

#include <fmt/format.h>

#include <map>
#include <memory>

namespace reports::list_command {
namespace {
Json row(const std::string& id, const std::string& source, const std::string& says) {
    return {{"id", id}, {"source", source}, {"says", says}};
}

std::string text_of(const verification::Source& source) {
    return fmt::format("{} {}", name_of(source.paper), source.place);
}

template <class Entries> Json described(const Entries& entries) {
    Json all = Json::array();
    for (const auto& e : entries) all.push_back(row(e.id, text_of(e.source), e.says));
    return all;
}

Json errata() {
    Json all = Json::array();
    for (const verification::Erratum& e : verification::errata())
        all.push_back(row(fmt::format("{}", e.number), text_of(e.source),
                          fmt::format("printed: {}; corrected: {}", e.printed, e.corrected)));
    return all;
}

Json statements() {
    Json all = Json::array();
    for (const verification::Statement& s : verification::statements())
        all.push_back(row(std::string(s.item), std::string(name_of(s.paper)), std::string(s.says)));
    return all;
}

Json kernels() {
    std::map<std::string_view, std::string> dimensions;
    const auto add = [&](const auto& names, const char* dimension) {
        for (const std::string_view name : names) dimensions[name] += dimension;
    };
    add(plumbline::AllKernels::names<1>(), " 1D");
    add(plumbline::AllKernels::names<2>(), " 2D");
    add(plumbline::AllKernels::names<3>(), " 3D");
    Json all = Json::array();
    for (const auto& [name, where] : dimensions)
        all.push_back(row(std::string(name), "solver/kernels", "kernel in" + where));
    return all;
}

Json samplings() {
    Json all = Json::array();
    for (const auto& s : plumbline::samplings<3>())
        all.push_back(row(std::string(s.name), "solver/particles", std::string(s.says)));
    return all;
}

Json scenes() {
    Json all = Json::array();
    for (const ExampleScene& s : example_scenes()) {
        all.push_back(row(s.name, "reports/scenes", s.title));
        all.back()["text"] = read_file(s.file);
    }
    return all;
}

struct Kind {
    const char* name;
    Json (*list)();
};
constexpr Kind kinds[] = {{"claims", [] { return described(verification::claims()); }},
                          {"studies", [] { return described(verification::studies()); }},
                          {"maps", [] { return described(verification::maps()); }},
                          {"errata", errata},
                          {"statements", statements},
                          {"kernels", kernels},
                          {"samplings", samplings},
                          {"scenes", scenes}};

struct Options {
    std::string kind, json;
};

ExitCode list(const Options& options) {
    Json all = Json::object();
    for (const Kind& kind : kinds)
        if (options.kind.empty() || options.kind == kind.name) all[kind.name] = kind.list();
    if (!options.json.empty()) write_json(document("list", all), options.json);
    if (options.json == "-") return ExitCode::ok;
    for (const auto& [kind, rows] : all.items())
        for (const Json& r : rows)
            fmt::print("{:<10} {:<60} {:<30} {}\n", kind, r["id"].get<std::string>(),
                       r["source"].get<std::string>(), r["says"].get<std::string>());
    return ExitCode::ok;
}

const RegisterCommand command{
    {"list", "what there is: claims, studies, maps, errata, statements, kernels, samplings, scenes",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         std::vector<std::string> names;
         for (const Kind& kind : kinds) names.emplace_back(kind.name);
         line.add_option("kind", options->kind, "only this kind").check(one_of(names));
         line.add_option("--json", options->json, "write it to this file, - for stdout")
             .alone_means("-");
         return [options] { return list(*options); };
     }}};
}  // namespace
}  // namespace reports::list_command
