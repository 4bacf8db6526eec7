#include "solver/kernels/spiky.h"

#include "solver/kernels/poly6.h"
#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"
#include "verification/kernels/laplacian_claims.h"

#include <boost/math/constants/constants.hpp>

namespace spiky_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// As printed: Eqs. 92–94 for dim 3 and 95–97 for dim 2, with what the scan lost of Eqs. 92, 97; dim 1
/// with the same polynomial.
template <int Dim> struct SpikyFormula {
    static constexpr int rim_order = 3;
    static constexpr bool singular = false;

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        if (Dim == 1) return 2 / h * pow(Real(1 - d / h), 3);
        if (Dim == 2) return 10 / (pi<Real>() * h * h) * pow(Real(1 - d / h), 3);  // Eq. 95
        return 15 / (pi<Real>() * pow(h, 3)) * pow(Real(1 - d / h), 3);            // Eq. 92
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real common = 1 / h * pow(Real(1 - d / h), 2);
        if (Dim == 1) return -6 / h * common;
        if (Dim == 2) return -30 / (pi<Real>() * h * h) * common;  // Eq. 96
        return -45 / (pi<Real>() * pow(h, 3)) * common;            // Eq. 93
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real common = 1 / (h * h) * (1 - d / h);
        if (Dim == 1) return 12 / h * common;
        if (Dim == 2) return 60 / (pi<Real>() * h * h) * common;  // Eq. 97
        return 90 / (pi<Real>() * pow(h, 3)) * common;            // Eq. 94
    }
    static Real50 second_moment() {
        return second_moment_of<Dim>([](const Real50& q) { return pow(1 - q, 3); });
    }
};

const Register standard_claims{
    kernel_claims<Spiky, SpikyFormula>({Paper::adams2009, "Eqs. 8, 10, 11, 92-97"})};

constexpr double h = 0.7;
const UnderTest<Spiky<2>> w2(h);
const UnderTest<Spiky<3>> w3(h);

double integral(const std::function<double(double)>& value) {
    return std::abs(integrate_radially(3, h, value) - 1.0);
}
/// Eq. 92 as scanned, without the exponent 3.
double equation_92_as_scanned(double r) { return 15 / (pi<double>() * h * h * h) * (1 - r / h); }
/// Eq. 97 as scanned, without its condition d < h.
double equation_97_as_scanned(double r) {
    return 60 / (pi<double>() * h * h * h * h) * (1 - r / h);
}

const Register claims_of_spiky{
    Erratum{
        .number = 38,
        .source = {Paper::adams2009, "Eqs. 19, 21, 22, 42, 90-92, 97; Table 1"},
        .printed =
            "the scan has lost: the sign in (19), the index of p(xᵢ) in (21), (22), z in (42), the "
            "coefficients of (90), (91), the exponent of (92), the condition d < h of (97); Table "
            "1 has Vⱼ for mⱼ",
        .corrected = "+ in (19); p(xᵢ); (x, y, z); −24/(πh²), 24/(πh²); (1 − d/h)³; 0 for d ≥ h"},
    &eq_90_without_coefficient,
    &eq_91_without_coefficient,
    &eq_92_without_exponent,
    &eq_97_without_condition,
    Claim{.id = "spiky.exponent_of_equation_92",
          .source = {Paper::adams2009, "Eqs. 8, 92"},
          .says = "∫ ω dV = 1 in space; with the exponent that the scan lost, 5",
          .bound = at_most(1e-12, "quadrature asked for 1e-13"),
          .measure = [] { return integral([](double r) { return w3.value(r); }); },
          .sabotaged = [] { return integral(equation_92_as_scanned); },
          .erratum = 38},
    Claim{.id = "spiky.condition_of_equation_97",
          .source = {Paper::adams2009, "Eq. 97"},
          .says = "ω″ = 0 at r = 1.5 h in 2D; the scan lost the condition d < h; in units of 1/h⁴",
          .bound = at_most(0, "exactly: the distance to the rim is clamped to 0"),
          .measure = [] { return std::abs(w2.second_derivative(1.5 * h)) * h * h * h * h; },
          .sabotaged = [] { return std::abs(equation_97_as_scanned(1.5 * h)) * h * h * h * h; },
          .erratum = 38},
    Claim{.id = "spiky.pushes_close_particles_apart",
          .source = {Paper::adams2009, "Eqs. 93, 96; Appendix A"},
          .says = "the gradient does not go to zero at d = 0: h ω′(0+) / ω(0) = −3, for poly6 0",
          .bound = at_most(-2.99, "−3 (1 − q)² / (1 − q)³ = −3 / (1 − q) at q = 1e-9"),
          .measure = [] { return h * w3.derivative(1e-9 * h) / w3.value(1e-9 * h); },
          .sabotaged =
              [] {
                  const Poly6<3> w(h);
                  return h * w.derivative(1e-9 * h) / w.value(1e-9 * h);
              }},
    Claim{.id = "spiky.vanishing_laplacian",
          .source = {Paper::adams2009, "Eqs. 11, 94, 97"},
          .says =
              "∫ Δω dV = 0; printed, Δω = ω″, it is 20/h² in 2D and 30/h² in 3D; in units of 1/h²",
          .bound = at_most(1e-11, "quadrature: 1e-13 of ∫ |Δω| dV < 60 / h²"),
          .measure = [] { return integral_of_laplacian(w2, w3, true_laplacian); },
          .sabotaged = [] { return integral_of_laplacian(w2, w3, printed_laplacian); },
          .erratum = 17},
    Claim{
        .id = "spiky.laplacian_of_a_square",
        .source = {Paper::adams2009, "Eqs. 11, 94, 97"},
        .says = "∫ Δω |x|² / (2 dim) dV = 1, the Laplacian of |x|² / (2 dim); printed: (dim + 1)/2",
        .bound = at_most(1e-12, "quadrature asked for 1e-13"),
        .measure = [] { return error_of_square(w2, w3, true_laplacian); },
        .sabotaged = [] { return error_of_square(w2, w3, printed_laplacian); },
        .erratum = 17},
    Claim{.id = "spiky.laplacian_changes_sign",
          .source = {Paper::adams2009, "Eqs. 11, 94, 97"},
          .says =
              "Δω changes its sign at q = 1/3 in 2D and 1/2 in 3D; ω″, printed for it, never does",
          .bound = at_most(1e-14,
                           "bisection to the last bit; Δω is rounded to 1e-15 of its slope there"),
          .measure =
              [] {
                  return std::max(std::abs(sign_change(w2, true_laplacian) - 1.0 / 3),
                                  std::abs(sign_change(w3, true_laplacian) - 1.0 / 2));
              },
          .sabotaged = [] { return std::abs(sign_change(w2, printed_laplacian) - 1.0 / 3); },
          .erratum = 17},
};
}  // namespace
}  // namespace spiky_claims
