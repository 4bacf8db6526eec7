#include "reports/commands/kernel.h"

#include "reports/commands/command.h"
#include "reports/json.h"
#include "solver/kernels/all_kernels.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>

namespace reports {

namespace {
using plumbline::AllKernels;
using plumbline::InvalidInput;

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
    std::string name, at;
    int dim = 2;
    double support = 1.0;
    bool list = false, json = false;
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
    if (options.json)
        write_json({{"dim", options.dim}, {"kernels", names}}, "-");
    else
        for (const std::string_view name : names) fmt::print("{}\n", name);
}

void print_json(const Options& options, const std::vector<KernelRow>& rows) {
    Json table = Json::array();  // infinite values become null: JSON has none
    for (const KernelRow& row : rows)
        table.push_back({{"r", row.r},
                         {"value", row.value},
                         {"derivative", row.derivative},
                         {"second_derivative", row.second_derivative},
                         {"laplacian", row.laplacian}});
    write_json({{"kernel", options.name},
                {"dim", options.dim},
                {"support", options.support},
                {"rows", std::move(table)}},
               "-");
}

ExitCode run(const Options& options) {
    if (options.list) {
        print_names(options);
        return ExitCode::ok;
    }
    if (options.name.empty())
        throw InvalidInput("kernel: expected the name of a kernel; --list shows them");
    const auto radii = options.at.empty() ? equidistant(options.support) : numbers_of(options.at);
    const auto rows = kernel_table(options.name, options.dim, options.support, radii);
    if (options.json) {
        print_json(options, rows);
        return ExitCode::ok;
    }
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
         line.add_flag("--list", options->list, "the names of the kernels of that dimension");
         line.add_flag("--json", options->json, "as JSON");
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

std::vector<double> numbers_of(std::string_view list) {
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
                fmt::format("--at: expected numbers r1,r2,..., found \"{}\" as number {}", item,
                            numbers.size() + 1));
        numbers.push_back(number);
    }
    return numbers;
}

}  // namespace reports
