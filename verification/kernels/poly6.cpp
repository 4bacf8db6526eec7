#include "solver/kernels/poly6.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"
#include "verification/kernels/laplacian_claims.h"

#include <boost/math/constants/constants.hpp>

namespace poly6_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// As printed: Eqs. 86–88 for dim 3, Eqs. 89–91 for dim 2 with the coefficients of Eqs. 90, 91 that the
/// scan lost; dim 1 with the same polynomial.
template <int Dim> struct Poly6Formula {
    static constexpr int rim_order = 3;
    static constexpr bool singular = false;

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        const Real s = 1 - d * d / (h * h);
        if (Dim == 1) return 35 / (32 * h) * pow(s, 3);
        if (Dim == 2) return 4 / (pi<Real>() * h * h) * pow(s, 3);  // Eq. 89
        return 315 / (64 * pi<Real>() * pow(h, 3)) * pow(s, 3);     // Eq. 86
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real common = d / (h * h) * pow(Real(1 - d * d / (h * h)), 2);
        if (Dim == 1) return -105 / (16 * h) * common;
        if (Dim == 2) return -24 / (pi<Real>() * h * h) * common;  // Eq. 90
        return -945 / (32 * pi<Real>() * pow(h, 3)) * common;      // Eq. 87
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q2 = d * d / (h * h), common = (1 - q2) * (5 * q2 - 1) / (h * h);
        if (Dim == 1) return 105 / (16 * h) * common;
        if (Dim == 2) return 24 / (pi<Real>() * h * h) * common;  // Eq. 91
        return 945 / (32 * pi<Real>() * pow(h, 3)) * common;      // Eq. 88
    }
    static Real50 second_moment() {
        return second_moment_of<Dim>([](const Real50& q) { return pow(1 - q * q, 3); });
    }
};

const Register standard_claims{
    kernel_claims<Poly6, Poly6Formula>({Paper::adams2009, "Eqs. 8, 10, 11, 86-91"})};

constexpr double h = 0.7;
const UnderTest<Poly6<2>> w2(h);
const UnderTest<Poly6<3>> w3(h);

/// The second moments that XSPH's viscosity needs, ∫ ω x² dV of one axis: h² / of_h2 expected.
double second_moment_error(double of_h2_in_2d, double of_h2_in_3d) {
    const double m2 = moment(w2, 2) / 2, m3 = moment(w3, 2) / 3;
    return std::max(std::abs(m2 / (h * h) * of_h2_in_2d - 1.0),
                    std::abs(m3 / (h * h) * of_h2_in_3d - 1.0));
}

/// ω(0) by parts from `second`: ∫₀ʰ r ω″ dr = [r ω′ − ω]₀ʰ = ω(0); relative error.
double error_of_centre(const std::function<double(double)>& second) {
    const double integral = integrate([&](double r) { return r * second(r); }, 0, h);
    return std::abs(integral / w2.value(0.0) - 1.0);
}
double error_of_centre_by_slope(const std::function<double(double)>& slope) {
    return std::abs(-integrate(slope, 0, h) / w2.value(0.0) - 1.0);
}
double q_squared(double r) { return r * r / (h * h); }

const Register claims_of_poly6{
    Claim{.id = "poly6.second_moment",
          .source = {Paper::adams2009, "Eqs. 2, 86, 89"},
          .says = "∫ ω x² dV of one axis is h²/10 in 2D and h²/11 in 3D: the smoothing of Eq. 2",
          .bound = at_most(1e-12, "quadrature asked for 1e-13"),
          .measure = [] { return second_moment_error(10, 11); },
          .sabotaged = [] { return second_moment_error(11, 10); }},
    Claim{
        .id = "poly6.vanishing_laplacian",
        .source = {Paper::adams2009, "Eqs. 11, 88, 91"},
        .says = "∫ Δω dV = 0; printed, Δω = ω″, it is 8/h² in 2D and 18/h² in 3D; in units of 1/h²",
        .bound = at_most(1e-11, "quadrature: 1e-13 of ∫ |Δω| dV < 60 / h²"),
        .measure = [] { return integral_of_laplacian(w2, w3, true_laplacian); },
        .sabotaged = [] { return integral_of_laplacian(w2, w3, printed_laplacian); },
        .erratum = 17},
    Claim{
        .id = "poly6.laplacian_of_a_square",
        .source = {Paper::adams2009, "Eqs. 11, 88, 91"},
        .says = "∫ Δω |x|² / (2 dim) dV = 1, the Laplacian of |x|² / (2 dim); printed: (dim + 1)/2",
        .bound = at_most(1e-12, "quadrature asked for 1e-13"),
        .measure = [] { return error_of_square(w2, w3, true_laplacian); },
        .sabotaged = [] { return error_of_square(w2, w3, printed_laplacian); },
        .erratum = 17},
    Claim{.id = "poly6.laplacian_changes_sign",
          .source = {Paper::adams2009, "Eqs. 11, 88, 91"},
          .says = "Δω changes its sign at q = 1/√3 in 2D and √(3/7) in 3D, not at 1/√5 as ω″ does",
          .bound = at_most(1e-14,
                           "bisection to the last bit; Δω is rounded to 1e-15 of its slope there"),
          .measure =
              [] {
                  return std::max(std::abs(sign_change(w2, true_laplacian) - std::sqrt(1.0 / 3)),
                                  std::abs(sign_change(w3, true_laplacian) - std::sqrt(3.0 / 7)));
              },
          .sabotaged =
              [] {
                  return std::max(
                      std::abs(sign_change(w2, printed_laplacian) - std::sqrt(1.0 / 3)),
                      std::abs(sign_change(w3, printed_laplacian) - std::sqrt(3.0 / 7)));
              },
          .erratum = 17},
    Claim{.id = "poly6.second_derivative_changes_sign",
          .source = {Paper::adams2009, "Eqs. 88, 91"},
          .says = "ω″ changes its sign at q = 1/√5 in every dimension",
          .bound = at_most(1e-14, "bisection to the last bit"),
          .measure = [] { return std::abs(sign_change(w3, printed_laplacian) - std::sqrt(0.2)); },
          .sabotaged = [] { return std::abs(sign_change(w3, true_laplacian) - std::sqrt(0.2)); }},
    Claim{.id = "poly6.coefficient_of_equation_90",
          .source = {Paper::adams2009, "Eq. 90"},
          .says = "−∫ ω′ dr = ω(0) in 2D; the scan lost the coefficient of Eq. 90",
          .bound = at_most(1e-12, "quadrature asked for 1e-13"),
          .measure =
              [] { return error_of_centre_by_slope([](double r) { return w2.derivative(r); }); },
          .sabotaged =
              [] {
                  return error_of_centre_by_slope([](double r) {
                      return -r / (h * h) * (1 - q_squared(r)) * (1 - q_squared(r));
                  });
              },
          .erratum = 38},
    Claim{
        .id = "poly6.coefficient_of_equation_91",
        .source = {Paper::adams2009, "Eq. 91"},
        .says = "∫ r ω″ dr = ω(0) in 2D; the scan lost the coefficient of Eq. 91",
        .bound = at_most(1e-12, "quadrature asked for 1e-13"),
        .measure = [] { return error_of_centre([](double r) { return w2.second_derivative(r); }); },
        .sabotaged =
            [] {
                return error_of_centre([](double r) {
                    return 1 / (h * h) * (1 - q_squared(r)) * (5 * q_squared(r) - 1);
                });
            },
        .erratum = 38},
};
}  // namespace
}  // namespace poly6_claims
