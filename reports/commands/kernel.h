#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reports {

struct KernelRow {
    double r, value, derivative, second_derivative, laplacian;
};

/// The kernel of that name, dimension (1, 2 or 3) and support [m] at radii ≥ 0 [m].
/// Throws plumbline::InvalidInput, naming what there is, for a kernel, dimension, support or radius
/// that does not exist.
std::vector<KernelRow> kernel_table(std::string_view name, int dim, double support,
                                    const std::vector<double>& radii);

/// The numbers of "0.1,0.2,0.5". Throws plumbline::InvalidInput, saying which of them is no number.
std::vector<double> numbers_of(std::string_view list);

}  // namespace reports
