#include "solver/kernels/quintic_spline.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace quintic_spline_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// The truncated powers of Schoenberg 1946, with their usual σ for the support 3 h converted.
template <int Dim> struct QuinticSplineFormula {
    static constexpr int rim_order = 5;
    static constexpr bool singular = false;
    static constexpr std::array knots{1.0 / 3, 2.0 / 3};

    template <class Real> static Real sigma() {
        return Dim == 1 ? 1 / Real(40) : Dim == 2 ? 63 / (478 * pi<Real>()) : 9 / (40 * pi<Real>());
    }
    template <class Real> static Real P(const Real& q) { return powers<Real>(3 * q, 5); }
    template <class Real>
    static Real powers(const Real& s, int n) {  // (3−s)₊ⁿ − 6 (2−s)₊ⁿ + 15 (1−s)₊ⁿ
        using std::pow;
        const auto truncated = [n](const Real& a) { return a > 0 ? Real(pow(a, n)) : Real(0); };
        return truncated(3 - s) - 6 * truncated(2 - s) + 15 * truncated(1 - s);
    }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        return -15 * sigma<Real>() / pow(h, Dim + 1) * powers<Real>(3 * q, 4);
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        return 180 * sigma<Real>() / pow(h, Dim + 2) * powers<Real>(3 * q, 3);
    }
    static Real50 second_moment() {
        const auto at_unit_support = [](const Real50& q) { return P(q); };
        return second_moment_of<Dim>(at_unit_support, {Real50(1) / 3, Real50(2) / 3});
    }
};

const Register standard_claims{kernel_claims<QuinticSpline, QuinticSplineFormula>(
    {Paper::literature, "Schoenberg 1946; Morris et al. 1997"})};

const Register claims_of_quintic_spline{
    Claim{.id = "quintic_spline.smooth_at_its_knots",
          .source = {Paper::literature, "Schoenberg 1946"},
          .says = "ω, ω′, ω″ have no jump at q = 1/3 and 2/3; relative to their size",
          .bound = at_most(1e-14, "neighbouring radii; 32 roundings on either side"),
          .measure =
              [] {
                  const QuinticSpline<3> w(0.7);
                  return std::max(jump_across(w, 0.7 / 3), jump_across(w, 0.7 * 2 / 3));
              },
          .sabotaged =
              [] {  // the third term sets in at s = 0.9 instead of 1
                  return 15 * std::pow(0.1, 5) / 66;
              }},
    Claim{.id = "quintic_spline.sigma_in_space",
          .source = {Paper::literature, "Morris et al. 1997"},
          .says = "σ = 1/(120 π) for r in thirds of the support; the often copied 3/(359 π) is "
                  "0.27 % off",
          .bound = at_most(1e-12, "quadrature asked for 1e-13 in each of 3 panels"),
          .measure =
              [] {
                  return std::abs(moment(QuinticSpline<3>(0.7), 0, {1.0 / 3, 2.0 / 3}) - 1.0);
              },
          .sabotaged =
              [] {
                  const double integral = moment(QuinticSpline<3>(0.7), 0, {1.0 / 3, 2.0 / 3});
                  return std::abs(integral * (3.0 / 359) / (1.0 / 120) - 1.0);
              }},
};
}  // namespace
}  // namespace quintic_spline_claims
