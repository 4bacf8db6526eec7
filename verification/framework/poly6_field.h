#pragma once

#include "verification/framework/lattice_sums.h"

namespace verification {

template <int Dim> using Point50 = Eigen::Matrix<Real50, Dim, 1>;

/// Σⱼ fⱼ ω(‖x − xⱼ‖) Vⱼ to 50 digits, ω being poly6 of support `h`.
template <int Dim>
Real50 poly6_field(const Patch<Dim>& patch, const std::vector<double>& f, double h,
                   const Point50<Dim>& x);

template <int Dim> using Field50 = std::function<Real50(const Point50<Dim>&)>;

/// Central differences of a field with 50 digits and step 1e-12: truncation and cancellation leave
/// more than 20 correct digits, so they serve as the truth for exact derivatives in double precision.
template <int Dim>
plumbline::Vec<Dim> gradient_to_20_digits(const Field50<Dim>& field, const plumbline::Vec<Dim>& at);
template <int Dim>
double laplacian_to_20_digits(const Field50<Dim>& field, const plumbline::Vec<Dim>& at);

}  // namespace verification
