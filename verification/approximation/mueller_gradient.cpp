#include "solver/approximation/mueller_gradient.h"

#include "solver/approximation/mls_shape.h"
#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_cloud.h"
#include "verification/framework/patch.h"
#include "verification/framework/registry.h"

#include <fmt/format.h>
#include <Eigen/LU>

namespace mueller_gradient_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> double linear(const Vec<Dim>& x) {
    double value = 1.0;
    for (int d = 0; d < Dim; ++d) value += (d + 2) * x[d];
    return value;
}
template <int Dim> double quadratic(const Vec<Dim>& x) { return linear<Dim>(x) + x[0] * x[0]; }
template <int Dim> Vec<Dim> slope() {
    Vec<Dim> g;
    for (int d = 0; d < Dim; ++d) g[d] = d + 2;
    return g;
}
template <int Dim> Patch<Dim> bulk() { return {1.0, 2.5, 0.3}; }
/// The sample at the corner of a quadrant (octant) of samples.
template <int Dim> Patch<Dim> corner() {
    return {cubic_lattice<Dim>(1.0), {.support = 2.5, .jitter = 0.3, .free_faces = Dim}};
}

template <int Dim> double error(const Patch<Dim>& patch, double (*f)(const Vec<Dim>&)) {
    const auto values = patch.sample(f);
    return (*mueller_gradient(Poly6<Dim>(2.5), patch.samples(), values, patch.centre) -
            slope<Dim>())
        .norm();
}

template <int Dim> std::vector<Claim> exactness() {
    const auto claim = [](const char* where, Patch<Dim> (*make)()) {
        return Claim{
            .id = fmt::format("mueller_gradient.exact_for_linear_fields_{}_{}d", where, Dim),
            .source = {Paper::adams2009, "Eqs. 35-38"},
            .says = fmt::format("∇f is exact for linear f on irregular samples, {}", where),
            .bound = at_most(1e-12,
                             "A⁻¹ is off by d² u κ = 9 · 1.1e-16 · 100, ∇f by 5 times that; "
                             "rounding of f below 40: 40 u / 0.5"),
            .measure = [=] { return error<Dim>(make(), linear<Dim>); },
            .sabotaged = [=] { return error<Dim>(make(), quadratic<Dim>); }};
    };
    return {claim("bulk", bulk<Dim>), claim("corner", corner<Dim>)};
}
const Register exact_2d{exactness<2>()};
const Register exact_3d{exactness<3>()};

/// How many of 2000 random changes of g make E = Σ ω (fᵢⱼ − g·xᵢⱼ)² smaller.
double better_gradients(bool squared_weights) {
    const auto patch = bulk<2>();
    const Poly6<2> w(2.5);
    Random random(1);
    const auto f = patch.sample([&](const Vec<2>&) { return random.uniform(-1.0, 1.0); });
    const Index i = patch.centre;
    const auto E = [&](const Vec<2>& g) {
        double total = 0.0;
        for (const Index j : patch.neighbours.of(i)) {
            const Vec<2> d = patch.x[j] - patch.x[i];
            const double weight = w.value(d.norm());
            total +=
                (squared_weights ? weight * weight : weight) * std::pow(f[j] - f[i] - g.dot(d), 2);
        }
        return total;
    };
    const Vec<2> g = *mueller_gradient(w, patch.samples(), f, i);
    int better = 0;
    for (int trial = 0; trial < 2000; ++trial)
        better += E(g + Vec<2>{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)}) < E(g);
    return better;
}

/// Samples of the plane z = 0, or a little off it, about one in the middle.
Cloud<3> nearly_planar(double out_of_plane) {
    const auto flat = jittered_cloud<2>(2.5, 4);
    Random random(2);
    Cloud<3> cloud{{}, {}, 2.5};
    for (const auto& x : flat.x)
        cloud.x.push_back({x[0], x[1], out_of_plane * random.uniform(-1.0, 1.0)});
    cloud.at = cloud.x[cloud.x.size() / 2];
    return cloud;
}
/// 1 if there is an answer at the middle sample.
double has_answer(const Cloud<3>& cloud) {
    const auto near = cloud.near();
    const NeighbourLists lists{{0, near.indices.size()}, near.indices};
    const auto i = near.of(0);
    return mueller_inverse(Poly6<3>(2.5), std::span<const Vec<3>>(cloud.x), {cloud.at, i})->rank ==
           3;
}

template <int Dim> auto both_forms(double (*f)(const Vec<Dim>&)) {
    const auto patch = bulk<Dim>();
    const Poly6<Dim> w(2.5);
    const auto values = patch.sample(f);
    const std::array at{patch.x[patch.centre]};
    const auto near = patch.neighbours.of(patch.centre);
    const NeighbourLists lists{{0, near.size()}, {near.begin(), near.end()}};
    const auto shape = precompute<MuellerShape<Poly6<Dim>>>(MuellerShape<Poly6<Dim>>(w), patch.x,
                                                            at, lists, Derivatives::gradient);
    const auto mls = precompute<MlsShape<1, Poly6<Dim>>>(MlsShape<1, Poly6<Dim>>(w), patch.x, at,
                                                         lists, Derivatives::gradient);
    return std::array{*mueller_gradient(w, patch.samples(), values, patch.centre),
                      *shape.gradient(values, 0), *mls.gradient(values, 0)};
}
double wave(const Vec<2>& x) { return std::sin(2.0 * x[0] + x[1]); }

/// log₂ of how much |fⱼ − fᵢ − ∇f(xᵢ)·xᵢⱼ| falls where xᵢⱼ = ± (xⱼ − xᵢ) is halved.
double order_of_expansion(double sign) {
    const Vec<2> x_i{0.3, 0.2}, towards{0.8, 0.6};
    const Vec<2> grad = std::cos(2.0 * x_i[0] + x_i[1]) * Vec<2>{2.0, 1.0};
    const auto rest = [&](double r) {
        const Vec<2> x_j = x_i + r * towards;
        return std::abs(wave(x_j) - wave(x_i) - sign * grad.dot(x_j - x_i));
    };
    return std::log2(rest(2e-3) / rest(1e-3));
}

const Register claims{
    Claim{.id = "mueller_gradient.minimises_the_weighted_squares",
          .source = {Paper::adams2009, "Eqs. 36-38"},
          .says = "no other gradient fits fⱼ − fᵢ ≈ ∇f · xᵢⱼ better in the weights ω: of 2000 "
                  "tried, 0 do",
          .bound = at_most(0, "E is convex, and ∇f is where its derivative vanishes"),
          .measure = [] { return better_gradients(false); },
          .sabotaged = [] { return better_gradients(true); }},
    Claim{.id = "mueller_gradient.expands_around_the_sample",
          .source = {Paper::adams2009, "Eq. 35"},
          .says = "fⱼ = fᵢ + ∇f·xᵢⱼ + O(xᵢⱼ²) with xᵢⱼ = xⱼ − xᵢ: the order of what is left for a "
                  "wave",
          .bound =
              between(2.0009, 2.0012,
                      "along a unit step, with s = 2.2 and φ = 0.8, the rest is s² r² sin φ/2 "
                      "(1 + s r cot φ/3 + …): from r = 2e-3 to 1e-3 the bracket falls by 7.1e-4, "
                      "which is 1.03e-3 of an order; (s r)² and rounding, 2e-16 of 1.7e-6, are "
                      "below 1e-5"),
          .measure = [] { return order_of_expansion(1.0); },
          .sabotaged = [] { return order_of_expansion(-1.0); }},
    Claim{.id = "mueller_gradient.needs_neighbours_that_span_the_space",
          .source = {Paper::adams2009, "Sec. 3.3; Eq. 38"},
          .says = "coplanar samples in space: A is singular, and the answer is empty",
          .bound = at_most(0, "1 would be an answer"),
          .measure = [] { return has_answer(nearly_planar(0.0)); },
          .sabotaged = [] { return has_answer(nearly_planar(0.1)); }},
    Claim{.id = "mueller_gradient.is_not_the_gradient_of_mls",
          .source = {Paper::adams2009, "Eqs. 32, 37"},
          .says = "Eq. 37 and the gradient of the MLS approximation of order 1, Eq. 32, are two "
                  "approximations: they differ for a wave",
          .bound = at_least(1e-3,
                            "both are exact for linear fields only; 0 would mean that one is "
                            "the other"),
          .measure =
              [] {
                  const auto g = both_forms<2>(wave);
                  return (g[0] - g[2]).norm();
              },
          .sabotaged =
              [] {
                  const auto g = both_forms<2>(linear<2>);
                  return (g[0] - g[2]).norm();
              }},
    Claim{.id = "mueller_gradient.shape_functions_give_the_same",
          .source = {Paper::adams2009, "Eqs. 37, 39"},
          .says = "the gradient from precomputed ∇Φⱼ is that of Eq. 37",
          .bound = at_most(1e-13, "24 terms below 10, added in another order"),
          .measure =
              [] {
                  const auto g = both_forms<2>(wave);
                  return (g[0] - g[1]).norm();
              },
          .sabotaged =
              [] {
                  const auto g = both_forms<2>(wave);
                  return (g[0] - g[2]).norm();
              }},
};
}  // namespace
}  // namespace mueller_gradient_claims
