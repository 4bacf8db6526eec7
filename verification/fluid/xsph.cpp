#include "solver/fluid/xsph.h"

#include "solver/kernels/poly6.h"
#include "verification/fluid/drop.h"
#include "verification/framework/eigenvalues.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace xsph_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> using W = WendlandC2<Dim>;
constexpr double xi = 0.5;

/// The velocities of the drop after one pass of XSPH.
template <int Dim> Points<Dim> by_the_solver(const Drop<Dim>& drop, double dt = 1.0) {
    auto scene = scene_of(drop, AverageVelocities<W<Dim>>{W<Dim>(Drop<Dim>::support)},
                          XsphVelocities<Dim>{{xi, 1.0}});
    scene.step(dt);
    return scene.template get<Velocities<Dim>>();
}
/// S, (S v)ᵢ = Σⱼ mⱼ/ρⱼ ω(xᵢ − xⱼ) vⱼ, as Eq. 53 has it; ρ of the kernel `of_density`.
template <int Dim, class K>
Eigen::MatrixXd printed_average(const Drop<Dim>& drop, const K& of_density,
                                bool with_itself = true) {
    const W<Dim> w(Drop<Dim>::support);
    const auto n = static_cast<Eigen::Index>(drop.x.size());
    Eigen::MatrixXd S(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        double rho = 0.0;
        for (Eigen::Index i = 0; i < n; ++i)
            rho += drop.m[i] * of_density.value((drop.x[i] - drop.x[j]).norm());
        for (Eigen::Index i = 0; i < n; ++i)
            S(i, j) = i == j && !with_itself
                          ? 0.0
                          : drop.m[j] / rho * w.value((drop.x[i] - drop.x[j]).norm());
    }
    return S;
}
/// v ← ξ S v + (1 − ξ) v; `normalised` divides each row by its sum, as Shepard does.
template <int Dim>
Points<Dim> as_printed(const Drop<Dim>& drop, bool with_itself, bool normalised) {
    Eigen::MatrixXd S = printed_average<Dim>(drop, W<Dim>(Drop<Dim>::support), with_itself);
    if (normalised) S = S.rowwise().sum().cwiseInverse().asDiagonal() * S;
    Points<Dim> v = drop.v;
    for (std::size_t i = 0; i < v.size(); ++i) {
        v[i] *= 1.0 - xi;
        for (std::size_t j = 0; j < v.size(); ++j) v[i] += xi * S(i, j) * drop.v[j];
    }
    return v;
}
template <int Dim> double change_of_momentum(const Drop<Dim>& drop, const Points<Dim>& v) {
    Vec<Dim> change = Vec<Dim>::Zero();
    double size = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i)
        change += drop.m[i] * (v[i] - drop.v[i]), size += drop.m[i] * (v[i] - drop.v[i]).norm();
    return change.norm() / size;
}
template <int Dim> double gain_of_energy(const Drop<Dim>& drop, const Points<Dim>& v) {
    double before = 0.0, after = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        before += drop.m[i] * drop.v[i].squaredNorm();
        after += drop.m[i] * v[i].squaredNorm();
    }
    return after / before - 1.0;
}
template <int Dim> Drop<Dim> in_uniform_motion() {
    Drop<Dim> drop;
    std::ranges::fill(drop.v, Vec<Dim>::Ones());
    return drop;
}
template <int Dim> double change_of_velocities(const Drop<Dim>& drop, const Points<Dim>& v) {
    return largest_difference<Dim>(v, drop.v);
}
template <int Dim, class K> double spectral_radius_as_printed(const K& of_density) {
    return spectral_radius(printed_average<Dim>(Drop<Dim>{}, of_density));
}

/// The velocities after one step of 1 s, and after ten of 0.1 s, for a pair: relative difference.
double dependence_on_step(double reference_of_short_step) {
    const XsphStrength once{xi, 1.0}, often{xi, reference_of_short_step};
    return std::abs((1.0 - once.of(1.0)) / std::pow(1.0 - often.of(0.1), 10) - 1.0);
}
/// |x − x₀ − ξ Σ…| and what happens to v, in one step of 1 s of "original XSPH".
double error_of_motion(bool velocities_too) {
    const Drop<2> drop;
    auto scene = scene_of(drop, AverageVelocities<W<2>>{W<2>(Drop<2>::support)}, XsphMotion<2>{xi},
                          XsphVelocities<2>{{velocities_too ? xi : 0.0, 1.0}});
    scene.step(1.0);
    const Points<2> smoothed = by_the_solver<2>(drop);
    Points<2> expected = drop.x;
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += smoothed[i] - drop.v[i];
    return std::max(largest_difference<2>(scene.get<Positions<2>>(), expected),
                    largest_difference<2>(scene.get<Velocities<2>>(), drop.v));
}

const Register momentum{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "xsph.conserves_linear_momentum",
        .source = {Paper::literature, "Monaghan 1992"},
        .says =
            "‖Σ m Δv‖ / Σ m ‖Δv‖; Shepard's quotient, which leaves uniform motion alone "
            "too, changes it",
        .bound = at_most(rounding_of_pairs, sums_of_pairs),
        .measure = [] { return change_of_momentum<D>(Drop<D>{}, by_the_solver<D>(Drop<D>{})); },
        .sabotaged =
            [] { return change_of_momentum<D>(Drop<D>{}, as_printed<D>(Drop<D>{}, true, true)); }};
})};
const Register uniform{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "xsph.leaves_uniform_motion_alone",
                 .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
                 .says =
                     "max ‖Δv‖ / ‖v‖ of a drop in uniform motion; printed, it is changed where "
                     "Σ V ω ≠ 1",
                 .bound = at_most(0.0, "every term has the factor vⱼ − vᵢ, which is 0 exactly"),
                 .measure =
                     [] {
                         const auto drop = in_uniform_motion<D>();
                         return change_of_velocities<D>(drop, by_the_solver<D>(drop));
                     },
                 .sabotaged =
                     [] {
                         const auto drop = in_uniform_motion<D>();
                         return change_of_velocities<D>(drop, as_printed<D>(drop, true, false));
                     },
                 .erratum = 20};
})};
const Register energy{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "xsph.only_takes_energy",
        .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
        .says = "Σ m v² falls for random velocities: a viscosity; with −ξ it grows",
        .bound = at_most(0.0,
                         "v ← (1 − ξ L) v, L symmetric in the product by masses, with "
                         "eigenvalues from 0 to 2 Σ V ω < 4, ξ = 1/2"),
        .measure = [] { return gain_of_energy<D>(Drop<D>{}, by_the_solver<D>(Drop<D>{})); },
        .sabotaged =
            [] {
                Points<D> v = by_the_solver<D>(Drop<D>{});
                for (std::size_t i = 0; i < v.size(); ++i) v[i] = 2.0 * Drop<D>{}.v[i] - v[i];
                return gain_of_energy<D>(Drop<D>{}, v);
            }};
})};
const Register printed_momentum{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "xsph.printed_form_conserves_linear_momentum",
        .source = {Paper::adams2009, "Eq. 53"},
        .says =
            "Σᵢ mᵢ ωᵢⱼ = ρⱼ makes Eq. 53 conserve momentum, if the particle itself is in the sum",
        .bound = at_most(rounding_of_pairs, sums_of_pairs),
        .measure =
            [] { return change_of_momentum<D>(Drop<D>{}, as_printed<D>(Drop<D>{}, true, false)); },
        .sabotaged =
            [] {
                return change_of_momentum<D>(Drop<D>{}, as_printed<D>(Drop<D>{}, false, false));
            }};
})};
const Register radius{in_dimensions<2, 3>([]<int D>() {
    const double h = Drop<D>::support;
    return Claim{
        .id = "xsph.printed_form_has_spectral_radius_one",
        .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
        .says =
            "S of Eq. 53 has the left eigenvector m, hence the spectral radius 1: stable for "
            "all ξ in [0, 1]; not so with a density of another kernel",
        .bound = between(1.0 - 1e-12, 1.0 + 1e-12,
                         "eigenvalues of a 70 by 70 matrix similar to a symmetric one: 70 · "
                         "1.1e-16 times its condition, √(max m/ρ / min m/ρ) < 10"),
        .measure = [h] { return spectral_radius_as_printed<D>(W<D>(h)); },
        .sabotaged = [h] { return spectral_radius_as_printed<D>(Poly6<D>(h)); }};
})};
const Register claims_of_xsph{
    Claim{
        .id = "xsph.does_not_depend_on_the_step",
        .source = {Paper::plumbline, "docstring of XsphStrength"},
        .says =
            "ten steps of 0.1 s smooth as much as one of 1 s; with one ξ for any step they do not",
        .bound = at_most(2e-15, "eleven roundings and two pow"),
        .measure = [] { return dependence_on_step(1.0); },
        .sabotaged = [] { return dependence_on_step(0.1); }},
    Claim{.id = "xsph.original_moves_positions_alone",
          .source = {Paper::adams2009, "Eq. 53; Sec. 6.2"},
          .says = "\"original XSPH\" moves x by Δt ξ Σ…, and stores v as it is",
          .bound = at_most(1e-15, "two roundings of positions"),
          .measure = [] { return error_of_motion(false); },
          .sabotaged = [] { return error_of_motion(true); }},
    Erratum{20,
            {Paper::adams2009, "Eqs. 53, 57; Sec. 6.2"},
            "v ← ξ Σ mⱼ/ρⱼ ωᵢⱼ vⱼ + (1 − ξ) v",
            "v ← v + ξ Σ 2 mⱼ/(ρᵢ + ρⱼ) ωᵢⱼ (vⱼ − v), and the impulse of ghosts on their body"}};
}  // namespace
}  // namespace xsph_claims
