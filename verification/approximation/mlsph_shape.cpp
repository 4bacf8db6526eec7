#include "solver/approximation/mlsph_shape.h"

#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_cloud.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

#include <algorithm>

namespace mlsph_shape_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

/// The n samples closest to the point, in space.
Cloud<3> closest(std::size_t n) {
    auto cloud = jittered_cloud<3>(2.2, 1);
    std::ranges::sort(cloud.x, {}, [&](const Vec<3>& x) { return (x - cloud.at).norm(); });
    cloud.x.resize(n);
    return cloud;
}
template <class Shape, int Dim> auto evaluate(const Cloud<Dim>& cloud) {
    return shape_at(Shape(Poly6<Dim>(cloud.support)), cloud);
}
template <int Order> using Variable3 = MlsphShape<Order, Poly6<3>>;

template <int Dim>
double largest_difference(const ShapeFunctions<Dim>& a, const ShapeFunctions<Dim>& b) {
    double worst = 0.0;
    for (std::size_t j = 0; j < a.phi.size(); ++j)
        worst =
            std::max({worst, std::abs(a.phi[j] - b.phi[j]), (a.grad_phi[j] - b.grad_phi[j]).norm(),
                      std::abs(a.laplace_phi[j] - b.laplace_phi[j])});
    return worst;
}
double distance_from_mls(std::size_t n_samples) {
    const auto cloud = closest(n_samples);
    return largest_difference(evaluate<Variable3<2>>(cloud),
                              evaluate<MlsShape<2, Poly6<3>>>(cloud));
}
double distance_from_shepard(std::size_t n_samples) {
    const auto cloud = closest(n_samples);
    return largest_difference(evaluate<Variable3<2>>(cloud),
                              evaluate<MlsShape<0, Poly6<3>>>(cloud));
}

/// The order in use × 1, 10, 100, … for 1, 4, 10 and 40 samples: as decimal digits.
double orders(const std::array<std::size_t, 4>& counts) {
    double digits = 0.0;
    for (const std::size_t n : counts)
        digits = 10.0 * digits + evaluate<Variable3<2>>(closest(n)).fit[0]->order;
    return digits;
}

/// The largest change of ⟨f⟩ between neighbouring ones of 4000 points on a line, per change of f, from
/// the middle of a square lattice to outside of it.
template <class Shape> double largest_jump(double f_exponent) {
    Cloud<2> cloud = jittered_cloud<2>(2.0, 1, 0.0);
    const auto f = sampled(cloud, [&](const Vec<2>& x) { return std::pow(x[0], f_exponent); });
    double before = 0.0, worst = 0.0;
    for (int k = 0; k <= 4000; ++k) {
        cloud.at = {0.3 + 4.5 * k / 4000, 0.2};
        const double value = *evaluate<Shape>(cloud).value(f, 0);
        if (k > 0) worst = std::max(worst, std::abs(value - before));
        before = value;
    }
    return worst;
}

const Register claims{
    Claim{.id = "mlsph_shape.is_mls_where_that_is_determined",
          .source = {Paper::adams2009, "Sec. 4"},
          .says = "with samples enough MLSPH is MLS of the highest order, bit for bit",
          .bound = at_most(0, "the same code on the same numbers"),
          .measure = [] { return distance_from_mls(40); },
          .sabotaged = [] { return distance_from_mls(7); }},
    Claim{.id = "mlsph_shape.is_shepard_for_an_isolated_pair",
          .source = {Paper::adams2009, "Sec. 4"},
          .says = "two samples in space: MLSPH falls to order 0, Shepard's method, bit for bit",
          .bound = at_most(0, "the same code on the same numbers"),
          .measure = [] { return distance_from_shepard(2); },
          .sabotaged = [] { return distance_from_shepard(6); }},
    Claim{.id = "mlsph_shape.states_the_order_in_use",
          .source = {Paper::adams2009, "Sec. 4"},
          .says = "1, 3, 7 and 40 samples in space: orders 0, 0, 1 and 2",
          .bound = between(12, 12, "order 1 needs 4 samples, order 2 needs 10: digits 0012"),
          .measure =
              [] {
                  return orders({1, 3, 7, 40});
              },
          .sabotaged =
              [] {
                  return orders({1, 5, 7, 40});
              }},
    Claim{.id = "mlsph_shape.jumps_where_the_order_changes",
          .source = {Paper::adams2009, "Sec. 4"},
          .says = "on a line that leaves the samples ⟨x²⟩ jumps, since the order falls; for MLS of "
                  "order 0, which never falls, it does not",
          .bound = at_least(0.05,
                            "steps are 1e-3 spacings; what is continuous with slopes below 20 "
                            "changes by 0.02"),
          .measure = [] { return largest_jump<MlsphShape<2, Poly6<2>>>(2.0); },
          .sabotaged = [] { return largest_jump<MlsShape<0, Poly6<2>>>(2.0); }},
};
}  // namespace
}  // namespace mlsph_shape_claims
