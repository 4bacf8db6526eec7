#include "solver/kernels/singular.h"

#include "solver/kernels/poly6.h"
#include "verification/framework/registry.h"
#include "verification/kernels/kernel_claims.h"

#include <boost/math/constants/constants.hpp>

namespace singular_claims {
namespace {
using namespace plumbline;
using namespace verification;
using boost::math::constants::pi;

/// The form that the docstring of the kernel states.
template <int Dim> struct SingularFormula {
    static constexpr int rim_order = 3;
    static constexpr bool singular = true;

    template <class Real> static Real sigma() { return Dim == 2 ? 2 / pi<Real>() : 5 / pi<Real>(); }
    template <class Real> static Real P(const Real& q) { return (1 - q) * (1 - q) * (1 - q) / q; }

    template <class Real> static Real value(const Real& d, const Real& h) {
        using std::pow;
        return sigma<Real>() / pow(h, Dim) * P<Real>(d / h);
    }
    template <class Real> static Real derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        return sigma<Real>() / pow(h, Dim + 1) * (-(1 - q) * (1 - q) * (1 + 2 * q) / (q * q));
    }
    template <class Real> static Real second_derivative(const Real& d, const Real& h) {
        using std::pow;
        const Real q = d / h;
        return sigma<Real>() / pow(h, Dim + 2) * (2 * (1 - q * q * q) / (q * q * q));
    }
    static Real50 second_moment() {
        const auto at_unit_support = [](const Real50& q) { return P(q); };
        return second_moment_of<Dim>(at_unit_support);
    }
};

const Register standard_claims{
    kernel_claims<Singular, SingularFormula>({Paper::adams2009, "Sec. 2.1"})};

/// Shepard's quotient of two samples, 0 at x = 0 and 1 at x = 0.4, at a distance from the first.
template <class K> double shepard_of_two(const K& w, double distance) {
    const double w0 = w.value(distance), w1 = w.value(0.4 - distance);
    return w1 / (w0 + w1);
}

const Register claims_of_singular{
    Claim{.id = "singular.interpolates",
          .source = {Paper::adams2009, "Sec. 2.1"},
          .says = "a kernel with a singularity at zero interpolates: 1e-9 h from a sample, "
                  "Shepard's quotient "
                  "has its value to 1e-9; that of poly6 has not",
          .bound = at_most(1e-9, "ω(1e-9 h) > 1e8 ω(0.4): 1/q against (1 − q)³/q at q = 4/7"),
          .measure = [] { return shepard_of_two(Singular<2>(0.7), 1e-9 * 0.7); },
          .sabotaged = [] { return shepard_of_two(Poly6<2>(0.7), 1e-9 * 0.7); }},
    Claim{.id = "singular.gradient_explodes",
          .source = {Paper::adams2009, "Sec. 2.1"},
          .says = "its gradients tend to infinity for nearby samples: r² |ω′| / h → σ / h^dim as r "
                  "→ 0, so "
                  "|ω′| ~ 1/r²; that of poly6 vanishes",
          .bound = between(0.999, 1.001, "(1 − q)² (1 + 2q) = 1 − 3q² at q = 1e-3"),
          .measure =
              [] {
                  const double r = 1e-3 * 0.7, sigma = 2 / pi<double>();
                  return -Singular<2>(0.7).derivative(r) * r * r * 0.7 / sigma;
              },
          .sabotaged =
              [] {
                  const double r = 1e-3 * 0.7, sigma = 2 / pi<double>();
                  return -Poly6<2>(0.7).derivative(r) * r * r * 0.7 / sigma;
              }},
};
}  // namespace
}  // namespace singular_claims
