#include "reports/commands/command.h"

#include "verification/framework/registry.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace reports {
namespace {
using nlohmann::ordered_json;

template <class Entries> ordered_json described(const Entries& entries) {
    ordered_json all = ordered_json::array();
    for (const auto& e : entries)
        all.push_back({{"id", e.id},
                       {"source", fmt::format("{} {}", name_of(e.source.paper), e.source.place)},
                       {"says", e.says}});
    return all;
}

ordered_json listing(const std::string& kind) {
    if (kind == "claims") return described(verification::claims());
    return described(verification::studies());
}

struct Options {
    std::string kind;
    bool json = false;
};

ExitCode list(const Options& options) {
    ordered_json all;
    for (const std::string kind : {"claims", "studies"})
        if (options.kind.empty() || options.kind == kind) all[kind] = listing(kind);
    if (options.json) {
        fmt::print("{}\n", all.dump(1));
        return ExitCode::ok;
    }
    for (const auto& [kind, entries] : all.items())
        for (const auto& e : entries)
            fmt::print("{:<8} {:<56} {:<28} {}\n", kind, e["id"].get<std::string>(),
                       e["source"].get<std::string>(), e["says"].get<std::string>());
    return ExitCode::ok;
}

const RegisterCommand command{
    {"list", "what there is: claims, studies", [](CLI::App& app) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         app.add_option("kind", options->kind, "only this kind")
             ->check(CLI::IsMember({"claims", "studies"}));
         app.add_flag("--json", options->json, "as JSON");
         return [options] { return list(*options); };
     }}};
}  // namespace
}  // namespace reports
