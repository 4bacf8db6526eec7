#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "reports/junit.h"
#include "reports/measurements.h"
#include "reports/select.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>

namespace reports::verify_command {
namespace {
using namespace verification;

struct Options {
    std::vector<std::string> patterns;
    std::string tag, json, junit;
    bool mutants = false;
    double seconds_per_claim = 120.0;
};

int badness(const ClaimResult& r) {
    switch (r.verdict) {
        case Verdict::failed:
            return 2;
        case Verdict::toothless:
            return 1;
        default:
            return 0;
    }
}

std::string short_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.2e}", value) : fmt::format("{}", value);
}

void print_table(std::vector<ClaimResult> results) {
    std::ranges::stable_sort(results, std::ranges::greater{}, badness);
    fmt::print("{:<10} {:<58} {:>9}  {:<22} {:>9}  {}\n", "verdict", "claim", "measured", "bound",
               "sabotaged", "source");
    for (const ClaimResult& r : results) {
        fmt::print("{:<10} {:<58} {:>9}  {:<22} {:>9}  {} {}\n", name_of(r.verdict), r.claim.id,
                   short_number(r.measured),
                   fmt::format("[{}, {}]", short_number(r.claim.bound.low),
                               short_number(r.claim.bound.high)),
                   r.sabotaged ? short_number(*r.sabotaged) : "-", name_of(r.claim.source.paper),
                   r.claim.source.place);
        if (badness(r) == 0) continue;
        fmt::print("           {}\n           bound: {}\n", r.claim.says, r.claim.bound.why);
        if (!r.error.empty()) fmt::print("           error: {}\n", r.error);
    }
}

void print_errata(const std::vector<ErratumResult>& all) {
    fmt::print("{:<8} {:<8} {:<24} {}\n", "erratum", "caught", "where", "by the twin of");
    for (const ErratumResult& m : all) {
        std::string by;
        for (const ClaimResult& r : m.claims) {
            if (!r.sabotaged || r.claim.bound.holds(*r.sabotaged)) continue;
            by += fmt::format("{}{} ({} -> {})", by.empty() ? "" : ", ", r.claim.id,
                              short_number(*r.sabotaged), short_number(r.measured));
        }
        fmt::print("{:<8} {:<8} {:<24} {}\n", m.erratum.number, m.caught() ? "yes" : "NO",
                   fmt::format("{} {}", name_of(m.erratum.source.paper), m.erratum.source.place),
                   by);
    }
}

/// The matrix: a line of the table per mutant, and below it both kinds of claims.
void print_mutants(const std::vector<MutantRow>& rows) {
    fmt::print("\n{:<8} {:<44} {:<28} {}\n", "erratum", "as printed", "in the place of",
               "caught by");
    for (const MutantRow& row : rows) {
        fmt::print("{:<8} {:<44} {:<28} {} of the {} claims on it\n", row.mutant->erratum,
                   row.mutant->printed, row.mutant->replaces, row.caught(), row.cells.size());
        for (const bool caught : {true, false}) {
            std::string ids;
            for (const MutantRow::Cell& cell : row.cells)
                if (cell.result.caught == caught) ids += " " + cell.claim;
            if (!ids.empty()) fmt::print("         {}{}\n", caught ? "caught:" : "passes:", ids);
        }
    }
}

std::string summary(const std::vector<ClaimResult>& results) {
    const auto count = [&](Verdict v) {
        return std::ranges::count(results, v, &ClaimResult::verdict);
    };
    double seconds = 0.0;
    for (const ClaimResult& r : results) seconds += r.seconds;
    return fmt::format("{} claims: {} verified, {} failed, {} toothless, in {:.1f} s\n",
                       results.size(), count(Verdict::verified), count(Verdict::failed),
                       count(Verdict::toothless), seconds);
}

ExitCode verify(const Options& options) {
    const auto selected = select(claims(), options.patterns, options.tag);
    if (selected.empty()) {
        fmt::print(stderr, "plumbline: no claim matches; `plumbline list claims` names them\n");
        return ExitCode::inconclusive;
    }
    const auto results = measure_all(selected, options.seconds_per_claim);
    auto printed_forms = errata_in(results);
    std::vector<MutantRow> matrix;
    if (options.mutants) matrix = measure_mutants(dependents(results), options.seconds_per_claim);
    if (selected.size() < claims().size()) {  // of a part, only what it is about
        std::erase_if(printed_forms, [](const ErratumResult& e) { return e.claims.empty(); });
        std::erase_if(matrix, [](const MutantRow& row) { return row.cells.empty(); });
    }
    if (!options.json.empty()) {
        Json json = document("claims", json_array(results));
        if (options.mutants) json["mutants"] = json_array(matrix);
        write_json(json, options.json);
    }
    if (!options.junit.empty()) {
        std::ofstream file(options.junit);
        file << junit_of(results);
        if (!file.flush()) throw std::runtime_error("cannot write " + options.junit);
    }
    if (options.json != "-") {
        if (options.mutants) {
            print_errata(printed_forms);
            print_mutants(matrix);
        } else {
            print_table(results);
        }
    }
    fmt::print(stderr, "{}", summary(results));
    const bool sound =
        std::ranges::all_of(results, [](const ClaimResult& r) { return passed(r.verdict); });
    const bool all_caught =
        !options.mutants || (std::ranges::all_of(printed_forms, &ErratumResult::caught) &&
                             std::ranges::all_of(matrix, &MutantRow::caught));
    return sound && all_caught ? ExitCode::ok : ExitCode::check_failed;
}

const RegisterCommand command{
    {"verify", "measure the claims and judge them: a table, the worst first",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("pattern", options->patterns,
                         "part of an id, or with the wildcards of a shell; all if none is given");
         line.add_option("--tag", options->tag, "only claims with this tag");
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         line.add_option("--junit", options->junit, "write the results as JUnit XML to this file")
             .check(output_file());
         line.add_flag("--mutants", options->mutants,
                       "each formula as printed in the place of its operator: which of the claims "
                       "on it catch it, and which do not; one that none catches fails");
         line.add_option("--time-limit", options->seconds_per_claim,
                         "seconds that one claim may take")
             .check(positive_number())
             .show_default();
         return [options] { return verify(*options); };
     }}};
}  // namespace
}  // namespace reports::verify_command
