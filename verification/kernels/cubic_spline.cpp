#include "solver/kernels/cubic_spline.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace cubic_spline_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// As in Monaghan & Lattanzio 1985, in q = r / h over the whole support.
template <int Dim> struct CubicSplineFormula {
    static constexpr int rim_order = 3;
    static constexpr bool singular = false;
    static constexpr std::array knots{1.0 / 2};

    template <class Real> static Real sigma() {
        return Dim == 1 ? Real(4) / 3 : Dim == 2 ? 40 / (7 * pi<Real>()) : 8 / pi<Real>();
    }
    template <class Real> static Real P(const Real& q) {
        if (2 * q < 1) return 6 * (q * q * q - q * q) + 1;
        return 2 * (1 - q) * (1 - q) * (1 - q);
    }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real slope = 2 * q < 1 ? Real(18 * q * q - 12 * q) : Real(-6 * (1 - q) * (1 - q));
        return sigma<Real>() / pow(h, Dim + 1) * slope;
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        const Real curvature = 2 * q < 1 ? Real(36 * q - 12) : Real(12 * (1 - q));
        return sigma<Real>() / pow(h, Dim + 2) * curvature;
    }
    static Real50 second_moment() {
        const auto at_unit_support = [](const Real50& q) { return P(q); };
        return second_moment_of<Dim>(at_unit_support, {Real50(1) / 2});
    }
};

const Register standard_claims{kernel_claims<CubicSpline, CubicSplineFormula>(
    {Paper::literature, "Monaghan & Lattanzio 1985"})};

const Register claims_of_cubic_spline{
    Claim{.id = "cubic_spline.smooth_at_its_knot",
          .source = {Paper::literature, "Monaghan & Lattanzio 1985"},
          .says = "ω, ω′, ω″ have no jump at q = 1/2; relative to their size",
          .bound = at_most(1e-14, "neighbouring radii; 16 roundings on either side"),
          .measure = [] { return jump_across(CubicSpline<3>(0.7), 0.5 * 0.7); },
          .sabotaged =
              [] {  // the branches change at q = 0.45 instead
                  const double q = 0.45, inner = 6 * (q * q * q - q * q) + 1;
                  return std::abs(inner - 2 * std::pow(1 - q, 3));
              }},
};
}  // namespace
}  // namespace cubic_spline_claims
