#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/fluid_frontier_report.h"
#include "reports/frontier_report.h"
#include "reports/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace reports::frontier_command {
namespace {
using benchmarks::Candidate;
using benchmarks::Frontier;

struct Options {
    std::vector<std::string> tasks{"approximation", "gradient", "taylor_green", "hydrostatic",
                                   "dam_break"};
    std::vector<int> dims{2, 3};
    std::string json, directory;
    bool quick = false;
};

void print_row(const Candidate& c) {
    fmt::print(
        "{:<12} {:<14} {:>8.1f} {:>8} {:>10.1f} {:>10.2e} {:>10.2e} {:>12.3e} {:>12.3e} {:<10}\n",
        c.method, c.kernel, c.support_in_spacings, c.samples_per_metre, c.mean_neighbours, c.error,
        c.largest_error, c.per_place_s(), c.per_field_s(), name_of(c.trend));
}

std::string in_words(const benchmarks::RatioRange& r) {
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", r.median, r.lowest, r.highest);
}

void print_ratios(const Frontier& frontier) {
    fmt::print("as efficient as SPH once the shape functions are computed (adams2009 Sec. 3.1)?\n");
    fmt::print("{:<12} {:>19} {:>19} {:>15} {:>16} {:>16}  {}\n", "method", "over SPH, computed",
               "over SPH sums,", "computing once,", "paid back, over", "over SPH sums,",
               "like with like");
    fmt::print("{:<12} {:>19} {:>19} {:>15} {:>16} {:>16}\n", "", "once, too", "anew",
               "in SPH sums", "itself anew, after", "anew, after");
    for (const benchmarks::PrecomputedRatio& r : frontier.precomputed)
        fmt::print("{:<12} {:>19} {:>19} {:>15.1f} {:>16} {:>16}  {}\n", r.method,
                   in_words(r.over_precomputed_sph), in_words(r.over_sph_sum),
                   r.precomputation_in_sums, evaluations(r.pays_over_itself),
                   evaluations(r.pays_over_sph), r.verdict);
    fmt::print(
        "medians over kernels, h/dx and numbers of samples, with the lowest and the highest; "
        "paid back after so many evaluations\n\n");
}

void print(const Frontier& frontier) {
    fmt::print("{} in {}D: {}\n\n", task_of(frontier.quantity), frontier.dim, frontier.finding);
    fmt::print("{:<12} {:<14} {:>8} {:>8} {:>10} {:>10} {:>10} {:>12} {:>12} {:<10}\n",
               "Pareto front", "kernel", "h/dx", "1/dx", "neighbours", "error", "largest",
               "s per place", "s per field", "trend");
    for (const std::size_t k :
         benchmarks::pareto_front(frontier.candidates, &Candidate::per_field_s))
        print_row(frontier.candidates[k]);
    const auto failed =
        std::ranges::count_if(frontier.candidates, [](const Candidate& c) { return c.failed(); });
    fmt::print("\n{} of {} combinations failed; A/A noise {:.1f} %\n\n", failed,
               frontier.candidates.size(), 100.0 * frontier.noise);
    print_ratios(frontier);
}

void write_files(const Frontier& frontier, const std::filesystem::path& folder) {
    for (const NamedChart& named : charts_of(frontier)) {
        const DrawnChart files = draw(named.chart, folder, named.name);
        fmt::print(stderr, "wrote {}\n", files.svg.string());
    }
    const std::filesystem::path table = folder / ("frontier_" + name_of(frontier) + ".csv");
    write_file(table, candidates_csv(json_of(frontier)));
    fmt::print(stderr, "wrote {}\n", table.string());
}

void print(const benchmarks::FluidFrontier& frontier) {
    fmt::print("{}: {}\n\n", frontier.task, frontier.finding);
    fmt::print("{:<20} {:<14} {:>10} {:>6} {:>6} {:>8} {:>10} {:>9} {}\n", "method", "kernel",
               "resolution", "h/dx", "sound", "courant", "error", "s", "");
    for (const benchmarks::FluidCandidate& c : frontier.candidates)
        fmt::print("{:<20} {:<14} {:>10} {:>6.1f} {:>6.0f} {:>8.2f} {:>10} {:>9.3f} {}\n", c.method,
                   c.kernel, c.resolution, c.support_in_spacings, c.sound, c.courant,
                   c.error < HUGE_VAL ? fmt::format("{:.2e}", c.error) : "none", c.seconds,
                   c.on_front ? "on the front" : c.failure);
    fmt::print("\n");
}

void write_files(const benchmarks::FluidFrontier& frontier, const std::filesystem::path& folder) {
    const std::string name = "frontier_" + frontier.task;
    const DrawnChart files = draw(chart_of(frontier), folder, name);
    const std::filesystem::path table = folder / (name + "_runs.csv");
    write_file(table, csv_of(frontier));
    fmt::print(stderr, "wrote {}\nwrote {}\n", files.svg.string(), table.string());
}

bool is_fluid(const std::string& task) {
    return std::ranges::count(benchmarks::fluid_tasks(), task) > 0;
}

ExitCode frontier(const Options& options) {
    using verification::Effort;
    for (const std::string& task : options.tasks)  // before the first takes minutes
        if (!is_fluid(task)) quantity_of(task);
    Json results = Json::array();
    const Effort effort = options.quick ? Effort::quick : Effort::full;
    const auto add = [&](const auto& measured) {
        results.push_back(json_of(measured));
        if (options.json != "-") print(measured);
        if (!options.directory.empty()) write_files(measured, options.directory);
    };
    for (const std::string& task : options.tasks) {
        if (is_fluid(task)) {
            add(benchmarks::measure_fluids(task, effort, [] { stop_if_interrupted(); }));
            continue;
        }
        for (const int dim : options.dims)
            add(benchmarks::measure_frontier(quantity_of(task), dim, effort,
                                             [](double) { stop_if_interrupted(); }));
    }
    if (!options.json.empty()) write_json(document("frontiers", std::move(results)), options.json);
    return ExitCode::ok;
}

const RegisterCommand command{
    {"frontier", "error against time of every method for a task, and the Pareto front",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("task", options->tasks,
                         "approximation, gradient, laplacian; fluids: taylor_green, "
                         "hydrostatic, dam_break")
             .show_default();
         line.add_option("--dim", options->dims, "2, 3, or both; fluids are in 2D")
             .separated_by_commas()
             .check(one_of<int>({2, 3}))
             .show_default();
         line.add_flag("--quick", options->quick, "fewer supports, samples and repetitions");
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         line.add_option("-o,--output", options->directory,
                         "draw charts into this folder, and write the table of all methods")
             .check(output_folder());
         return [options] { return frontier(*options); };
     }}};
}  // namespace
}  // namespace reports::frontier_command
