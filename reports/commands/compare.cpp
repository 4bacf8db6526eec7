#include "reports/comparison.h"

#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/read_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace reports::compare_command {
namespace {
struct Options {
    std::string before, now, json;
    bool all = false;
};

std::size_t count(const std::vector<Change>& changes, Change::Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(changes, verdict, &Change::verdict));
}

ExitCode compare_files(const Options& options) {
    const auto changes = compare(read_json(options.before), read_json(options.now));
    if (!options.json.empty()) {
        Json rows = Json::array();
        for (const Change& c : changes) rows.push_back(json_of(c));
        write_json(document("changes", std::move(rows)), options.json);
    }
    if (options.json != "-")
        for (const Change& c : changes)
            if (c.verdict != Change::Verdict::same || options.all)
                fmt::print("{:<12} {:<60} {} -> {}  ({})\n", name_of(c.verdict), c.id, c.before,
                           c.now, c.why);
    using enum Change::Verdict;
    fmt::print(stderr, "{} worse, {} better, {} the same, {} cannot be told\n",
               count(changes, worse), count(changes, better), count(changes, same),
               count(changes, cannot_tell));
    if (count(changes, worse) > 0) return ExitCode::check_failed;
    return count(changes, cannot_tell) == changes.size() ? ExitCode::inconclusive : ExitCode::ok;
}

const RegisterCommand command{
    {"compare", "what became better or worse between two results in JSON",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("old", options->before,
                         "a result of verify, converge, neighbours, report …")
             .required();
         line.add_option("new", options->now, "a later one").required();
         line.add_flag("--all", options->all, "list what is the same, too");
         line.add_option("--json", options->json, "write the changes to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return compare_files(*options); };
     }}};
}  // namespace
}  // namespace reports::compare_command
