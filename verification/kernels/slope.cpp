#include "solver/kernels/slope.h"

#include "solver/foundation/lanes.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace slope_claims {
namespace {
using namespace plumbline;
using namespace verification;

double first(double x) { return x; }
template <class Real> double first(Lanes<Real> x) { return static_cast<double>(x.v[0]); }

/// max |slope(r) − ω′(r)/r| / |ω″(0)| for r from h/100 to 1.2 h.
template <int Dim, class Number> double error(double support_of_slope) {
    const double h = 0.7;
    const WendlandC2<Dim> w(h);
    const SlopeOverRadius<WendlandC2<Dim>> slope(WendlandC2<Dim>(support_of_slope * h));
    double worst = 0.0;
    for (int k = 1; k <= 120; ++k) {
        const double r = 0.01 * k * h;
        worst = std::max(worst, std::abs(first(slope(Number(r))) - w.derivative(r) / r));
    }
    return worst / std::abs(w.second_derivative(0.0));
}

const Register in_double{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "slope.is_that_of_the_kernel",
                 .source = {Paper::plumbline, "docstring of SlopeOverRadius"},
                 .says = "ω′(r)/r without a division, for r from h/100 to 1.2 h, over |ω″(0)|",
                 .bound = at_most(2.5e-15,
                                  "1 − q is off by 2 roundings, its cube by 3 times that and 2 "
                                  "products, ω(0)/h² by 5, the reference by 9: 22 · 1.1e-16"),
                 .measure = [] { return error<D, double>(1.0); },
                 .sabotaged = [] { return error<D, double>(1.0 + 1e-12); }};
})};
const Register in_single{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "slope.in_single_precision",
                 .source = {Paper::plumbline, "docstring of SlopeOverRadius"},
                 .says = "the same in lanes of single precision",
                 .bound = at_most(8e-7,
                                  "r and 1/h rounded, their product and 1 − q: 4 roundings, three "
                                  "times in the cube, the factor and 3 products: 16 · 6e-8 less "
                                  "than 1e-6, and q (1 − q)² ≤ 0.15 for two of the four"),
                 .measure = [] { return error<D, Lanes<float>>(1.0); },
                 .sabotaged = [] { return error<D, Lanes<float>>(1.00001); }};
})};
}  // namespace
}  // namespace slope_claims
