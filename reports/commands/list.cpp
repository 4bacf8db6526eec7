#include "benchmarks/approximation/frontier.h"
#include "benchmarks/neighbours/contestants.h"
#include "benchmarks/scenes/fluid_frontier.h"
#include "reports/approximation/point_values.h"
#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/frontier_report.h"
#include "reports/json.h"
#include "reports/scenes.h"
#include "solver/kernels/all_kernels.h"
#include "solver/neighbours/brute_force.h"
#include "solver/particles/samplings.h"
#include "verification/framework/registry.h"
#include "verification/framework/traceability.h"
#include "verification/framework/validation.h"
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

/// Names and what was added to each, in the order in which they came first.
struct Notes {
    std::vector<std::pair<std::string, std::string>> entries;

    void add(const std::string& name, const std::string& note) {
        for (auto& [known, notes] : entries)
            if (known == name) {
                notes += " " + note;
                return;
            }
        entries.emplace_back(name, note);
    }
};

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

/// Adds, for each of 1, 2 and 3 dimensions, the names that of.operator()<Dim>() gives.
template <class Of> Notes with_dimensions(Of of) {
    Notes notes;
    for (const auto& name : of.template operator()<1>()) notes.add(name, "1D");
    for (const auto& name : of.template operator()<2>()) notes.add(name, "2D");
    for (const auto& name : of.template operator()<3>()) notes.add(name, "3D");
    return notes;
}

Json kernels() {
    const Notes kernels = with_dimensions([]<int Dim>() {
        const auto names = plumbline::AllKernels::names<Dim>();
        return std::vector<std::string>(names.begin(), names.end());
    });
    Json all = Json::array();
    for (const auto& [name, where] : kernels.entries)
        all.push_back(row(name, "solver/kernels", "kernel in " + where));
    all.push_back(
        row("anisotropic", "solver/kernels",
            "any of these in 2D or 3D, seen through a linear map G: kernel NAME --map G"));
    return all;
}

Json samplings() {
    std::map<std::string, std::string> says;
    const Notes samplings = with_dimensions([&]<int Dim>() {
        std::vector<std::string> names;
        for (const auto& s : plumbline::samplings<Dim>()) {
            names.emplace_back(s.name);
            says[names.back()] = s.says;
        }
        return names;
    });
    Json all = Json::array();
    for (const auto& [name, where] : samplings.entries)
        all.push_back(row(name, "solver/particles", fmt::format("{}, {}", where, says.at(name))));
    all.push_back(
        row("inside a closed mesh", "solver/particles",
            "any of those in 3D, kept where a mesh contains it: sample NAME --inside MESH"));
    return all;
}

Json methods() {
    Json all = Json::array();
    for (const NamedMethod& m : reports::methods())
        all.push_back(row(m.name, m.source, "approximate: " + m.says));
    Notes compared;
    for (const auto quantity : {verification::Quantity::value, verification::Quantity::gradient,
                                verification::Quantity::laplacian})
        for (const std::string& name : benchmarks::methods_compared(quantity, 3))
            compared.add(name, task_of(quantity));
    for (const std::string& task : benchmarks::fluid_tasks())
        for (const std::string& name : benchmarks::fluid_methods(task)) compared.add(name, task);
    for (const auto& [name, tasks] : compared.entries)
        all.push_back(row(name, "benchmarks", "frontier " + tasks));
    return all;
}

Json searches() {
    using namespace benchmarks;
    Json all = Json::array();
    all.push_back(row(std::string(plumbline::BruteForce<3>::name), "solver/neighbours",
                      "all pairs; what the others are checked against"));
    const auto add = [&](const auto& makers, const char* where, const char* what) {
        for (const auto& maker : makers)
            all.push_back(row(maker.name, where, what + maker.make()->form()));
    };
    add(our_contestants<3>(), "solver/neighbours", "2D, 3D; ");
    add(library_contestants<3>(), "benchmarks/neighbours", "2D, 3D, a rival library; ");
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
                          {"validations", [] { return described(verification::validations()); }},
                          {"errata", errata},
                          {"statements", statements},
                          {"methods", methods},
                          {"searches", searches},
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
            fmt::print("{:<11} {:<60} {:<30} {}\n", kind, r["id"].get<std::string>(),
                       r["source"].get<std::string>(), r["says"].get<std::string>());
    return ExitCode::ok;
}

const RegisterCommand command{
    {"list",
     "what there is: claims, studies, maps, validations, errata, statements, methods, searches, "
     "kernels, samplings, scenes",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         std::vector<std::string> names;
         for (const Kind& kind : kinds) names.emplace_back(kind.name);
         line.add_option("kind", options->kind, "only this kind").check(one_of(names));
         line.add_option("--json", options->json, "write it to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return list(*options); };
     }}};
}  // namespace
}  // namespace reports::list_command
