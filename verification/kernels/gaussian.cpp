#include "solver/kernels/gaussian.h"

#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace gaussian_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// exp(−9 q²) inside the support, divided by its integral over the ball: by parts from erf.
template <int Dim> struct GaussianFormula {
    static constexpr int rim_order = 0;
    static constexpr bool singular = false;

    template <class Real> static Real integral_at_unit_support() {
        using std::exp, std::sqrt;
        const Real error_function = sqrt(pi<Real>()) * boost::math::erf(Real(3)) / 3,
                   rim = exp(Real(-9));
        if (Dim == 1) return error_function;                      // 2 ∫ exp(−9 q²) dq
        if (Dim == 2) return pi<Real>() / 9 * (1 - rim);          // 2π ∫ exp(−9 q²) q dq
        return 4 * pi<Real>() / 18 * (error_function / 2 - rim);  // 4π ∫ exp(−9 q²) q² dq, by parts
    }
    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::exp, std::pow;
        static const Real integral = integral_at_unit_support<Real>();
        return exp(Real(-9 * d * d / (h * h))) / (pow(h, Dim) * integral);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        return -18 * d / (h * h) * value(d, h);
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        return (324 * d * d / (h * h) - 18) / (h * h) * value(d, h);
    }
    static Real50 second_moment() {  // Gauss's 30 points are good to 1e-40 for exp(−9 q²)
        return second_moment_of<Dim>([](const Real50& q) { return exp(-9 * q * q); });
    }
};

const Register standard_claims{kernel_claims<Gaussian, GaussianFormula>(
    {Paper::literature, "Gingold & Monaghan 1977; adams2009 Sec. 2.1"})};

const Register claims_of_gaussian{
    Claim{.id = "gaussian.jump_at_rim",
          .source = {Paper::plumbline, "docstring of Gaussian"},
          .says =
              "at the rim ω falls from e⁻⁹ ω(0) to 0 in a jump, in every dimension; relative error",
          .bound =
              at_most(1e-14, "the last radius inside is 1e-16 h from the rim: 18e-16 of the value"),
          .measure =
              [] {
                  const Gaussian<3> w(0.7);
                  const double inside = w.value(std::nextafter(0.7, 0.0));
                  return std::abs((inside - w.value(0.7)) / w.value(0.0) / std::exp(-9.0) - 1.0);
              },
          .sabotaged =
              [] {  // cut off at two length scales
                  const Gaussian<3> w(0.7);
                  return std::abs(w.value(0.7 * 2 / 3) / w.value(0.0) / std::exp(-9.0) - 1.0);
              }},
    Claim{.id = "gaussian.normalised_over_its_support",
          .source = {Paper::plumbline, "docstring of Gaussian"},
          .says = "σ counts what the cut-off takes away: π^(−3/2) (3/h)³ is 4.4e-4 too small in 3D",
          .bound = at_most(1e-12, "quadrature asked for 1e-13"),
          .measure = [] { return std::abs(moment(Gaussian<3>(0.7), 0) - 1.0); },
          .sabotaged =
              [] {
                  const double scale = 0.7 / 3,
                               sigma = std::pow(pi<double>(), -1.5) / std::pow(scale, 3);
                  const auto untruncated = [=](double r) {
                      return sigma * std::exp(-r * r / scale / scale);
                  };
                  return std::abs(integrate_radially(3, 0.7, untruncated) - 1.0);
              }},
};
}  // namespace
}  // namespace gaussian_claims
