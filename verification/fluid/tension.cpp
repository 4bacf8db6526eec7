#include "solver/fluid/tension.h"

#include "verification/framework/registry.h"

#include <cmath>

namespace tension_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// max |p′ − expected| over pressures −2 … 2, with ζ = 1/4.
double error(double zeta) {
    Pressure p;
    p.assign({-2.0, -0.5, 0.0, 0.5, 2.0});
    ScaleTension{zeta}.run(0.1, p);
    const double expected[] = {-0.5, -0.125, 0.0, 0.5, 2.0};
    double worst = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
        worst = std::max(worst, std::abs(p[i] - expected[i]));
    return worst;
}

const Register claims_of_tension{
    Claim{.id = "tension.scales_negative_pressures",
          .source = {Paper::adams2009, "Eq. 54"},
          .says = "p′ = p where p ≥ 0, ζ p where p < 0",
          .bound = at_most(0.0, "products with a power of two are exact"),
          .measure = [] { return error(0.25); },
          .sabotaged = [] { return error(1.0); }}};
}  // namespace
}  // namespace tension_claims
