#pragma once

#include "solver/kernels/kernel.h"
#include "verification/kernels/radial.h"

#include <algorithm>

namespace verification {

// Erratum 17: the Laplacian of a kernel as it is, and as Eq. 11 prints it.
inline constexpr auto true_laplacian = [](const auto& w, double r) {
    return plumbline::laplacian(w, r);
};
inline constexpr auto printed_laplacian = [](const auto& w, double r) {
    return w.second_derivative(r);
};

/// |∫ Δω dV| h², the larger of the two kernels of one support.
template <class W2, class W3, class Laplacian>
double integral_of_laplacian(const W2& w2, const W3& w3, Laplacian laplacian) {
    const auto integral = [&](const auto& w) {
        constexpr int dim = std::decay_t<decltype(w)>::dim;
        const double h = w.support();
        return std::abs(integrate_radially(dim, h, [&](double r) { return laplacian(w, r); })) * h *
               h;
    };
    return std::max(integral(w2), integral(w3));
}

/// |∫ Δω |x|² / (2 dim) dV − 1|, the larger of the two kernels.
template <class W2, class W3, class Laplacian>
double error_of_square(const W2& w2, const W3& w3, Laplacian laplacian) {
    const auto error = [&](const auto& w) {
        constexpr int dim = std::decay_t<decltype(w)>::dim;
        const auto integrand = [&](double r) { return laplacian(w, r) * r * r / (2 * dim); };
        return std::abs(integrate_radially(dim, w.support(), integrand) - 1.0);
    };
    return std::max(error(w2), error(w3));
}

/// q in (0, 1) where the Laplacian changes its sign, by bisection; NaN if both ends have the same sign.
template <class W, class Laplacian> double sign_change(const W& w, Laplacian laplacian) {
    double low = 1e-3, high = 0.999;
    const auto at = [&](double q) { return laplacian(w, q * w.support()); };
    if (at(low) * at(high) > 0.0) return NAN;
    while (true) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return middle;
        (at(low) * at(middle) > 0.0 ? low : high) = middle;
    }
}

}  // namespace verification
