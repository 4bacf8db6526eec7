#include "reports/approximation/point_values.h"
#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "solver/io/csv.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <memory>

namespace reports::approximate_command {
namespace {
using plumbline::PointFile;

struct Options {
    std::string samples, at, method, kernel, field = "f", mass, json;
    double support = 0.0;
};

constexpr const char* axes[] = {"x", "y", "z"};

std::span<const double> coordinates(const PointFile& points, std::size_t i) {
    const auto dim = static_cast<std::size_t>(points.dim);
    return std::span(points.coordinates).subspan(i * dim, dim);
}

void write_csv(const PointFile& at, const std::vector<PointValue>& values) {
    const auto dim = static_cast<std::size_t>(at.dim);
    const auto names = std::span(axes).first(dim);
    std::vector<std::string> header(names.begin(), names.end());
    header.push_back("value");
    for (const std::string axis : names) header.push_back("d_" + axis);
    header.insert(header.end(), {"laplacian", "status"});
    plumbline::CsvWriter csv(std::cout, header);
    const auto add = [&](const std::optional<double>& number) {
        if (number)
            csv.add(*number);
        else
            csv.add("");
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (const double c : coordinates(at, i)) csv.add(c);
        const PointValue& p = values[i];
        add(p.value);
        for (std::size_t d = 0; d < dim; ++d)
            add(p.gradient.empty() ? std::nullopt : std::optional(p.gradient[d]));
        add(p.laplacian);
        csv.add(p.status);
        csv.end_row();
    }
}

Json json_of(const Options& options, const PointFile& at, const std::vector<PointValue>& values) {
    const auto known = [](const std::optional<double>& x) { return x ? number(*x) : Json(); };
    Json points = Json::array();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const PointValue& p = values[i];
        const auto x = coordinates(at, i);
        points.push_back({{"x", std::vector<double>(x.begin(), x.end())},
                          {"value", known(p.value)},
                          {"gradient", p.gradient.empty() ? Json() : Json(p.gradient)},
                          {"laplacian", known(p.laplacian)},
                          {"status", p.status}});
    }
    return {{"method", options.method},
            {"kernel", options.kernel},
            {"support", options.support},
            {"points", std::move(points)}};
}

/// On stderr, how many points have less than the method promises.
void say_what_is_missing(const std::vector<PointValue>& values) {
    std::map<std::string, std::size_t> counts;
    for (const PointValue& p : values)
        if (p.status != "ok") ++counts[p.status];
    for (const auto& [status, count] : counts)
        fmt::print(stderr, "{} of {} points: {}\n", count, values.size(), status);
}

void require_column(const PointFile& points, const std::string& file, const std::string& name) {
    try {
        points.column(name);
    } catch (const plumbline::InvalidInput& e) {
        throw plumbline::InvalidInput(file + ": " + e.what());
    }
}

ExitCode run(const Options& options) {
    const Method method = parse_method(options.method);
    const PointFile samples = plumbline::read_points(options.samples);
    const PointFile at = plumbline::read_points(options.at);
    require_column(samples, options.samples, options.field);
    if (!options.mass.empty()) require_column(samples, options.samples, options.mass);
    std::optional<std::string> mass;
    if (!options.mass.empty())
        mass = options.mass;
    else if (samples.find("m"))
        mass = "m";
    const auto values =
        approximate({samples, at, options.field, mass, method, options.kernel, options.support});
    if (!options.json.empty())
        write_json(document("approximate", json_of(options, at, values)), options.json);
    if (options.json != "-") write_csv(at, values);
    say_what_is_missing(values);
    return ExitCode::ok;
}

const RegisterCommand command{
    {"approximate", "a field given at samples, its gradient and its Laplacian, at other points",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option(
                 "--samples", options->samples,
                 "points with the field in column f, masses in m (1 if left out): CSV, XYZ, "
                 "PLY or VTP")
             .required();
         line.add_option("--at", options->at, "the points to evaluate at").required();
         line.add_option("--method", options->method,
                         "sph, shepard, mls:N, mlsph:N (N = 0..3) or mueller (at samples only)")
             .required();
         line.add_option("--kernel", options->kernel, "name of the kernel").required();
         line.add_option("--support", options->support, "radius beyond which the kernel is zero")
             .required();
         line.add_option("--field", options->field, "column of the samples, if it is not f");
         line.add_option("--mass", options->mass, "column of the masses, if it is not m");
         line.add_option("--json", options->json, "write the results to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return run(*options); };
     }}};
}  // namespace
}  // namespace reports::approximate_command
