#pragma once

#include "verification/framework/lattice_sums.h"

namespace verification {

template <int Dim> using Point50 = Eigen::Matrix<Real50, Dim, 1>;

/// Σⱼ fⱼ ω(‖x − xⱼ‖) Vⱼ to 50 digits, ω being poly6 of support `h`.
template <int Dim>
Real50 poly6_field(const Patch<Dim>& patch, const std::vector<double>& f, double h,
                   const Point50<Dim>& x) {
    Real50 sum = 0;
    for (std::size_t j = 0; j < patch.x.size(); ++j) {
        const Point50<Dim> x_j = patch.x[j].template cast<Real50>();
        Real50 r_squared = 0;
        for (int d = 0; d < Dim; ++d) r_squared += (x[d] - x_j[d]) * (x[d] - x_j[d]);
        sum += f[j] * poly6_to_50_digits(Dim, h, r_squared).value * patch.V[j];
    }
    return sum;
}

/// Central differences of a field with 50 digits and step 1e-12: truncation and cancellation leave
/// more than 20 correct digits, so they serve as the truth for exact derivatives in double precision.
template <int Dim, class Field>
plumbline::Vec<Dim> gradient_to_20_digits(Field field, const plumbline::Vec<Dim>& at) {
    const Real50 step("1e-12");
    plumbline::Vec<Dim> slope;
    for (int d = 0; d < Dim; ++d) {
        Point50<Dim> ahead = at.template cast<Real50>(), behind = ahead;
        ahead[d] += step, behind[d] -= step;
        slope[d] = static_cast<double>((field(ahead) - field(behind)) / (2 * step));
    }
    return slope;
}
template <int Dim, class Field>
double laplacian_to_20_digits(Field field, const plumbline::Vec<Dim>& at) {
    const Real50 step("1e-12");
    const Point50<Dim> x = at.template cast<Real50>();
    Real50 sum = 0;
    for (int d = 0; d < Dim; ++d) {
        Point50<Dim> ahead = x, behind = x;
        ahead[d] += step, behind[d] -= step;
        sum += (field(ahead) - 2 * field(x) + field(behind)) / (step * step);
    }
    return static_cast<double>(sum);
}

}  // namespace verification
