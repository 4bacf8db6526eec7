#include "solver/kernels/poly6.h"

#include "verification/framework/registry.h"

#include <numbers>

namespace {
using namespace plumbline;
using namespace verification;

/// ∫ g(r) dV over the ball of radius h: composite midpoint rule in r with 4000 shells.
template <int Dim, class G> double integrate_radially(double h, G g) {
    constexpr int n_shells = 4000;
    double total = 0.0;
    for (int k = 0; k < n_shells; ++k) {
        const double r = (k + 0.5) * h / n_shells;
        const double surface = Dim == 2 ? 2 * std::numbers::pi * r : 4 * std::numbers::pi * r * r;
        total += g(r) * surface * h / n_shells;
    }
    return total;
}

template <int Dim, RadialKernel K> double integrate_radially(const K& w) {
    return integrate_radially<Dim>(w.support(), [&](double r) { return w.value(r); });
}

/// max |a − b| / max |b| over r, b being the central difference of `primitive`, step 1e-5 h.
template <class A, class P> double difference_from_slope(double h, A a, P primitive) {
    double worst = 0.0, scale = 0.0;
    for (double r = 0.01 * h; r < 0.99 * h; r += 0.01 * h) {
        const double step = 1e-5 * h, b = (primitive(r + step) - primitive(r - step)) / (2 * step);
        worst = std::max(worst, std::abs(a(r) - b));
        scale = std::max(scale, std::abs(b));
    }
    return worst / scale;
}

const Poly6<2> w2(0.7);
const Poly6<3> w3(0.7);
double value(double r) { return w3.value(r); }
double slope(double r) { return w3.derivative(r); }
double minus_slope(double r) { return -slope(r); }
double second_derivative(double r) { return w3.second_derivative(r); }
double laplacian(double r) { return plumbline::laplacian(w3, r); }

// Measurements; the sabotaged ones are wrong on purpose, to show that the bound can tell.
double error_in_plane() { return std::abs(integrate_radially<2>(w2) - 1.0); }
double error_in_space() { return std::abs(integrate_radially<3>(w3) - 1.0); }
double space_kernel_used_in_plane() { return std::abs(integrate_radially<2>(w3) - 1.0); }
double slope_error() { return difference_from_slope(0.7, slope, value); }
double slope_with_wrong_sign() { return difference_from_slope(0.7, minus_slope, value); }
double integral_as_printed() { return std::abs(integrate_radially<3>(0.7, second_derivative)); }
double integral_of_laplacian() { return std::abs(integrate_radially<3>(0.7, laplacian)); }

const Register claims_of_poly6{
    Claim{.id = "poly6.integrates_to_one_2d",
          .source = {Paper::adams2009, "Eqs. 8, 89"},
          .says = "∫ ω dV = 1 in the plane",
          .bound = at_most(1e-6, "midpoint rule with 4000 shells: (h/4000)² |g″| / 24 < 1e-6"),
          .measure = error_in_plane,
          .sabotaged = space_kernel_used_in_plane},
    Claim{.id = "poly6.integrates_to_one_3d",
          .source = {Paper::adams2009, "Eqs. 8, 86"},
          .says = "∫ ω dV = 1 in space",
          .bound = at_most(1e-6, "as in the plane"),
          .measure = error_in_space},
    Claim{.id = "poly6.derivative_is_the_slope",
          .source = {Paper::adams2009, "Eq. 87"},
          .says = "ω′ is the derivative of ω",
          .bound = at_most(1e-8, "central difference: 1e-10 |ω‴/ω′| h² / 6 from truncation"),
          .measure = slope_error,
          .sabotaged = slope_with_wrong_sign},
    Claim{.id = "poly6.laplacian_is_not_the_second_derivative",
          .source = {Paper::adams2009, "Eq. 11"},
          .says = "printed: Δω = ω″. But ∫ Δω dV = 0 over the support, and ∫ ω″ dV is not",
          .bound = at_least(1.0, "erratum E1; 0 would mean that the printed form is right"),
          .measure = integral_as_printed,
          .sabotaged = integral_of_laplacian},
};
}  // namespace
