#include "solver/approximation/mls_shape.h"

#include "solver/approximation/polynomial_basis.h"
#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_under_test.h"
#include "verification/approximation/printed_mls.h"
#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

#include <fmt/format.h>
#include <Eigen/Cholesky>

namespace mls_derivatives_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;
template <int Order, class K> using MlsShape = MlsUnderTest<Order, K>;

constexpr double support(int order) { return order < 3 ? 2.8 : 3.6; }
template <int Dim> Cloud<Dim> shifted_cloud(int order) {
    auto cloud = jittered_cloud<Dim>(support(order), 7);
    for (auto& x : cloud.x) x.array() += 3.0;
    cloud.at.array() += 3.0;
    return cloud;
}
template <int Order, int Dim>
auto solver_shape(const Cloud<Dim>& cloud, MlsDerivative derivative = MlsDerivative::full) {
    return shape_at(MlsShape<Order, Poly6<Dim>>(Poly6<Dim>(cloud.support), derivative), cloud);
}

double distance(double computed, const Real50& exact) {
    return std::abs((Real50(computed) - exact).convert_to<double>());
}

/// maxⱼ |Φⱼ − exact| / κ where the weights have the given support.
template <int Dim, int Order> double error_of_values(double support_of_weights) {
    const auto cloud = shifted_cloud<Dim>(Order);
    auto weighted = cloud;
    weighted.support = support_of_weights;
    const auto shape = solver_shape<Order>(weighted);
    const PrintedMls<Real50, Dim> printed(Order, cloud);
    const auto exact = printed.shape(printed.point(cloud.at));
    double worst = 0.0;
    for (std::size_t j = 0; j < exact.size(); ++j)
        worst = std::max(worst, distance(shape.phi[j], exact[j]));
    return worst / shape.fit[0]->condition;
}

/// maxⱼ h |∇Φⱼ − exact| / κ for the given gradients.
template <int Dim>
double error_of_gradients(const Cloud<Dim>& cloud, int order, const ShapeFunctions<Dim>& shape,
                          const std::vector<Vec<Dim>>& gradients) {
    const PrintedMls<Real50, Dim> printed(order, cloud);
    double worst = 0.0;
    for (int d = 0; d < Dim; ++d) {
        const auto exact = printed.slope(printed.point(cloud.at), d, Real50("1e-15"));
        for (std::size_t j = 0; j < exact.size(); ++j)
            worst = std::max(worst, cloud.support * distance(gradients[j][d], exact[j]));
    }
    return worst / shape.fit[0]->condition;
}
template <int Dim, int Order> double error_of_gradients(MlsDerivative derivative) {
    const auto cloud = shifted_cloud<Dim>(Order);
    const auto shape = solver_shape<Order>(cloud, derivative);
    return error_of_gradients(cloud, Order, shape, shape.grad_phi);
}

template <int Dim, int Order> double error_of_laplacians(MlsDerivative derivative) {
    const auto cloud = shifted_cloud<Dim>(Order);
    const auto shape = solver_shape<Order>(cloud, derivative);
    const PrintedMls<Real50, Dim> printed(Order, cloud);
    const auto exact = printed.laplacian(printed.point(cloud.at), Real50("1e-11"));
    const double h2 = cloud.support * cloud.support;
    double worst = 0.0;
    for (std::size_t j = 0; j < exact.size(); ++j)
        worst = std::max(worst, h2 * distance(shape.laplace_phi[j], exact[j]));
    return worst / shape.fit[0]->condition;
}

/// M is known to N (k + 3) u and solved to N² u, which κ amplifies; `more` for what derivatives of the
/// weights add.
template <int Dim, int Order> Bound rounding(double more, const char* of_what) {
    const auto n = static_cast<double>(PolynomialBasis<Dim, Order>::size);
    const auto k = static_cast<double>(shifted_cloud<Dim>(Order).near().indices.size());
    return at_most(
        more * n * (k + 3.0 + n) * 0x1p-53,
        fmt::format(
            "with u = 2⁻⁵³, N = {} monomials and k = {} neighbours M is known to N (k + 3) u and "
            "solved to N² u, which κ amplifies{}",
            n, k, of_what));
}

template <int Dim, int Order> void add_oracle_claims(std::vector<Claim>& claims) {
    const auto id = [](const char* what) {
        return fmt::format("mls_shape.{}_of_order_{}_to_50_digits_{}d", what, Order, Dim);
    };
    claims.push_back(
        {.id = id("value"),
         .source = {Paper::adams2009, "Eqs. 23-27, 29"},
         .says = fmt::format("Φⱼ of order {} from the centred and scaled basis is Eq. 27 with raw "
                             "monomials in 50 digits",
                             Order),
         .bound = rounding<Dim, Order>(1.0, ""),
         .measure = [] { return error_of_values<Dim, Order>(support(Order)); },
         .sabotaged =
             [] { return error_of_values<Dim, Order>(static_cast<float>(support(Order))); }});
    claims.push_back(
        {.id = id("gradient"),
         .source = {Paper::adams2009, "Eqs. 30, 31"},
         .says =
             fmt::format("∇Φⱼ of order {} is the slope of Eq. 27 by differences in 50 digits; the "
                         "diffuse derivative is not",
                         Order),
         .bound = rounding<Dim, Order>(5.0, "; derivatives of the weights add h|∇ω|/ω ≈ 5"),
         .measure = [] { return error_of_gradients<Dim, Order>(MlsDerivative::full); },
         .sabotaged = [] { return error_of_gradients<Dim, Order>(MlsDerivative::diffuse); }});
    claims.push_back(
        {.id = id("laplacian"),
         .source = {Paper::adams2009, "Eq. 34"},
         .says = fmt::format(
             "ΔΦⱼ of order {} is the Laplacian of Eq. 27 by differences in 50 digits", Order),
         .bound = rounding<Dim, Order>(22.0, "; h²|Δω|/ω ≈ 22 in the mean over the support"),
         .measure = [] { return error_of_laplacians<Dim, Order>(MlsDerivative::full); },
         .sabotaged = [] { return error_of_laplacians<Dim, Order>(MlsDerivative::diffuse); }});
}

std::vector<Claim> oracle_claims() {
    std::vector<Claim> claims;
    add_oracle_claims<1, 1>(claims);
    add_oracle_claims<1, 2>(claims);
    add_oracle_claims<2, 1>(claims);
    add_oracle_claims<2, 2>(claims);
    add_oracle_claims<3, 1>(claims);
    add_oracle_claims<3, 2>(claims);
    return claims;
}
const Register oracle{oracle_claims()};

/// d/dx of ⟨x⟩ of order 1 as Eqs. 29 and 30 read together: only ω and M depend on x, since p(0) is
/// constant in Eq. 29 and Eq. 30 does not differentiate p(xᵢ).
double slope_of_x_as_printed() {
    using Basis = PolynomialBasis<2, 1>;
    const auto cloud = jittered_cloud<2>(2.8, 1);
    const Poly6<2> w(2.8);
    Mat<3> M = Mat<3>::Zero(), dM = Mat<3>::Zero();
    Vec<3> right = Vec<3>::Zero(), d_right = Vec<3>::Zero();
    for (const auto& x : cloud.x) {
        const Vec<3> p = Basis::at((x - cloud.at) / 2.8);
        const Vec<2> d = cloud.at - x;
        M += w.value(d.norm()) * p * p.transpose();
        dM += gradient(w, d)[0] * p * p.transpose();
        right += w.value(d.norm()) * x[0] * p;
        d_right += gradient(w, d)[0] * x[0] * p;
    }
    const Vec<3> a = M.ldlt().solve(right);
    return M.ldlt().solve(Vec<3>(d_right - dM * a))[0];
}
double slope_of_x() {
    const auto cloud = jittered_cloud<2>(2.8, 1);
    const auto x = sampled(cloud, [](const Vec<2>& p) { return p[0]; });
    return (*solver_shape<1>(cloud).gradient(x, 0))[0];
}

/// Error of h ∇⟨q⟩ and h² Δ⟨q⟩ over monomials of degree ≤ `degree`, per κ: with the diffuse derivative.
double diffuse_inconsistency(int degree) {
    const auto cloud = jittered_cloud<2>(2.8, 3);
    const auto shape = solver_shape<2>(cloud, MlsDerivative::diffuse);
    double worst = 0.0;
    for (const auto& q : monomials<2>(degree, Vec<2>::Constant(2.8), 2.8)) {
        const auto f = sampled(cloud, [&](const Vec<2>& x) { return q.value(x); });
        worst = std::max({worst, 2.8 * (*shape.gradient(f, 0) - q.gradient(cloud.at)).norm(),
                          2.8 * 2.8 * std::abs(*shape.laplacian(f, 0) - q.laplacian(cloud.at))});
    }
    return worst / shape.fit[0]->condition;
}

/// Relative difference between the stencils of ∇⟨f⟩ of order 1 and of the given derivative.
double difference_from_full(MlsDerivative derivative) {
    const auto cloud = jittered_cloud<2>(2.8, 3);
    const auto full = solver_shape<1>(cloud).grad_phi;
    const auto other = solver_shape<1>(cloud, derivative).grad_phi;
    double apart = 0.0, size = 0.0;
    for (std::size_t j = 0; j < full.size(); ++j) {
        apart += (full[j] - other[j]).squaredNorm();
        size += full[j].squaredNorm();
    }
    return std::sqrt(apart / size);
}

/// Consistency of order 2 with random vectors in the place of ∇ω and Δω, or weights of random size.
double inconsistency_with_random_weights(int degree) {
    const auto cloud = jittered_cloud<2>(2.8, 5);
    Random random(9);
    auto shape = solver_shape<2>(cloud);
    for (std::size_t j = 0; j < shape.phi.size(); ++j) {
        shape.phi[j] = random.uniform(0.1, 1.0);
        shape.grad_phi[j] = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
        shape.laplace_phi[j] = random.uniform(-1.0, 1.0);
    }
    const auto near = cloud.near();
    shape.fit[0] = mls_from_weights<2, 2>(cloud.x, {cloud.at, near.of(0)}, 2.8,
                                          {shape.phi, shape.grad_phi, shape.laplace_phi});
    double worst = 0.0;
    for (const auto& q : monomials<2>(degree, Vec<2>::Constant(2.8), 2.8)) {
        const auto f = sampled(cloud, [&](const Vec<2>& x) { return q.value(x); });
        worst = std::max({worst, std::abs(*shape.value(f, 0) - q.value(cloud.at)),
                          2.8 * (*shape.gradient(f, 0) - q.gradient(cloud.at)).norm(),
                          2.8 * 2.8 * std::abs(*shape.laplacian(f, 0) - q.laplacian(cloud.at))});
    }
    return worst / shape.fit[0]->condition;
}

const Register claims{
    Erratum{.number = 25,
            .source = {Paper::adams2009, "Eqs. 29, 30"},
            .printed = "Eq. 30 is applied to the centred basis of Eq. 29, whose p(0) is constant",
            .corrected = "the centre is frozen at x: p((y − x)/h) is differentiated in y at y = x"},
    &eq_30_with_centred_basis,
    Claim{.id = "mls_shape.slope_of_x_is_one",
          .source = {Paper::adams2009, "Eqs. 29-31"},
          .says = "∂⟨x⟩/∂x = 1 with a centred basis; as printed it is 0",
          .bound = between(1.0 - 1e-12, 1.0 + 1e-12, "N² u κ with N = 3, κ = 11: 1e-14"),
          .measure = slope_of_x,
          .sabotaged = slope_of_x_as_printed,
          .erratum = 25},
    Claim{.id = "mls_shape.diffuse_derivative_is_consistent",
          .source = {Paper::adams2009, "Sec. 3.2"},
          .says =
              "the diffuse derivatives of order 2, which treat the weights as constant, are exact "
              "for quadratic polynomials",
          .bound = at_most(1e-12, "‖M G − I‖ ≤ N² u κ: 4e-15 κ for N = 6"),
          .measure = [] { return diffuse_inconsistency(2); },
          .sabotaged = [] { return diffuse_inconsistency(3); }},
    Claim{.id = "mls_shape.diffuse_derivative_is_another_stencil",
          .source = {Paper::plumbline, "docstring of MlsDerivative"},
          .says = "the diffuse gradient is not the gradient of ⟨f⟩: its stencil differs by tens of "
                  "per cent",
          .bound = at_least(0.1,
                            "the terms left out, fⱼ ∂ωⱼ b·pⱼ, are as large as the others; 0 would "
                            "mean that they are the same"),
          .measure = [] { return difference_from_full(MlsDerivative::diffuse); },
          .sabotaged = [] { return difference_from_full(MlsDerivative::full); }},
    Claim{.id = "mls_shape.any_weights_are_consistent",
          .source = {Paper::adams2009, "Sec. 3.1"},
          .says = "weights need no form: random ones, with random numbers in the place of their "
                  "derivatives, leave order 2 consistent in value, gradient and Laplacian",
          .bound = at_most(1e-12, "‖M G − I‖ ≤ N² u κ: 4e-15 κ for N = 6, times |∂ω|/ω ≤ 10"),
          .measure = [] { return inconsistency_with_random_weights(2); },
          .sabotaged = [] { return inconsistency_with_random_weights(3); }},
};
}  // namespace
}  // namespace mls_derivatives_claims
