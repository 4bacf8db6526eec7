#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "solver/io/csv.h"
#include "solver/io/read_mesh.h"
#include "solver/particles/closed_mesh.h"
#include "solver/particles/samplings.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>

namespace reports::sample_command {
namespace {
using namespace plumbline;

struct Options {
    std::string name, mesh, json;
    int dim = 2;
    std::uint32_t count = 1000, seed = 1;
};

/// So many points in the box of the mesh that about `count` of them are inside.
Points<3> in_mesh(const Sampling<3>& sampling, const Options& options) {
    const ClosedMesh mesh(read_mesh(options.mesh));
    const Box<3> box = mesh.bounds();
    const double in_box = options.count * box.volume() / mesh.volume();
    constexpr double most = 1e8;
    if (!(in_box <= most))
        throw InvalidInput(
            fmt::format("--count: expected at most {:g} points in the box of {}, "
                        "found {:.3g}",
                        most, options.mesh, in_box));
    return inside(mesh, sampling.fill(box, static_cast<Index>(std::lround(in_box)), options.seed));
}

template <int Dim> Points<Dim> points_of(const Options& options) {
    const Sampling<Dim>& chosen = sampling<Dim>(options.name);
    if constexpr (Dim == 3)
        if (!options.mesh.empty()) return in_mesh(chosen, options);
    return chosen.fill(unit_box<Dim>(), options.count, options.seed);
}

template <int Dim> void write_csv(const Points<Dim>& points) {
    const std::vector<std::string> axes{"x", "y", "z"};
    CsvWriter csv(std::cout, {axes.begin(), axes.begin() + Dim});
    for (const Vec<Dim>& x : points) {
        for (int d = 0; d < Dim; ++d) csv.add(x[d]);
        csv.end_row();
    }
}

template <int Dim> Json json_of(const Options& options, const Points<Dim>& points) {
    Json rows = Json::array();
    for (const Vec<Dim>& x : points) rows.push_back(std::vector<double>(x.data(), x.data() + Dim));
    return {{"sampling", options.name},
            {"dim", Dim},
            {"inside", options.mesh.empty() ? Json() : Json(options.mesh)},
            {"seed", options.seed},
            {"points", std::move(rows)}};
}

template <int Dim> ExitCode sample_in(const Options& options) {
    const Points<Dim> points = points_of<Dim>(options);
    if (!options.json.empty())
        write_json(document("sample", json_of<Dim>(options, points)), options.json);
    if (options.json != "-") write_csv<Dim>(points);
    fmt::print(stderr, "{} points\n", points.size());
    return points.empty() ? ExitCode::inconclusive : ExitCode::ok;
}

ExitCode sample(const Options& options) {
    if (!options.mesh.empty() && options.dim != 3)
        throw InvalidInput(
            fmt::format("--inside: expected --dim 3 beside it, found {}", options.dim));
    return options.dim == 2 ? sample_in<2>(options) : sample_in<3>(options);
}

const RegisterCommand command{
    {"sample", "points of a sampling as CSV, in the unit square or cube, or inside a closed mesh",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("name", options->name, "see plumbline list samplings").required();
         line.add_option("--dim", options->dim, "dimension: 2 or 3")
             .check(between(2, 3))
             .show_default();
         line.add_option("--count", options->count, "about so many points")
             .check(between(1u, 100000000u))
             .show_default();
         line.add_option("--seed", options->seed, "of what is random").show_default();
         line.add_option("--inside", options->mesh,
                         "a closed surface: OBJ, OFF, PLY or STL; its own box is then filled");
         line.add_option("--json", options->json, "write the points to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return sample(*options); };
     }}};
}  // namespace
}  // namespace reports::sample_command
