#include "solver/kernels/viscosity.h"

#include "solver/kernels/poly6.h"
#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace viscosity_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// 3D as in Müller et al. 2003; 2D by integrating Δω = σ (1 − q) twice, with ω = ω′ = 0 at q = 1.
template <int Dim> struct ViscosityFormula {
    static constexpr int rim_order = 3;
    static constexpr bool singular = true;
    /// 2D: at q = 1, σ q²/4 less σ (q³/9 + 5/36) = σ/4.
    static Real50 size_of_cancelling_terms() {
        return Dim == 2 ? Real50(sigma<Real50>() / 2) : Real50(0);
    }
    template <class Real> static Real sigma() {
        return Dim == 2 ? 40 / pi<Real>() : 15 / (2 * pi<Real>());
    }
    template <class Real> static Real P(const Real& q) {
        using std::log;
        if (Dim == 3) return -q * q * q / 2 + q * q + 1 / (2 * q) - 1;
        return q * q / 4 - q * q * q / 9 - log(q) / 6 - Real(5) / 36;
    }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real slope = Dim == 3 ? Real(-3 * q * q / 2 + 2 * q - 1 / (2 * q * q))
                                    : Real(q / 2 - q * q / 3 - 1 / (6 * q));
        return sigma<Real>() / pow(h, Dim + 1) * slope;
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real curvature = Dim == 3 ? Real(-3 * q + 2 + 1 / (q * q * q))
                                        : Real(Real(1) / 2 - 2 * q / 3 + 1 / (6 * q * q));
        return sigma<Real>() / pow(h, Dim + 2) * curvature;
    }
    static Real50 second_moment() {
        // 2D: ∫₀¹ q³ P dq = 1/24 − 1/63 + 1/96 − 5/144 and ∫₀¹ q P dq = 1/(2 · 40), the log by parts.
        if (Dim == 2)
            return (Real50(1) / 24 - Real50(1) / 63 + Real50(1) / 96 - Real50(5) / 144) * 40;
        return second_moment_of<Dim>([](const Real50& q) { return P(q); });
    }
};

const Register standard_claims{
    kernel_claims<Viscosity, ViscosityFormula>({Paper::literature, "Müller et al. 2003"})};

/// Radii among 1000 where the Laplacian is negative.
template <class K> double negative_laplacians(const K& w) {
    int n = 0;
    for (int k = 0; k < 1000; ++k) n += laplacian(w, 0.7 * k / 1000) < 0.0;
    return n;
}
/// The worst relative error of Δω against σ (1 − q) / h², computed from ω″ + (dim − 1) ω′/r or `closed`.
template <class K> double cone_error(const K& w, double coefficient) {
    double worst = 0.0;
    for (int k = 1; k < 100; ++k) {
        const double q = k / 100.0, r = 0.7 * q;
        const double cone = coefficient / std::pow(0.7, K::dim + 2) * (1 - q);
        const double sum = w.second_derivative(r) + (K::dim - 1) * w.derivative(r) / r;
        const double terms = std::abs(w.second_derivative(r)) + std::abs(w.derivative(r) / r);
        worst =
            std::max({worst, std::abs(laplacian(w, r) / cone - 1.0), std::abs(sum - cone) / terms});
    }
    return worst;
}

const Register claims_of_viscosity{
    Claim{.id = "viscosity.laplacian_is_never_negative",
          .source = {Paper::literature, "Müller et al. 2003"},
          .says = "Δω ≥ 0 in 2D and 3D, so viscosity takes energy; radii where not, among 2000; "
                  "for poly6 many",
          .bound = at_most(0, "a count"),
          .measure =
              [] {
                  return negative_laplacians(Viscosity<2>(0.7)) +
                         negative_laplacians(Viscosity<3>(0.7));
              },
          .sabotaged = [] { return negative_laplacians(Poly6<3>(0.7)); }},
    Claim{.id = "viscosity.laplacian_is_a_cone",
          .source = {Paper::literature, "Müller et al. 2003"},
          .says = "Δω = 40/(π h⁴) (1 − q) in 2D, 45/(π h⁵) (1 − q) in 3D, in closed form and as "
                  "ω″ + (dim − 1) ω′/r",
          .bound = at_most(1e-14, "32 roundings of the terms; (1 − k/100) itself is rounded"),
          .measure =
              [] {
                  return std::max(cone_error(Viscosity<2>(0.7), 40 / pi<double>()),
                                  cone_error(Viscosity<3>(0.7), 45 / pi<double>()));
              },
          .sabotaged = [] { return cone_error(Viscosity<3>(0.7), 15 / (2 * pi<double>())); }},
};
}  // namespace
}  // namespace viscosity_claims
