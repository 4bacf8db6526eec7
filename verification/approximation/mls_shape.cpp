#include "solver/approximation/mls_shape.h"

#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_under_test.h"
#include "verification/approximation/printed_mls.h"
#include "verification/framework/eigenvalues.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <numbers>

namespace mls_shape_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;
template <int Order, class K> using MlsShape = MlsUnderTest<Order, K>;

enum class Quantity { value, gradient, laplacian };

/// The support in spacings; order 3 has more to determine.
constexpr double support(int order) { return order < 3 ? 2.8 : 3.6; }

/// The largest error of ⟨q⟩, h ∇⟨q⟩ or h² Δ⟨q⟩ over the monomials q of degree ≤ `degree` about a
/// point that is a support away, in units of the condition number; over 10 jittered clouds.
template <int Dim, int Order> double inconsistency(Quantity quantity, int degree) {
    constexpr double h = support(Order);
    const MlsShape<Order, Poly6<Dim>> mls{Poly6<Dim>(h)};
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const auto cloud = jittered_cloud<Dim>(h, seed);
        const auto shape = shape_at(mls, cloud);
        for (const auto& q : monomials<Dim>(degree, Vec<Dim>::Constant(h), h)) {
            const auto f = sampled(cloud, [&](const Vec<Dim>& x) { return q.value(x); });
            double error = 0.0;
            if (quantity == Quantity::value)
                error = *shape.value(f, 0) - q.value(cloud.at);
            else if (quantity == Quantity::gradient)
                error = h * (*shape.gradient(f, 0) - q.gradient(cloud.at)).norm();
            else
                error = h * h * (*shape.laplacian(f, 0) - q.laplacian(cloud.at));
            worst = std::max(worst, std::abs(error) / shape.fit[0]->condition);
        }
    }
    return worst;
}

struct Row {
    Quantity quantity;
    const char *name, *source, *says;
};
constexpr Row rows[] = {
    {Quantity::value, "value", "Eqs. 25, 26, 27, 41; Sec. 3.2", "⟨q⟩ = q"},
    {Quantity::gradient, "gradient", "Eqs. 30-32; Sec. 3.2", "∇⟨q⟩ = ∇q"},
    {Quantity::laplacian, "laplacian", "Eq. 34; Sec. 3.2", "Δ⟨q⟩ = Δq"},
};

template <int Dim, int Order> void add_consistency(std::vector<Claim>& claims) {
    for (const Row& row : rows)
        claims.push_back(
            {.id = fmt::format("mls_shape.{}_of_order_{}_is_consistent_{}d", row.name, Order, Dim),
             .source = {Paper::adams2009, row.source},
             .says = fmt::format("{} for every polynomial q of degree ≤ {} in {}D, on irregular "
                                 "samples",
                                 row.says, Order, Dim),
             .bound =
                 at_most(1e-12,
                         "error / condition number κ of M: ‖M G − I‖ ≤ N² u κ for an inverse by "
                         "Cholesky, N ≤ 20, u = 1.1e-16: 4.4e-14 κ; the derivatives of the "
                         "weights multiply it by h ∫|∇ω| = 5 and h² ∫|Δω| = 22 (poly6)"),
             .measure = [q = row.quantity] { return inconsistency<Dim, Order>(q, Order); },
             .sabotaged = [q = row.quantity] { return inconsistency<Dim, Order>(q, Order + 1); }});
}

std::vector<Claim> consistency() {
    std::vector<Claim> claims;
    [&]<int... Order>(std::integer_sequence<int, Order...>) {
        (add_consistency<1, Order>(claims), ...);
        (add_consistency<2, Order>(claims), ...);
        (add_consistency<3, Order>(claims), ...);
    }
    (std::make_integer_sequence<int, 4>{});
    return claims;
}

const Register claims_of_consistency{consistency()};

template <int Order, int Dim> auto shape_of(const Cloud<Dim>& cloud) {
    return shape_at(MlsShape<Order, Poly6<Dim>>(Poly6<Dim>(cloud.support)), cloud);
}

template <int Dim> Cloud<Dim> random_cloud() {
    return jittered_cloud<Dim>(2.8, static_cast<std::uint64_t>(uniform(0.0, 1e6)));
}
/// maxⱼ |Φⱼ − Φ′ⱼ| of the same samples before and after a change.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) worst = std::max(worst, std::abs(a[j] - b[j]));
    return worst;
}
using Values = std::vector<double> (*)(const Cloud<2>&);
std::vector<double> centred_values(const Cloud<2>& c) { return shape_of<2>(c).phi; }
std::vector<double> raw_values(const Cloud<2>& c) {
    const PrintedMls<double, 2> printed(2, c);
    return printed.shape(printed.point(c.at));
}
std::vector<double> values_without_xy(const Cloud<2>& c) {
    PrintedMls<double, 2> printed(2, c);
    std::erase(printed.exponents, std::array{1, 1});
    return printed.shape(printed.point(c.at));
}
/// The basis in metres, whatever the support.
std::vector<double> unscaled_values(const Cloud<2>& c) {
    const auto near = c.near();
    const Poly6<2> w(c.support);
    std::vector<double> phi;
    for (const Index j : near.of(0)) phi.push_back(w.value((c.x[j] - c.at).norm()));
    mls_from_weights<2, 2>(c.x, {c.at, near.of(0)}, 1.0, {phi, {}, {}});
    return phi;
}

template <class Change> Cloud<2> changed(Cloud<2> cloud, double scale, Change change) {
    for (auto& x : cloud.x) x = change(x);
    cloud.at = change(cloud.at);
    cloud.support *= scale;
    return cloud;
}
double change_by_translation(Values values) {
    return worst_error([=] {
        const auto cloud = random_cloud<2>();
        const Vec<2> t = point<2>(-1000.0, 1000.0);
        const auto moved = changed(cloud, 1.0, [&](const Vec<2>& x) { return Vec<2>(x + t); });
        return difference(values(cloud), values(moved));
    });
}
double change_by_rotation(Values values) {
    return worst_error([=] {
        const auto cloud = random_cloud<2>();
        const Eigen::Rotation2Dd R(uniform(0.0, 2.0 * std::numbers::pi));
        const auto turned = changed(cloud, 1.0, [&](const Vec<2>& x) { return Vec<2>(R * x); });
        return difference(values(cloud), values(turned));
    });
}
double change_by_scaling(Values values) {
    return worst_error([=] {
        const auto cloud = random_cloud<2>();
        const double s = std::exp2(uniform(-20.0, 20.0));
        const auto scaled = changed(cloud, s, [&](const Vec<2>& x) { return Vec<2>(s * x); });
        return difference(values(cloud), values(scaled));
    });
}
/// Φ from weights c ω for random c, against Φ; or c ω itself, as SPH has it.
double change_by_scale_of_weights(bool normalised) {
    return worst_error([=] {
        const auto cloud = random_cloud<2>();
        const auto near = cloud.near();
        const Poly6<2> w(cloud.support);
        const double c = std::exp2(uniform(-20.0, 20.0));
        std::vector<double> phi;
        for (const Index j : near.of(0)) phi.push_back(c * w.value((cloud.x[j] - cloud.at).norm()));
        if (normalised)
            mls_from_weights<2, 2>(cloud.x, {cloud.at, near.of(0)}, cloud.support, {phi, {}, {}});
        return difference(phi, centred_values(cloud));
    });
}

const Register invariances{
    Claim{.id = "mls_shape.translation_changes_nothing",
          .source = {Paper::adams2009, "Eqs. 28, 29"},
          .says = "Φⱼ of order 2 is the same up to 1000 spacings from the origin",
          .bound = at_most(1e-11, "coordinates up to 1400 are rounded by 2.3e-13, and h |∇Φ| < 10"),
          .measure = [] { return change_by_translation(centred_values); },
          .sabotaged = [] { return change_by_translation(raw_values); }},
    Claim{.id = "mls_shape.rotation_changes_nothing",
          .source = {Paper::adams2009, "Sec. 3.1"},
          .says =
              "Φⱼ of order 2 is the same in a rotated frame, since the basis is complete; without "
              "xy it is not",
          .bound = at_most(1e-12, "rounding of coordinates below 6, 9e-16, and N² u κ = 4e-13"),
          .measure = [] { return change_by_rotation(centred_values); },
          .sabotaged = [] { return change_by_rotation(values_without_xy); }},
    Claim{.id = "mls_shape.scaling_changes_nothing",
          .source = {Paper::adams2009, "Eqs. 28, 29"},
          .says = "Φⱼ of order 2 is the same when all lengths are multiplied by 1e-6 to 1e6",
          .bound = at_most(1e-12, "rounding of coordinates, and N² u κ = 4e-13 with κ = 100"),
          .measure = [] { return change_by_scaling(centred_values); },
          .sabotaged = [] { return change_by_scaling(unscaled_values); }},
    Claim{.id = "mls_shape.weights_need_no_normalisation",
          .source = {Paper::adams2009, "Sec. 3.1"},
          .says = "Φⱼ of order 2 does not change when all weights are multiplied by 1e-6 to 1e6",
          .bound = at_most(1e-12, "N² u κ = 4e-13 with N = 6, κ = 100"),
          .measure = [] { return change_by_scale_of_weights(true); },
          .sabotaged = [] { return change_by_scale_of_weights(false); }},
};

/// How many of 2000 random changes of a make the E of Eq. 21 smaller. a = (⟨f⟩, h ∇⟨f⟩) of order 1, whose
/// gradient is the diffuse one.
double better_coefficients(MlsDerivative derivative) {
    const auto cloud = jittered_cloud<2>(2.8, 4);
    const Poly6<2> w(2.8);
    const auto shape = shape_at(MlsShape<1, Poly6<2>>(w, derivative), cloud, Derivatives::gradient);
    Random random(1);
    const auto f = sampled(cloud, [&](const Vec<2>&) { return random.uniform(-1.0, 1.0); });
    const auto E = [&](double a0, const Vec<2>& a) {
        double total = 0.0;
        for (std::size_t j = 0; j < f.size(); ++j) {
            const Vec<2> d = cloud.x[j] - cloud.at;
            total += w.value(d.norm()) * std::pow(a0 + a.dot(d) - f[j], 2);
        }
        return total;
    };
    const double value = *shape.value(f, 0), smallest = E(value, *shape.gradient(f, 0));
    int better = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec<2> change{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
        better += E(value + random.uniform(-0.1, 0.1), *shape.gradient(f, 0) + change) < smallest;
    }
    return better;
}

/// Rank of Σ ω p(xᵢ) p(xᵢ)ᵀ, or of Σ ω p(x) p(x)ᵀ, order 1 in space.
double rank_of_moments(bool at_samples) {
    const auto cloud = jittered_cloud<3>(2.0, 1);
    const Poly6<3> w(cloud.support);
    Mat<4> M = Mat<4>::Zero();
    for (const auto& x : cloud.x) {
        Eigen::Vector4d p;
        p << 1.0, at_samples ? x : cloud.at;
        M += w.value((x - cloud.at).norm()) * p * p.transpose();
    }
    const auto values = eigenvalues<4>(M);
    return static_cast<double>((values.array() > 1e-12 * values.maxCoeff()).count());
}

/// Φᵢ(xᵢ) of order 1 at a sample of a square lattice; weights ω, or ω / (r² + 1e-12).
double own_weight(bool singular) {
    Cloud<2> cloud = jittered_cloud<2>(2.8, 1, 0.0);
    cloud.at.setZero();
    const auto near = cloud.near();
    const Poly6<2> w(2.8);
    std::vector<double> phi;
    std::size_t self = 0;
    for (const Index j : near.of(0)) {
        const double r = cloud.x[j].norm();
        if (r == 0.0) self = phi.size();
        phi.push_back(w.value(r) / (singular ? r * r + 1e-12 : 1.0));
    }
    mls_from_weights<2, 1>(cloud.x, {cloud.at, near.of(0)}, 2.8, {phi, {}, {}});
    return phi[self];
}
/// 1 / Σ (1 − r²/h²)³ over the square lattice, as odd moments vanish.
double own_weight_on_lattice() {
    double total = 0.0;
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) {
            const double s = 1.0 - (i * i + j * j) / (2.8 * 2.8);
            if (s > 0.0) total += s * s * s;
        }
    return 1.0 / total;
}

const Register squares{
    &eq_21_at_the_point,
    Claim{.id = "mls_shape.minimises_the_weighted_squares",
          .source = {Paper::adams2009, "Eqs. 21-23"},
          .says =
              "no other coefficients give a smaller E = Σ ωᵢ (p(xᵢ)ᵀ a − fᵢ)²: of 2000 tried, 0 do",
          .bound = at_most(0, "E is convex, and a is where its derivative vanishes"),
          .measure = [] { return better_coefficients(MlsDerivative::diffuse); },
          .sabotaged = [] { return better_coefficients(MlsDerivative::full); }},
    Claim{
        .id = "mls_shape.basis_is_taken_at_the_samples",
        .source = {Paper::adams2009, "Eqs. 21, 22, 24"},
        .says =
            "M has rank 4 for order 1 in space; with p(x) in the place of p(xᵢ), as the scan has "
            "it, rank 1",
        .bound = between(4, 4, "samples in general position span the basis; p(x) p(x)ᵀ has rank 1"),
        .measure = [] { return rank_of_moments(true); },
        .sabotaged = [] { return rank_of_moments(false); },
        .erratum = 38},
    Claim{.id = "mls_shape.does_not_interpolate",
          .source = {Paper::adams2009, "Sec. 3.1"},
          .says = "Φᵢ(xᵢ) of order 1 on a square lattice, h = 2.8 spacings, is 1 / Σ (1 − r²/h²)³ "
                  "= 0.162, "
                  "not 1",
          .bound = between(own_weight_on_lattice() - 1e-15, own_weight_on_lattice() + 1e-15,
                           "odd moments vanish, so M is diagonal; 21 terms of 1.1e-16 · 0.16"),
          .measure = [] { return own_weight(false); },
          .sabotaged = [] { return own_weight(true); }},
    Claim{.id = "mls_shape.singular_weights_interpolate",
          .source = {Paper::adams2009, "Sec. 3.1"},
          .says = "Φᵢ(xᵢ) = 1 for weights that grow like 1/r² towards the sample",
          .bound = between(1.0 - 1e-9, 1.0, "the others have 1e-12 Σ ωⱼ/rⱼ² < 1e-11 of its weight"),
          .measure = [] { return own_weight(true); },
          .sabotaged = [] { return own_weight(false); }},
};

}  // namespace
}  // namespace mls_shape_claims
