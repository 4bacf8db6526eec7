#include "reports/commands/kernel.h"

#include "reports/commands/checks.h"
#include "reports/commands/command.h"
#include "reports/json.h"
#include "solver/kernels/all_kernels.h"
#include "solver/kernels/anisotropic.h"
#include "verification/framework/any_kernel.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>

namespace reports {

namespace {
using plumbline::AllKernels;
using plumbline::InvalidInput;
using plumbline::Mat;
using plumbline::Vec;

void check_dimension(int dim) {
    if (dim < 1 || dim > 3)
        throw InvalidInput(fmt::format("--dim: expected 1, 2 or 3, found {}", dim));
}

/// Calls visit.operator()<Dim>() for a dimension known at run time.
template <class Visit> auto in_dimension(int dim, Visit visit) {
    check_dimension(dim);
    if (dim == 1) return visit.template operator()<1>();
    if (dim == 2) return visit.template operator()<2>();
    return visit.template operator()<3>();
}

struct Options {
    std::string name, at, map, json;
    int dim = 2;
    double support = 1.0;
    bool list = false;
};

/// 101 radii from the centre to the rim, both included.
std::vector<double> equidistant(double support) {
    std::vector<double> radii;
    for (int k = 0; k <= 100; ++k) radii.push_back(k / 100.0 * support);
    return radii;
}

void print_names(const Options& options) {
    const auto names =
        in_dimension(options.dim, []<int Dim>() { return AllKernels::names<Dim>(); });
    if (!options.json.empty())
        write_json(document("kernels", {{"dim", options.dim}, {"names", names}}), options.json);
    if (options.json != "-")
        for (const std::string_view name : names) fmt::print("{}\n", name);
}

Json json_of(const Options& options, const std::vector<KernelRow>& rows) {
    Json table = Json::array();
    for (const KernelRow& row : rows)
        table.push_back({{"r", number(row.r)},
                         {"value", number(row.value)},
                         {"derivative", number(row.derivative)},
                         {"second_derivative", number(row.second_derivative)},
                         {"laplacian", number(row.laplacian)}});
    return {{"name", options.name},
            {"dim", options.dim},
            {"support", options.support},
            {"rows", std::move(table)}};
}

Json json_of(const Options& options, const std::vector<AnisotropicRow>& rows) {
    Json table = Json::array();
    for (const AnisotropicRow& row : rows) {
        Json gradient = Json::array();
        for (const double component : row.gradient) gradient.push_back(number(component));
        table.push_back({{"x", row.x},
                         {"value", number(row.value)},
                         {"gradient", std::move(gradient)},
                         {"laplacian", number(row.laplacian)}});
    }
    return {{"name", options.name},
            {"dim", options.dim},
            {"support", options.support},
            {"map", numbers_of(options.map, "--map")},
            {"rows", std::move(table)}};
}

void write_csv(int dim, const std::vector<AnisotropicRow>& rows) {
    fmt::print("{}",
               dim == 2 ? "x,y,value,d_x,d_y,laplacian\n" : "x,y,z,value,d_x,d_y,d_z,laplacian\n");
    for (const AnisotropicRow& row : rows) {
        for (const double x : row.x) fmt::print("{:.17g},", x);
        fmt::print("{:.17g},", row.value);
        for (const double component : row.gradient) fmt::print("{:.17g},", component);
        fmt::print("{:.17g}\n", row.laplacian);
    }
}

ExitCode run_anisotropic(const Options& options) {
    if (options.at.empty())
        throw InvalidInput("--map: expected points --at x1,y1[,z1],... beside it, found none");
    const auto rows = anisotropic_table(options.name, options.dim, options.support,
                                        numbers_of(options.map, "--map"), numbers_of(options.at));
    if (!options.json.empty()) write_json(document("kernel", json_of(options, rows)), options.json);
    if (options.json != "-") write_csv(options.dim, rows);
    return ExitCode::ok;
}

ExitCode run(const Options& options) {
    if (options.list) {
        print_names(options);
        return ExitCode::ok;
    }
    if (options.name.empty())
        throw InvalidInput("kernel: expected the name of a kernel; --list shows them");
    if (!options.map.empty()) return run_anisotropic(options);
    const auto radii = options.at.empty() ? equidistant(options.support) : numbers_of(options.at);
    const auto rows = kernel_table(options.name, options.dim, options.support, radii);
    if (!options.json.empty()) write_json(document("kernel", json_of(options, rows)), options.json);
    if (options.json == "-") return ExitCode::ok;
    fmt::print("r,value,derivative,second_derivative,laplacian\n");
    for (const KernelRow& row : rows)
        fmt::print("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", row.r, row.value, row.derivative,
                   row.second_derivative, row.laplacian);
    return ExitCode::ok;
}

const RegisterCommand command{
    {"kernel", "values and derivatives of a kernel, as CSV with 17 digits",
     [](CommandLine& line) -> std::function<ExitCode()> {
         const auto options = std::make_shared<Options>();
         line.add_option("name", options->name, "name of the kernel");
         line.add_option("--dim", options->dim, "dimension: 1, 2 or 3").show_default();
         line.add_option("--support", options->support, "radius beyond which the kernel is 0 [m]")
             .show_default();
         line.add_option("--at", options->at,
                         "radii r1,r2,... [m]; default: 101 from 0 to the support");
         line.add_option("--map", options->map,
                         "the numbers of a matrix G, row by row: |det G| w(|G x|) at the points "
                         "x1,y1[,z1],... of --at");
         line.add_flag("--list", options->list, "the names of the kernels of that dimension");
         line.add_option("--json", options->json, "write it to this file, - for stdout")
             .alone_means("-")
             .check(output_file());
         return [options] { return run(*options); };
     }}};
}  // namespace

std::vector<KernelRow> kernel_table(std::string_view name, int dim, double support,
                                    const std::vector<double>& radii) {
    std::vector<KernelRow> rows;
    in_dimension(dim, [&]<int Dim>() {
        AllKernels::with<Dim>(name, support, [&](const auto& w) {
            for (const double r : radii) {
                if (!(r >= 0.0))
                    throw InvalidInput(fmt::format("--at: expected radii r >= 0, found {}", r));
                // + 0.0 makes a plain zero of a negative one.
                rows.push_back({r, w.value(r) + 0.0, w.derivative(r) + 0.0,
                                w.second_derivative(r) + 0.0, laplacian(w, r) + 0.0});
            }
        });
    });
    return rows;
}

namespace {
template <int Dim>
std::vector<AnisotropicRow> seen_through(const Mat<Dim>& map, std::string_view name, double support,
                                         const std::vector<double>& points) {
    std::vector<AnisotropicRow> rows;
    AllKernels::with<Dim>(name, support, [&](const auto& kernel) {
        const plumbline::Anisotropic w(verification::AnyKernel<Dim>(kernel), map);
        for (std::size_t i = 0; i < points.size(); i += Dim) {
            const Vec<Dim> x(&points[i]), gradient = w.gradient(x);
            rows.push_back({{x.data(), x.data() + Dim},
                            w.value(x),
                            {gradient.data(), gradient.data() + Dim},
                            w.laplacian(x)});
        }
    });
    return rows;
}
}  // namespace

std::vector<AnisotropicRow> anisotropic_table(std::string_view name, int dim, double support,
                                              const std::vector<double>& map,
                                              const std::vector<double>& points) {
    if (dim < 2 || dim > 3)
        throw InvalidInput(fmt::format("--map: expected a dimension of 2 or 3, found {}", dim));
    const auto n = static_cast<std::size_t>(dim);
    if (map.size() != n * n)
        throw InvalidInput(fmt::format("--map: expected {} numbers, found {}", n * n, map.size()));
    if (points.size() % n != 0)
        throw InvalidInput(fmt::format("--at: expected {} numbers for each point, found {} in all",
                                       n, points.size()));
    for (const double x : points)
        if (!std::isfinite(x))
            throw InvalidInput(fmt::format("--at: expected finite coordinates, found {}", x));
    if (dim == 2) return seen_through<2>(Mat<2>(map.data()).transpose(), name, support, points);
    return seen_through<3>(Mat<3>(map.data()).transpose(), name, support, points);
}

std::vector<double> numbers_of(std::string_view list, std::string_view option) {
    std::vector<double> numbers;
    std::size_t start = 0;
    while (start <= list.size()) {
        const std::size_t end = std::min(list.find(',', start), list.size());
        const std::string_view item = list.substr(start, end - start);
        start = end + 1;
        double number = 0.0;
        const auto [rest, error] = std::from_chars(item.data(), item.data() + item.size(), number);
        if (error != std::errc{} || rest != item.data() + item.size())
            throw InvalidInput(
                fmt::format("{}: expected numbers r1,r2,..., found \"{}\" as number {}", option,
                            item, numbers.size() + 1));
        numbers.push_back(number);
    }
    return numbers;
}

}  // namespace reports
