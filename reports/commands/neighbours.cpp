#include "benchmarks/neighbours/particle_order.h"
#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/files.h"
#include "reports/interrupt.h"
#include "reports/neighbours_charts.h"
#include "reports/neighbours_plan.h"
#include "reports/neighbours_report.h"
#include "reports/neighbours_tables.h"
#include "reports/progress.h"
#include "reports/provenance.h"
#include "solver/io/read_points.h"
#include "solver/neighbours/queries.h"
#include "verification/framework/statistics.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

namespace reports::neighbours_command {
namespace {
using namespace plumbline;
using namespace benchmarks;

struct Options {
    NeighbourRequest request;
    std::string points, radii, json, directory;
    std::vector<std::string> searches, studies;
    int repeats = 0;
    bool quick = false;
};

Level level_of(const Options& options) { return options.quick ? Level::quick : Level::usual; }

ComparisonOptions how(const Options& options) {
    ComparisonOptions how = effort(level_of(options));
    if (!options.searches.empty()) how.searches = options.searches;
    if (options.repeats > 0) how.least = how.most = options.repeats;
    how.progress = [](const std::string&) { stop_if_interrupted(); };
    return how;
}

/// The radius of each point, from a column of its file.
std::vector<double> radii_of(const PointFile& file, const std::string& column) {
    const std::vector<double>& radii = file.column(column);
    for (std::size_t i = 0; i < radii.size(); ++i)
        if (!(radii[i] >= smallest_radius<double> && radii[i] <= largest_length<double>))
            throw InvalidInput(fmt::format(
                "--radii: expected a radius in [{:g}, {:g}] for each point, found {:g} (column "
                "\"{}\", "
                "point {})",
                smallest_radius<double>, largest_length<double>, radii[i], column, i + 1));
    return radii;
}

template <int Dim>
CaseResult measure_file(const Options& options, const PointFile& file, const SearchSituation& s) {
    PointCloud<Dim> cloud{std::filesystem::path(options.points).stem().string(),
                          file.points_as<Dim>(), 0.0};
    if (!options.radii.empty()) {
        cloud.radii = radii_of(file, options.radii);
        cloud.radius = verification::median(cloud.radii);
    } else {
        cloud.radius =
            s.radius ? *s.radius : radius_with_neighbours(cloud.points, usual_neighbours);
    }
    reorder(cloud, s.order);
    ComparisonOptions chosen = how(options);
    chosen.spacings = s.spacings;
    chosen.moved = s.moved;
    chosen.own_radii = s.own_radii;
    return compare(std::move(cloud), chosen);
}

std::vector<SearchStudy> studies_of(Options& options) {
    NeighbourRequest& request = options.request;
    if (!options.points.empty()) {
        if (request.orders.empty()) request.orders = {"as_given"};
        return plan(request);
    }
    const auto known = search_studies(level_of(options));
    if (options.studies.empty()) {
        if (request.counts.empty() && request.contrasts.size() < 2)
            for (const SearchSituation& s : known.front().situations)
                request.counts.push_back(s.cloud.count);
        return plan(request);
    }
    std::vector<SearchStudy> chosen;
    for (const SearchStudy& study : known)
        for (const std::string& name : options.studies)
            if (name == study.name || name == "all") chosen.push_back(study);
    return chosen;
}

NeighbourComparison measure(Options options) {
    const auto studies = studies_of(options);
    std::optional<PointFile> file;
    if (!options.points.empty()) file = read_points(options.points);
    std::size_t steps = 0;
    for (const SearchStudy& study : studies) steps += study.situations.size();
    Progress progress(steps);
    NeighbourComparison comparison{{}, provenance().command_line};
    for (const SearchStudy& study : studies) {
        SearchStudyResult result{study.name, study.question, {}};
        for (const SearchSituation& s : study.situations) {
            progress.step(file ? options.points : s.in_words());
            result.cases.push_back(!file            ? benchmarks::measure(s, how(options))
                                   : file->dim == 2 ? measure_file<2>(options, *file, s)
                                                    : measure_file<3>(options, *file, s));
        }
        comparison.studies.push_back(std::move(result));
    }
    return comparison;
}

void write_charts(const NeighbourComparison& comparison, const std::string& directory) {
    std::fflush(stdout);  // the tables come before what is told of files, also in one log
    std::map<std::string, int> studies;  // so far, by name
    for (const SearchStudyResult& study : comparison.studies) {
        const int number = ++studies[study.name];
        for (const NamedChart& named : charts_of(study, comparison.command)) {
            const std::string name =
                number == 1 ? named.name : fmt::format("{}_{}", named.name, number);
            fmt::print(stderr, "wrote {}\n", draw(named.chart, directory, name).svg.string());
        }
    }
    const auto table = std::filesystem::path(directory) / "neighbours.csv";
    write_file(table, csv_of(comparison));
    fmt::print(stderr, "wrote {}\n", table.string());
}

/// With the noise that `plumbline compare` needs: the median over the cases.
Json document_of(const NeighbourComparison& comparison) {
    Json json = document("neighbours", json_of(comparison));
    std::vector<double> noise;
    for (const SearchStudyResult& study : comparison.studies)
        for (const CaseResult& c : study.cases) noise.push_back(c.noise);
    std::ranges::sort(noise);
    if (!noise.empty()) json["noise"] = {{"relative", number(noise[noise.size() / 2])}};
    return json;
}

ExitCode neighbours(const Options& options) {
    const NeighbourComparison comparison = measure(options);
    if (options.json != "-")
        for (const SearchStudyResult& study : comparison.studies)
            fmt::print("{}", tables_of(study));
    if (!options.directory.empty()) write_charts(comparison, options.directory);
    if (!options.json.empty()) write_json(document_of(comparison), options.json);
    for (const SearchStudyResult& study : comparison.studies)
        if (!std::ranges::all_of(study.cases, &CaseResult::all_agree))
            return ExitCode::check_failed;
    return ExitCode::ok;
}

std::vector<std::string> study_names() {
    std::vector<std::string> names{"all"};
    for (const SearchStudy& study : search_studies(Level::quick)) names.push_back(study.name);
    return names;
}

void declare_points(CommandLine& line, Options& o) {
    const auto points = line.add_option("--points", o.points, "a file: CSV, XYZ, PLY, VTP");
    const auto cloud = line.add_option("--cloud", o.request.clouds, "points made by us")
                           .check(one_of(cloud_names()))
                           .excludes(points);
    const auto dim = line.add_option("--dim", o.request.dim, "of the clouds")
                         .check(between(2, 3))
                         .show_default()
                         .excludes(points);
    const auto count =
        line.add_option("--count", o.request.counts, "numbers of points (1000 to 1000000)")
            .check(between(1u, 100000000u))
            .excludes(points);
    const auto contrast =
        line.add_option("--contrast", o.request.contrasts, "density contrasts of the cloud (1000)")
            .excludes(points);
    const auto order = line.add_option("--order", o.request.orders,
                                       "of the points in memory (shuffled; of a file: as_given)")
                           .check(one_of(order_names()));
    const auto radius =
        line.add_option("--radius", o.request.radius, "in the unit of the points (30 neighbours)");
    const auto spacings = line.add_option("--spacings", o.request.spacings,
                                          "radii in units of half the usual radius (2)")
                              .excludes(radius);
    const auto moved = line.add_option("--moved", o.request.moved,
                                       "shares of the points that move before each update, 0 to 1");
    const auto own =
        line.add_flag("--own-radii", o.request.own_radii,
                      "each point asks with a radius of its own, for as many neighbours each");
    line.add_option("--radii", o.radii, "column of the file with the radius of each point (r)")
        .needs(points)
        .alone_means("r")
        .excludes(radius)
        .excludes(spacings)
        .excludes(own);
    const auto study = line.add_option("--study", o.studies, "what the page of `report` shows")
                           .check(one_of(study_names()));
    for (const Option option :
         {points, cloud, dim, count, contrast, order, radius, spacings, moved, own})
        study.excludes(option);
}

const RegisterCommand command{
    {"neighbours", "neighbour searches: agreement first, then time and memory of every phase",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         declare_points(line, *options);
         line.add_option("--search", options->searches, "only these")
             .check(one_of(contestant_names()));
         line.add_option(
                 "--repeats", options->repeats,
                 "interleaved rounds (9 to 49; quick: 6 to 25); below 6 nothing can be told")
             .check(between(1, 1000));
         line.add_flag("--quick", options->quick, "fewer points and rounds");
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         line.add_option("-o,--output", options->directory,
                         "draw charts and write tables into this folder")
             .check(output_folder());
         return [options] { return neighbours(*options); };
     }}};
}  // namespace
}  // namespace reports::neighbours_command
