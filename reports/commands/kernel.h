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

struct AnisotropicRow {
    std::vector<double> x;  // [m]
    double value;
    std::vector<double> gradient;
    double laplacian;
};

/// The same kernel in 2 or 3 dimensions seen through the linear map G, given row by row, see Anisotropic; at
/// points x1,y1[,z1],x2,y2[,z2],… [m]. Throws plumbline::InvalidInput likewise, for a matrix that is not
/// dim × dim or not invertible, and for points that are not complete.
std::vector<AnisotropicRow> anisotropic_table(std::string_view name, int dim, double support,
                                              const std::vector<double>& map,
                                              const std::vector<double>& points);

/// The numbers of "0.1,0.2,0.5". Throws plumbline::InvalidInput, saying which of them is no number.
std::vector<double> numbers_of(std::string_view list, std::string_view option = "--at");

}  // namespace reports
