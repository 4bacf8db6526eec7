#include "solver/approximation/moment_inverse.h"

#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_cloud.h"
#include "verification/framework/registry.h"

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace moment_inverse_claims {
namespace {
using namespace plumbline;
using namespace verification;
using Eigen::MatrixXd;
using Svd = Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner>;  // of square matrices

constexpr double u = 1.11e-16;  // unit roundoff

/// M = Σⱼ ωⱼ p(yⱼ) p(yⱼ)ᵀ with yⱼ = (xⱼ − centre) / scale                    adams2009 Eqs. 24, 28
template <int Order, int Dim>
MatrixXd moments(const Cloud<Dim>& cloud, const Vec<Dim>& centre, double scale) {
    using Basis = PolynomialBasis<Dim, Order>;
    const Poly6<Dim> w(cloud.support);
    MatrixXd M = MatrixXd::Zero(Basis::size, Basis::size);
    for (const auto& x : cloud.x) {
        const typename Basis::Vector p = Basis::at((x - centre) / scale);
        M += w.value((x - cloud.at).norm()) * p * p.transpose();
    }
    return M;
}
template <int Order, int Dim> MatrixXd moments(const Cloud<Dim>& cloud) {
    return moments<Order>(cloud, cloud.at, cloud.support);
}

/// The worst of measure(M) over moment matrices of 20 jittered clouds, order 2 in space: 10 × 10.
template <class Measure> double worst_over_clouds(Measure measure) {
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        worst = std::max(worst, measure(Mat<10>(moments<2>(jittered_cloud<3>(2.2, seed)))));
    return worst;
}

/// Plain sums: the blocked product that Eigen takes for matrices of any size compiles for seconds.
MatrixXd product(const MatrixXd& A, const MatrixXd& B) { return A.lazyProduct(B); }

double residual(const MatrixXd& M, const MatrixXd& G) {
    const MatrixXd R = product(M, G) - MatrixXd::Identity(M.rows(), M.cols());
    return one_norm(R) / (one_norm(M) * one_norm(G));
}
double residual_of_cholesky(const Mat<10>& M) {
    return residual(M, cholesky_inverse<10>(M).value().inverse);
}
/// L⁻¹ L⁻ᵀ instead of L⁻ᵀ L⁻¹.
double residual_of_swapped_factors(const Mat<10>& M) {
    const Mat<10> L = Eigen::LLT<Mat<10>>(M).matrixL();
    const Mat<10> inverse = L.inverse();
    return residual(M, product(inverse, inverse.transpose()));
}

constexpr std::array<int, 3> space_ends = PolynomialBasis<3, 2>::degree_ends;

double difference_of_both(const Mat<10>& M) {
    const auto fast = cholesky_inverse<10>(M).value();
    const auto safe = graded_inverse(M, space_ends).value();
    return one_norm(MatrixXd(fast.inverse - safe.inverse)) / one_norm(fast.inverse) /
           fast.condition;
}
/// The degrees inverted one by one, without the elimination of the lower ones.
double difference_without_elimination(const Mat<10>& M) {
    const auto fast = cholesky_inverse<10>(M).value();
    MatrixXd blocks = MatrixXd::Zero(10, 10);
    for (int g = 0, begin = 0; g < 3; begin = space_ends[g++]) {
        const int n = space_ends[g] - begin;
        blocks.block(begin, begin, n, n) = MatrixXd(M.block(begin, begin, n, n)).inverse();
    }
    return one_norm(MatrixXd(fast.inverse - blocks)) / one_norm(fast.inverse) / fast.condition;
}

/// Samples of a plane in space, seen from a point `above` it.
Cloud<3> planar(double above) {
    const auto flat = jittered_cloud<2>(2.8, 1);
    Cloud<3> cloud{{}, {flat.at[0], flat.at[1], above}, 2.8};
    for (const auto& x : flat.x) cloud.x.push_back({x[0], x[1], 0.0});
    return cloud;
}
double distance_from_generalised_inverse(const MatrixXd& M, const MatrixXd& G) {
    return std::max(one_norm(MatrixXd(product(product(M, G), M) - M)) / one_norm(M),
                    one_norm(MatrixXd(product(product(G, M), G) - G)) / one_norm(G)) /
           (one_norm(M) * one_norm(G));
}
double planar_generalised_inverse() {
    const MatrixXd M = moments<2>(planar(0.7));
    return distance_from_generalised_inverse(M, graded_inverse(M, space_ends)->inverse);
}
/// The usual way out: a small multiple of the identity is added.
double planar_shifted_inverse() {
    const MatrixXd M = moments<2>(planar(0.7));
    const MatrixXd G = (M + 1e-6 * M(0, 0) * MatrixXd::Identity(10, 10)).inverse();
    return distance_from_generalised_inverse(M, G);
}

/// |1 − e₀ᵀ M G e₀|: how far Σ Φⱼ is from 1, for samples of a plane and a point above it.
double lost_constants(const MatrixXd& M, const MatrixXd& G) {
    return std::abs(1.0 - M.row(0).dot(G.col(0)));
}
double constants_lost_by_graded_inverse() {
    const MatrixXd M = moments<1>(planar(0.7));
    return lost_constants(M, graded_inverse(M, PolynomialBasis<3, 1>::degree_ends)->inverse);
}
double constants_lost_by_pseudo_inverse() {
    const MatrixXd M = moments<1>(planar(0.7));
    const Svd svd(M, Eigen::ComputeFullU);
    const double smallest = moment_cut_off * svd.singularValues().maxCoeff();
    const Eigen::VectorXd inverted = svd.singularValues().unaryExpr(
        [&](double value) { return value > smallest ? 1.0 / value : 0.0; });
    const MatrixXd &vectors = svd.matrixU(), scaled = vectors * inverted.asDiagonal();
    return lost_constants(M, product(scaled, vectors.transpose()));
}

/// ‖M‖₂ ‖M⁻¹‖₂ of order 2 in the plane, samples 20 % off a square lattice of spacing `unit` whose
/// origin is `offset` spacings away.
double condition(double offset, double unit, bool centred, bool scaled) {
    auto cloud = jittered_cloud<2>(2.8, 1, 0.2);
    for (auto& x : cloud.x) x = unit * (x.array() + offset);
    cloud.at = unit * (cloud.at.array() + offset);
    cloud.support *= unit;
    const Vec<2> origin = Vec<2>::Zero();
    const MatrixXd M = moments<2>(cloud, centred ? cloud.at : origin, scaled ? cloud.support : 1.0);
    const Eigen::VectorXd values = Svd(M).singularValues();
    return values.maxCoeff() / values.minCoeff();
}
double growth_over_offsets(bool centred) {
    double worst = 0.0;
    for (const double offset : {1.0, 10.0, 100.0, 1e4})
        worst = std::max(
            worst, condition(offset, 1.0, centred, true) / condition(0.0, 1.0, true, true) - 1.0);
    return worst;
}
double growth_over_units(bool scaled) {
    double worst = 0.0;
    for (const double unit : {1e-3, 1e3})
        worst = std::max(
            worst, condition(0.0, unit, true, scaled) / condition(0.0, 1.0, true, scaled) - 1.0);
    return worst;
}
/// p in condition ~ offsetᵖ.
double power_of_offset(bool centred) {
    return std::log2(condition(20.0, 1.0, centred, false) / condition(10.0, 1.0, centred, false));
}

const Register claims{
    Claim{.id = "moment_inverse.cholesky_inverts",
          .source = {Paper::adams2009, "Eqs. 23, 24"},
          .says = "M M⁻¹ = I, by Cholesky, in units of the condition number κ",
          .bound = at_most(100 * u, "‖M G − I‖ ≤ N² u κ for an inverse by Cholesky, N = 10"),
          .measure = [] { return worst_over_clouds(residual_of_cholesky); },
          .sabotaged = [] { return worst_over_clouds(residual_of_swapped_factors); }},
    Claim{
        .id = "moment_inverse.both_ways_agree",
        .source = {Paper::plumbline, "docstring of moment_inverse"},
        .says = "where M is well conditioned, the graded inverse is the inverse by Cholesky",
        .bound = at_most(300 * u, "each is off by N² u κ, N = 10; eigenvectors add as much again"),
        .measure = [] { return worst_over_clouds(difference_of_both); },
        .sabotaged = [] { return worst_over_clouds(difference_without_elimination); }},
    Claim{.id = "moment_inverse.singular_matrix_has_a_generalised_inverse",
          .source = {Paper::adams2009, "Sec. 3.3"},
          .says = "M G M = M and G M G = G for coplanar samples of order 2 in space, rank 6 of 10",
          .bound = at_most(100 * u, "N² u ‖M‖ ‖G‖, N = 10"),
          .measure = planar_generalised_inverse,
          .sabotaged = planar_shifted_inverse},
    Claim{.id = "moment_inverse.constants_survive_off_the_plane",
          .source = {Paper::adams2009, "Sec. 3.3"},
          .says =
              "coplanar samples seen from above their plane: e₀ᵀ M G e₀ = 1, where the truncated "
              "singular value decomposition of M loses the constants",
          .bound = at_most(1e-13, "N² u ‖M‖ ‖G‖ with N = 4, ‖M‖ ‖G‖ < 50"),
          .measure = constants_lost_by_graded_inverse,
          .sabotaged = constants_lost_by_pseudo_inverse},
    Claim{.id = "moment_inverse.centred_condition_ignores_the_offset",
          .source = {Paper::adams2009, "Eqs. 28, 29"},
          .says = "the condition number of the centred and scaled M is the same 1 to 1e4 spacings "
                  "from the origin",
          .bound = at_most(1e-8,
                           "relative growth: coordinates of 1e4 spacings are off by 1e-12, "
                           "which the smallest eigenvalue feels κ ≈ 100 times: 1e-10"),
          .measure = [] { return growth_over_offsets(true); },
          .sabotaged = [] { return growth_over_offsets(false); }},
    Claim{.id = "moment_inverse.raw_condition_grows_with_the_offset",
          .source = {Paper::adams2009, "Eqs. 24, 28"},
          .says =
              "without centring, the condition number of order 2 grows like the 8th power of the "
              "distance L from the origin: 1e9 at 10 spacings, beyond double precision at 100",
          .bound = between(7.5, 8.5,
                           "moments of degree 4 make λ_max ~ L⁴; x² is known by its "
                           "deviation from its tangent only, so λ_min ~ L⁻⁴"),
          .measure = [] { return power_of_offset(false); },
          .sabotaged = [] { return power_of_offset(true); }},
    Claim{.id = "moment_inverse.scaled_condition_ignores_the_unit",
          .source = {Paper::adams2009, "Eqs. 28, 29"},
          .says =
              "the condition number of the scaled M is the same in km, m and mm; unscaled, that "
              "of order 2 changes by 1e12",
          .bound = at_most(1e-11,
                           "relative growth: the change of units rounds by 2 u = 2.2e-16, "
                           "which the smallest eigenvalue feels κ ≈ 100 times, in each of 24 "
                           "samples"),
          .measure = [] { return growth_over_units(true); },
          .sabotaged = [] { return growth_over_units(false); }},
};
}  // namespace
}  // namespace moment_inverse_claims
