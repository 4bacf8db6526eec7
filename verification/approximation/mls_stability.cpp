#include "solver/approximation/mls_shape.h"

#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_cloud.h"
#include "verification/framework/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace mls_stability_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Order, int Dim> auto shape_of(const Cloud<Dim>& cloud) {
    return shape_at(MlsShape<Order, Poly6<Dim>>(Poly6<Dim>(cloud.support)), cloud);
}

Cloud<3> planar_cloud(double above, double out_of_plane = 0.0) {
    const auto flat = jittered_cloud<2>(2.8, 2);
    Cloud<3> cloud{{}, {flat.at[0], flat.at[1], above}, 2.8};
    Random random(3);
    for (const auto& x : flat.x)
        cloud.x.push_back({x[0], x[1], out_of_plane * random.uniform(-1.0, 1.0)});
    return cloud;
}
Cloud<3> collinear_cloud() {
    Cloud<3> cloud{{}, {0.1, 0.2, 0.3}, 2.8};
    for (int i = -4; i <= 4; ++i) cloud.x.push_back({0.5 * i, i * 1.0 / 3.0, 0.25 * i});
    return cloud;
}
/// n samples on a circle about the point: on one conic.
Cloud<2> circular_cloud(int n, double off_circle = 0.0) {
    Cloud<2> cloud{{}, {0.1, 0.0}, 2.8};
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n, r = 1.0 + (i % 2) * off_circle;
        cloud.x.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return cloud;
}
template <int Dim> Cloud<Dim> first_samples(std::size_t n) {
    auto cloud = jittered_cloud<Dim>(2.0, 1);
    std::ranges::sort(cloud.x, {}, [&](const Vec<Dim>& x) { return (x - cloud.at).norm(); });
    cloud.x.resize(n);
    return cloud;
}
template <int Order, int Dim> double rank_of(const Cloud<Dim>& cloud) {
    return shape_of<Order>(cloud).fit[0]->rank;
}

using Field = double (*)(const Vec<3>&);
double one(const Vec<3>&) { return 1.0; }
double x(const Vec<3>& p) { return p[0]; }
double y(const Vec<3>& p) { return p[1]; }
double x_squared(const Vec<3>& p) { return p[0] * p[0]; }

/// The error of ⟨q⟩ of order 1 and of its gradient along the plane, or its derivative out of the plane.
double planar_error(double above, Field q) {
    const auto cloud = planar_cloud(above);
    const auto shape = shape_of<1>(cloud);
    const auto f = sampled(cloud, q);
    Vec<3> exact;
    for (int d = 0; d < 3; ++d) exact[d] = q(Vec<3>::Unit(d)) - q(Vec<3>::Zero());
    return std::max(std::abs(*shape.value(f, 0) - q(cloud.at)),
                    (*shape.gradient(f, 0) - exact).norm());
}
double planar_error_of_linear_functions() {
    double worst = 0.0;
    for (const double above : {0.0, 0.6})
        for (const Field q : {one, x, y}) worst = std::max(worst, planar_error(above, q));
    return worst;
}
double lost_unity() {
    double worst = 0.0;
    for (const auto& cloud : {planar_cloud(0.0), planar_cloud(1.3), collinear_cloud(),
                              first_samples<3>(1), first_samples<3>(2), first_samples<3>(3)}) {
        const std::vector<double> ones(cloud.x.size(), 1.0);
        worst = std::max(worst, std::abs(*shape_of<2>(cloud).value(ones, 0) - 1.0));
    }
    return worst;
}
/// The same with weights divided by the count of samples instead: an average that forgets the rank.
double lost_unity_of_raw_weights() {
    const auto cloud = planar_cloud(0.0);
    const Poly6<3> w(cloud.support);
    double total = 0.0;
    for (const auto& x : cloud.x) total += w.value((x - cloud.at).norm());
    return std::abs(total - 1.0);
}

Claim rank_claim(const char* name, const char* says, double rank, const char* why,
                 std::function<double()> measure, std::function<double()> sabotaged) {
    return {.id = fmt::format("mls_shape.rank_{}", name),
            .source = {Paper::adams2009, "Sec. 3.3"},
            .says = says,
            .bound = between(rank, rank, why),
            .measure = std::move(measure),
            .sabotaged = std::move(sabotaged)};
}
const Register degenerate{
    rank_claim(
        "of_coplanar_samples_is_3_of_4", "coplanar samples in space, order 1: rank 3 is stated", 3,
        "the matrix printed in Sec. 3.3: the row and the column of z are 0",
        [] { return rank_of<1>(planar_cloud(0.5)); },
        [] { return rank_of<1>(planar_cloud(0.5, 0.1)); }),
    rank_claim(
        "of_coplanar_samples_is_6_of_10", "coplanar samples in space, order 2: rank 6", 6,
        "the quadratic polynomials of the plane", [] { return rank_of<2>(planar_cloud(0.5)); },
        [] { return rank_of<2>(planar_cloud(0.5, 0.1)); }),
    rank_claim(
        "of_collinear_samples_is_3_of_10", "collinear samples in space, order 2: rank 3", 3,
        "the quadratic polynomials of the line", [] { return rank_of<2>(collinear_cloud()); },
        [] { return rank_of<2>(planar_cloud(0.0)); }),
    rank_claim(
        "of_samples_on_a_conic_is_5_of_6", "12 samples on a circle, order 2: rank 5", 5,
        "x² + y² = 1 on all of them", [] { return rank_of<2>(circular_cloud(12)); },
        [] { return rank_of<2>(circular_cloud(12, 0.2)); }),
    rank_claim(
        "of_3_samples_is_3_of_4", "3 samples in space, order 1: rank 3", 3,
        "no more polynomials than samples can be told apart",
        [] { return rank_of<1>(first_samples<3>(3)); },
        [] { return rank_of<1>(first_samples<3>(4)); }),
    rank_claim(
        "of_4_samples_is_4_of_6", "4 samples in the plane, order 2: rank 4", 4,
        "no more polynomials than samples can be told apart",
        [] { return rank_of<2>(first_samples<2>(4)); },
        [] { return rank_of<2>(first_samples<2>(5)); }),
    Claim{.id = "mls_shape.degenerate_samples_keep_the_partition_of_unity",
          .source = {Paper::adams2009, "Secs. 3.2, 3.3"},
          .says = "Σ Φⱼ = 1 for 1, 2 or 3 samples, collinear and coplanar ones, seen from their "
                  "plane and "
                  "from above it",
          .bound = at_most(1e-12, "N² u ‖M‖ ‖G‖ with N = 10, ‖M‖ ‖G‖ < 100"),
          .measure = lost_unity,
          .sabotaged = lost_unity_of_raw_weights},
    Claim{.id = "mls_shape.coplanar_samples_keep_linear_functions_of_the_plane",
          .source = {Paper::adams2009, "Sec. 3.3"},
          .says =
              "order 1: 1, x and y of coplanar samples are exact in their plane and above it, with "
              "their gradients, and the derivative out of the plane is 0; x² is not",
          .bound = at_most(1e-12, "N² u ‖M‖ ‖G‖ with N = 4, ‖M‖ ‖G‖ < 100, times |∇ω|/ω < 10"),
          .measure = planar_error_of_linear_functions,
          .sabotaged = [] { return planar_error(0.0, x_squared); }},
};

/// Half of a square lattice, seen from a sample of its last row.
Cloud<2> at_the_edge(double support) {
    Cloud<2> cloud{{}, {0.0, 0.0}, support};
    for (int i = -4; i <= 4; ++i)
        for (int j = 0; j <= 4; ++j) cloud.x.push_back({1.0 * i, 1.0 * j});
    return cloud;
}
const Register edge{
    Erratum{49,
            {Paper::plumbline, "catalogue of formulas, minimum support"},
            "use h ≥ 2 spacings in the plane and in space",
            "order 3 needs more than 3 spacings at the edge of a lattice"},
    Claim{.id = "mls_shape.order_3_needs_more_than_3_spacings_at_an_edge",
          .source = {Paper::adams2009, "Sec. 3.3"},
          .says = "order 3 at the last row of a square lattice: full rank at h = 3.01 spacings",
          .bound = between(10, 10, "4 rows with a sample each, the fourth at a distance of 3"),
          .measure = [] { return rank_of<3>(at_the_edge(3.01)); },
          .sabotaged = [] { return rank_of<3>(at_the_edge(2.0)); },
          .erratum = 49},
    Claim{
        .id = "mls_shape.order_3_is_deficient_at_an_edge",
        .source = {Paper::adams2009, "Sec. 3.3"},
        .says = "order 3 at the last row of a square lattice: rank 9 of 10 at h = 3 spacings",
        .bound = between(9, 9,
                         "y (y − 1) (y − 2) is 0 on the three rows closer than 3 spacings, and no "
                         "other cubic polynomial is: they hold 5, 5 and 5 samples"),
        .measure = [] { return rank_of<3>(at_the_edge(3.0)); },
        .sabotaged = [] { return rank_of<3>(at_the_edge(3.01)); },
        .erratum = 49}};

/// Of 200 clouds with 20 % jitter, how many have less than full rank.
template <int Order, int Dim> double incomplete_fits(double support) {
    int incomplete = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        incomplete += !shape_of<Order>(jittered_cloud<Dim>(support, seed, 0.2)).fit[0]->complete();
    return incomplete;
}
const Register supports{
    Claim{
        .id = "mls_shape.order_1_needs_a_support_of_1.5_spacings_2d",
        .source = {Paper::adams2009, "Sec. 3.3"},
        .says = "order 1, plane, 20 % jitter: none of 200 points is deficient at h = 1.5 spacings",
        .bound = at_most(0,
                         "each support holds a whole cell, 4 samples; at h = 0.8 only π h² = 2 on "
                         "the average"),
        .measure = [] { return incomplete_fits<1, 2>(1.5); },
        .sabotaged = [] { return incomplete_fits<1, 2>(0.8); }},
    Claim{
        .id = "mls_shape.order_2_needs_a_support_of_1.8_spacings_2d",
        .source = {Paper::adams2009, "Sec. 3.3"},
        .says = "order 2, plane, 20 % jitter: none of 200 points is deficient at h = 1.8 spacings",
        .bound = at_most(0, "π h² = 10 samples on the average for 6 unknowns; at h = 1.3 only 5"),
        .measure = [] { return incomplete_fits<2, 2>(1.8); },
        .sabotaged = [] { return incomplete_fits<2, 2>(1.3); }},
    Claim{.id = "mls_shape.order_2_needs_a_support_of_2_spacings_3d",
          .source = {Paper::adams2009, "Sec. 3.3"},
          .says = "order 2, space, 20 % jitter: none of 200 points is deficient at h = 2 spacings",
          .bound =
              at_most(0, "4/3 π h³ = 34 samples on the average for 10 unknowns; at h = 1.2 only 7"),
          .measure = [] { return incomplete_fits<2, 3>(2.0); },
          .sabotaged = [] { return incomplete_fits<2, 3>(1.2); }},
};
}  // namespace
}  // namespace mls_stability_claims
