#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/interrupt.h"
#include "reports/neighbours_report.h"
#include "solver/foundation/parallel.h"
#include "solver/io/read_points.h"
#include "solver/neighbours/queries.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace reports {
namespace {
using namespace plumbline;
using benchmarks::CaseResult;
using benchmarks::PointCloud;

struct Options {
    std::string points, cloud = "jittered", json, directory;
    int dim = 3, repeats = 9;
    std::vector<Index> counts;
    std::vector<std::string> searches;
    std::optional<double> radius;  // [unit of the points]
    bool quick = false;
};

constexpr std::size_t usual_neighbours = 30;

template <int Dim> PointCloud<Dim> read_cloud(const Options& options, const PointFile& file) {
    PointCloud<Dim> cloud{std::filesystem::path(options.points).stem().string(),
                          file.points_as<Dim>(), 0.0};
    cloud.radius = options.radius
                       ? *options.radius
                       : benchmarks::radius_with_neighbours(cloud.points, usual_neighbours);
    return cloud;
}

benchmarks::ComparisonOptions how(const Options& options) {
    benchmarks::ComparisonOptions how;
    if (!options.searches.empty()) how.searches = options.searches;
    how.repeats = options.quick ? std::min(options.repeats, 5) : options.repeats;
    how.progress = [](const std::string&) { stop_if_interrupted(); };
    return how;
}

template <int Dim> std::vector<CaseResult> compare_clouds(const Options& options) {
    std::vector<CaseResult> cases;
    for (const Index count : options.counts) {
        PointCloud<Dim> cloud = benchmarks::make_cloud<Dim>(options.cloud, count);
        if (options.radius) cloud.radius = *options.radius;
        cases.push_back(compare(cloud, how(options)));
    }
    return cases;
}

std::vector<CaseResult> measure(Options options) {
    if (!options.points.empty()) {
        const PointFile file = read_points(options.points);
        if (file.dim == 2) return {compare(read_cloud<2>(options, file), how(options))};
        return {compare(read_cloud<3>(options, file), how(options))};
    }
    if (options.counts.empty())
        options.counts = options.quick ? std::vector<Index>{1000, 10000}
                                       : std::vector<Index>{1000, 10000, 100000, 1000000};
    return options.dim == 2 ? compare_clouds<2>(options) : compare_clouds<3>(options);
}

std::string command_line(const Options& options) {
    std::string text = "plumbline neighbours";
    if (!options.points.empty())
        text += fmt::format(" --points {}", options.points);
    else
        text += fmt::format(" --cloud {} --dim {}", options.cloud, options.dim);
    for (const Index count : options.counts) text += fmt::format(" --count {}", count);
    if (options.radius) text += fmt::format(" --radius {:.17g}", *options.radius);
    for (const std::string& search : options.searches) text += fmt::format(" --search {}", search);
    return text + fmt::format(" --repeats {}{} --threads {}", options.repeats,
                              options.quick ? " --quick" : "", thread_count());
}

void print(const CaseResult& c) {
    const double per_point = 1e9 / static_cast<double>(c.count);
    fmt::print(
        "{} {}D, {} points, radius {:.4g}, {:.1f} neighbours, {} thread{}; A/A noise {:.1f} %\n",
        c.cloud, c.dim, c.count, c.radius, c.mean_neighbours, c.threads, c.threads == 1 ? "" : "s",
        100.0 * c.noise);
    fmt::print(
        "agreement: first search with brute force on {} of {} rows, the others with it on all\n",
        c.brute_force_rows, c.count);
    fmt::print("{:<14} {:>10} {:>8} {:>10} {:>8} {:>10} {:>10} {:>10} {:>16}\n", "ns per point",
               "build", "±", "query", "±", "total", "cold", "B/point", "of the fastest");
    for (const benchmarks::SearchResult& s : c.searches) {
        if (!s.agrees()) {
            fmt::print("{:<14} {} wrong pairs: not timed\n", s.name, s.wrong_pairs);
            continue;
        }
        fmt::print(
            "{:<14} {:>10.1f} {:>8.1f} {:>10.1f} {:>8.1f} {:>10.1f} {:>10.1f} {:>10.1f} {:>8.2f} ± "
            "{:<5.2f}\n",
            s.name, s.build.median_s * per_point, s.build.mad_s * per_point,
            s.query.median_s * per_point, s.query.mad_s * per_point, s.total.median_s * per_point,
            (s.cold_build_s + s.cold_query_s) * per_point,
            static_cast<double>(s.memory) / static_cast<double>(c.count), s.over_fastest,
            s.over_fastest_spread);
    }
    fmt::print("use {}\n\n", benchmarks::recommendation(c));
}

void print(const NeighbourComparison& comparison) {
    for (const CaseResult& c : comparison.cases) print(c);
    const auto exponents = benchmarks::exponents(comparison.cases);
    if (exponents.empty()) return;
    fmt::print("{:<14} {:>10} {:>10}   time ~ points^exponent; n log n is about 1.1\n", "exponents",
               "build", "query");
    for (const auto& e : exponents)
        fmt::print("{:<14} {:>10.2f} {:>10.2f}\n", e.search, e.build, e.query);
}

ExitCode neighbours(const Options& options) {
    if (options.radius) check_radius(OpenSpace<3>{}, *options.radius);
    const NeighbourComparison comparison{measure(options), command_line(options)};
    if (options.json != "-") print(comparison);
    if (!options.directory.empty()) {
        for (const NamedChart& named : charts_of(comparison))
            fmt::print(stderr, "wrote {}\n",
                       draw(named.chart, options.directory, named.name).svg.string());
        const auto table = std::filesystem::path(options.directory) / "neighbours.csv";
        write_file(table, csv_of(comparison));
        fmt::print(stderr, "wrote {}\n", table.string());
    }
    if (!options.json.empty())
        write_json(document("neighbours", json_of(comparison)), options.json);
    const bool agree = std::ranges::all_of(comparison.cases, &CaseResult::all_agree);
    return agree ? ExitCode::ok : ExitCode::check_failed;
}

const RegisterCommand command{
    {"neighbours", "neighbour searches: agreement first, then build and query time and memory",
     [](CLI::App& app) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         const auto points =
             app.add_option("--points", options->points, "a file of points: CSV, XYZ, PLY, VTP");
         app.add_option("--cloud", options->cloud, "points made by us")
             ->check(CLI::IsMember(benchmarks::cloud_names()))
             ->capture_default_str()
             ->excludes(points);
         app.add_option("--dim", options->dim, "of the cloud")
             ->check(CLI::Range(2, 3))
             ->capture_default_str()
             ->excludes(points);
         app.add_option("--count", options->counts, "numbers of points (1000 to 1000000)")
             ->check(CLI::Range(2u, 100000000u))
             ->excludes(points);
         app.add_option("--radius", options->radius, "in the unit of the points (30 neighbours)");
         app.add_option("--search", options->searches, "only these")
             ->check(CLI::IsMember(benchmarks::contestant_names()));
         app.add_option("--repeats", options->repeats, "interleaved rounds")
             ->check(CLI::Range(1, 1000))
             ->capture_default_str();
         app.add_flag("--quick", options->quick, "fewer points and rounds");
         app.add_option("--json", options->json, "write the results to this file, - for stdout")
             ->expected(0, 1)
             ->default_str("-");
         app.add_option("-o,--output", options->directory,
                        "draw charts and write tables into this folder");
         return [options] { return neighbours(*options); };
     }}};
}  // namespace
}  // namespace reports
