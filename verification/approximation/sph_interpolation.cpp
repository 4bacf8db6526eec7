#include "solver/approximation/sph_interpolation.h"

#include "solver/approximation/shepard.h"
#include "solver/foundation/random.h"
#include "solver/kernels/poly6.h"
#include "verification/approximation/shepard_under_test.h"
#include "verification/approximation/smoothing.h"
#include "verification/framework/invariances.h"
#include "verification/framework/registry.h"

#include <cmath>

namespace sph_interpolation_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr auto even = [](const auto&) { return 1.0; };
constexpr double h = 0.5;
constexpr auto lopsided = [](const auto& y) { return 1.0 + y[0] / h; };  // ∫ ω = 1 still

template <int Dim> double affine(const Vec<Dim>& x) { return 2.0 + 3.0 * x[0] - x[Dim - 1]; }
template <int Dim, class Skew> double affine_error(Skew skew) {
    const Vec<Dim> x = Vec<Dim>::LinSpaced(0.3, 0.9);
    return std::abs(smoothed(Poly6<Dim>(h), affine<Dim>, x, skew) - affine<Dim>(x));
}
/// (f̃ − f) / (h² Δf) of f = x₀² + x₀ x_last (x₀² on the line), Δf = 2.
template <int Dim, class Skew> double error_per_laplacian(Skew skew) {
    const Vec<Dim> x = Vec<Dim>::LinSpaced(0.3, 0.9);
    const auto f = [](const Vec<Dim>& p) {
        return p[0] * p[0] + (Dim > 1 ? p[0] * p[Dim - 1] : 0.0);
    };
    return (smoothed(Poly6<Dim>(h), f, x, skew) - f(x)) / (h * h * 2.0);
}
/// f̃ / f of a wave, with the support 1: for poly6 Γ(5) (2 / k)⁴ J₄(k), its Fourier transform.
double remaining_wave(double k) {
    const auto wave = [k](const Vec<2>& x) { return std::cos(k * x[0]); };
    return smoothed(Poly6<2>(1.0), wave, Vec<2>(0.0, 0.4), even);
}
double wave_error(int nu) {
    double worst = 0.0;
    for (double k = 0.5; k < 8.0; k += 0.5)
        worst = std::max(
            worst, std::abs(remaining_wave(k) - std::tgamma(nu + 1.0) * std::pow(2.0 / k, nu) *
                                                    std::cyl_bessel_j(nu, k)));
    return worst;
}

template <class Skew> double smoothing_error(double support, Skew skew) {
    const auto wave = [](const Vec<2>& x) { return std::cos(x[0]); };
    const Vec<2> x(0.7, 0.4);
    return std::abs(smoothed(Poly6<2>(support), wave, x, skew) - wave(x));
}

/// max |Σ Φⱼ(x) − 1| at places between disordered samples, masses one as the text after Eq. 7 has it.
template <int Dim, class Sum> double distance_from_one(Sum sum_of_weights) {
    Disordered<Dim> d(2.5, {.support = 0, .jitter = 0.2});
    std::ranges::fill(d.m, 1.0);
    d.patch.V = volumes<Poly6<Dim>>(d.w, d.patch.x, d.m, d.patch.neighbours);
    const auto s = d.samples();
    const std::vector<double> one(d.size(), 1.0);
    return worst_between_samples<Dim>(
        d.patch, d.w.support(), 100,
        [&](const Place<Dim>& at) { return sum_of_weights(d.w, s, one, at) - 1.0; }, 4);
}
constexpr auto by_eq_3 = [](const auto& w, const auto& s, const auto& f, const auto& at) {
    return interpolate(w, s, f, at);
};
constexpr auto by_shepard = [](const auto& w, const auto& s, const auto& f, const auto& at) {
    return shepard_under_test(w, s, f, at);
};

/// max |Σ ω V − 1| at 50 places of a square lattice, h = 10 spacings; V of every tenth sample off.
double distance_from_one_on_fine_lattice(double error_in_volume) {
    Patch<2> patch(cubic_lattice<2>(1.0), {.support = 10.0, .reach = 1.2});
    for (std::size_t j = 0; j < patch.V.size(); j += 10) patch.V[j] *= 1.0 + error_in_volume;
    std::vector<Index> everyone(patch.x.size());
    std::iota(everyone.begin(), everyone.end(), Index{0});
    const std::vector<double> one(patch.x.size(), 1.0);
    Random random(6);
    double worst = 0.0;
    for (int k = 0; k < 50; ++k) {
        const Vec<2> x(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
        worst = std::max(worst, std::abs(interpolate<Poly6<2>>(Poly6<2>(10.0), patch.samples(), one,
                                                               {x, everyone}) -
                                         1.0));
    }
    return worst;
}

/// |⟨a f + b⟩ − a ⟨f⟩ − b ⟨1⟩| or, sabotaged, with b instead of b ⟨1⟩: constants taken for reproduced.
double superposition_error(bool reproduces_constants) {
    static const Fields<3> d(2.5);
    const auto s = d.samples();
    const auto at = s.at(d.patch.centre);
    const std::vector<double> one(d.size(), 1.0);
    return worst_error([&] {
        const double a = uniform(-10.0, 10.0), b = uniform(-10.0, 10.0);
        std::vector<double> combined;
        for (const double f : d.f) combined.push_back(a * f + b);
        const double of_one = reproduces_constants ? 1.0 : interpolate(d.w, s, one, at);
        return interpolate(d.w, s, combined, at) - a * interpolate(d.w, s, d.f, at) - b * of_one;
    });
}

double largest_weight(bool at_samples) {
    const Disordered<2> d(2.5);
    double largest = 0.0;
    for (Index i = 0; i < d.size(); ++i) largest = std::max(largest, d.patch.V[i] * d.w.value(0.0));
    return at_samples ? largest : 1.0;
}

double far_from_all_samples(double distance) {
    const Disordered<2> d(2.5);
    std::vector<Index> everyone(d.size());
    std::iota(everyone.begin(), everyone.end(), Index{0});
    const std::vector<double> one(d.size(), 1.0);
    return interpolate<Poly6<2>>(d.w, d.samples(), one, {Vec<2>(distance, 0.0), everyone});
}

template <int Dim> double change_of_value(bool scale_support) {
    return change_under_similarity<Dim>(2.5, 0, [=](const auto& d, Index i) {
        const Poly6<Dim> w(scale_support ? d.w.support() : 2.5);
        return interpolate(w, d.samples(), d.f, d.samples().at(i));
    });
}

const Register claims_of_sph_interpolation{
    Erratum{
        .number = 29,
        .source = {Paper::adams2009, "Sec. 2"},
        .printed = "with mⱼ = 1 the density makes the weights of Eq. 3 sum to one, as Shepard's do",
        .corrected = "Vⱼ has the density at xⱼ, Shepard's weights are divided by that at x"},
    &unit_masses_for_shepard,
    Claim{
        .id = "sph_interpolation.smoothing_tends_to_the_identity",
        .source = {Paper::adams2009, "Eqs. 1, 2"},
        .says = "|f̃ − f| for f = cos x₀ tends to 0 with h, the kernel to δ: h = 0.001",
        .bound = at_most(5.1e-8, "h² / 20 |Δf| = 5e-8 cos 0.7, and rounding"),
        .measure = [] { return smoothing_error(1e-3, even); },
        .sabotaged =
            [] { return smoothing_error(1e-3, [](const auto& y) { return 1.0 + y[0] / 1e-3; }); }},
    Claim{
        .id = "sph_interpolation.smoothing_error_is_of_second_order",
        .source = {Paper::adams2009, "Eq. 2"},
        .says = "halving h divides |f̃ − f| by four, since the kernel is even",
        .bound = between(
            3.98, 4.0, "Fourier transform of poly6: 4 (1 − h²/48) / (1 − h²/192) = 3.984, h = 1/2"),
        .measure = [] { return smoothing_error(0.5, even) / smoothing_error(0.25, even); },
        .sabotaged =
            [] {
                const auto skewed = [](double support) {
                    return smoothing_error(support,
                                           [=](const auto& y) { return 1.0 + y[0] / support; });
                };
                return skewed(0.5) / skewed(0.25);
            }},
    Claim{.id = "sph_interpolation.smoothing_keeps_affine_1d",
          .source = {Paper::adams2009, "Eq. 2"},
          .says = "f̃ = f for affine f, since the kernel is even and ∫ ω dV = 1",
          .bound = at_most(1e-12, "relative accuracy of the quadrature in r is 1e-13, |f| < 5"),
          .measure = [] { return affine_error<1>(even); },
          .sabotaged = [] { return affine_error<1>(lopsided); }},
    Claim{.id = "sph_interpolation.smoothing_keeps_affine_2d",
          .source = {Paper::adams2009, "Eq. 2"},
          .says = "f̃ = f for affine f, since the kernel is even and ∫ ω dV = 1",
          .bound = at_most(1e-12, "relative accuracy of the quadrature in r is 1e-13, |f| < 5"),
          .measure = [] { return affine_error<2>(even); },
          .sabotaged = [] { return affine_error<2>(lopsided); }},
    Claim{.id = "sph_interpolation.smoothing_keeps_affine_3d",
          .source = {Paper::adams2009, "Eq. 2"},
          .says = "f̃ = f for affine f, since the kernel is even and ∫ ω dV = 1",
          .bound = at_most(1e-12, "relative accuracy of the quadrature in r is 1e-13, |f| < 5"),
          .measure = [] { return affine_error<3>(even); },
          .sabotaged = [] { return affine_error<3>(lopsided); }},
    Claim{
        .id = "sph_interpolation.smoothing_adds_a_laplacian_1d",
        .source = {Paper::adams2009, "Eq. 2"},
        .says =
            "f̃ = f + μ/2 h² Δf for quadratic f, μ = 1/9 being the variance of poly6 along an axis",
        .bound = between(1.0 / 18 - 1e-12, 1.0 / 18 + 1e-12, "accuracy of the quadrature"),
        .measure = [] { return error_per_laplacian<1>(even); },
        .sabotaged = [] { return error_per_laplacian<1>(lopsided); }},
    Claim{
        .id = "sph_interpolation.smoothing_adds_a_laplacian_2d",
        .source = {Paper::adams2009, "Eq. 2"},
        .says =
            "f̃ = f + μ/2 h² Δf for quadratic f, μ = 1/10 being the variance of poly6 along an axis",
        .bound = between(1.0 / 20 - 1e-12, 1.0 / 20 + 1e-12, "accuracy of the quadrature"),
        .measure = [] { return error_per_laplacian<2>(even); },
        .sabotaged = [] { return error_per_laplacian<2>(lopsided); }},
    Claim{
        .id = "sph_interpolation.smoothing_adds_a_laplacian_3d",
        .source = {Paper::adams2009, "Eq. 2"},
        .says =
            "f̃ = f + μ/2 h² Δf for quadratic f, μ = 1/11 being the variance of poly6 along an axis",
        .bound = between(1.0 / 22 - 1e-12, 1.0 / 22 + 1e-12, "accuracy of the quadrature"),
        .measure = [] { return error_per_laplacian<3>(even); },
        .sabotaged = [] { return error_per_laplacian<3>(lopsided); }},
    Claim{.id = "sph_interpolation.smoothing_damps_waves",
          .source = {Paper::adams2009, "Eq. 2"},
          .says =
              "a wave of wave number k is multiplied by the Fourier transform 24 (2/kh)⁴ J₄(kh) of "
              "poly6, 0.5 ≤ k h < 8",
          .bound = at_most(1e-12, "accuracy of the quadrature; 32 angles miss J₃₂(8) < 1e-16"),
          .measure = [] { return wave_error(4); },
          .sabotaged = [] { return wave_error(3); }},
    Claim{
        .id = "sph_interpolation.constants_on_a_fine_lattice",
        .source = {Paper::adams2009, "Eq. 3"},
        .says = "|⟨1⟩ − 1| between the points of a square lattice with 10 spacings per support",
        .bound = at_most(1.4e-5,
                         "Poisson's sum over G = 2π (a, b) ≠ 0 of |ω̂| ≤ 24 (2/Gh)⁴ √(2/(π G h)) = "
                         "2.5e-6 (a² + b²)^-9/4, whose sum is 5.4 times the first"),
        .measure = [] { return distance_from_one_on_fine_lattice(0.0); },
        .sabotaged = [] { return distance_from_one_on_fine_lattice(0.01); }},
    Claim{
        .id = "sph_interpolation.unit_mass_is_not_shepard_1d",
        .source = {Paper::adams2009, "Sec. 2"},
        .says = "|Σ Φⱼ − 1| of Shepard; Eq. 3 with mⱼ = 1 is not the same, as the text says it is",
        .bound = at_most(40 * unit_roundoff, "a quotient of two equal sums of up to 6 terms"),
        .measure = [] { return distance_from_one<1>(by_shepard); },
        .sabotaged = [] { return distance_from_one<1>(by_eq_3); },
        .erratum = 29},
    Claim{
        .id = "sph_interpolation.unit_mass_is_not_shepard_2d",
        .source = {Paper::adams2009, "Sec. 2"},
        .says = "|Σ Φⱼ − 1| of Shepard; Eq. 3 with mⱼ = 1 is not the same, as the text says it is",
        .bound = at_most(40 * unit_roundoff, "a quotient of two equal sums of up to 30 terms"),
        .measure = [] { return distance_from_one<2>(by_shepard); },
        .sabotaged = [] { return distance_from_one<2>(by_eq_3); },
        .erratum = 29},
    Claim{
        .id = "sph_interpolation.unit_mass_is_not_shepard_3d",
        .source = {Paper::adams2009, "Sec. 2"},
        .says = "|Σ Φⱼ − 1| of Shepard; Eq. 3 with mⱼ = 1 is not the same, as the text says it is",
        .bound = at_most(110 * unit_roundoff, "a quotient of two equal sums of up to 100 terms"),
        .measure = [] { return distance_from_one<3>(by_shepard); },
        .sabotaged = [] { return distance_from_one<3>(by_eq_3); },
        .erratum = 29},
    Claim{.id = "sph_interpolation.loses_constants",
          .source = {Paper::adams2009, "Eq. 3; Sec. 2"},
          .says = "constants are not recovered: |⟨1⟩ − 1| on a lattice disordered by 0.2 spacings",
          .bound = at_least(1e-3, "far more than rounding, 1e-14, which exact methods leave"),
          .measure = [] { return distance_from_one<2>(by_eq_3); },
          .sabotaged = [] { return distance_from_one<2>(by_shepard); }},
    Claim{.id = "sph_interpolation.is_linear_in_f",
          .source = {Paper::adams2009, "Eq. 3"},
          .says = "⟨a f + b⟩ = a ⟨f⟩ + b ⟨1⟩; b ⟨1⟩ is not b",
          .bound =
              at_most(20.0 * 100 * unit_roundoff, "|a f + b| < 20 and 90 terms with 10 roundings"),
          .measure = [] { return superposition_error(false); },
          .sabotaged = [] { return superposition_error(true); }},
    Claim{.id = "sph_interpolation.does_not_interpolate",
          .source = {Paper::adams2009, "Eq. 3; Sec. 2.1"},
          .says = "the weight Vᵢ ω(0) of a sample at its own place is less than one with a bounded "
                  "kernel",
          .bound = at_most(
              0.99, "ρᵢ > mᵢ ω(0) as soon as a neighbour adds to it; it was 1 if no one did"),
          .measure = [] { return largest_weight(true); },
          .sabotaged = [] { return largest_weight(false); }},
    Claim{.id = "sph_interpolation.is_zero_far_from_samples",
          .source = {Paper::plumbline, "docstring of interpolate"},
          .says = "⟨1⟩ = 0 where no sample is within the support",
          .bound = between(0.0, 0.0, "the kernel is 0 there, not small"),
          .measure = [] { return far_from_all_samples(8.0); },
          .sabotaged = [] { return far_from_all_samples(7.0); }},
    Claim{
        .id = "sph_interpolation.scales_and_moves_1d",
        .source = {Paper::adams2009, "Eq. 3"},
        .says = "⟨f⟩ is the same for scaled, turned, shifted, reordered samples",
        .bound = at_most(10 * position_rounding, "h ∫ |ω′| dV = 2.2 supports, volumes vary by 1.5"),
        .measure = [] { return change_of_value<1>(true); },
        .sabotaged = [] { return change_of_value<1>(false); }},
    Claim{
        .id = "sph_interpolation.scales_and_moves_2d",
        .source = {Paper::adams2009, "Eq. 3"},
        .says = "⟨f⟩ is the same for scaled, turned, shifted, reordered samples",
        .bound = at_most(10 * position_rounding, "h ∫ |ω′| dV = 3.7 supports, volumes vary by 1.5"),
        .measure = [] { return change_of_value<2>(true); },
        .sabotaged = [] { return change_of_value<2>(false); }},
    Claim{
        .id = "sph_interpolation.scales_and_moves_3d",
        .source = {Paper::adams2009, "Eq. 3"},
        .says = "⟨f⟩ is the same for scaled, turned, shifted, reordered samples",
        .bound = at_most(10 * position_rounding, "h ∫ |ω′| dV = 4.9 supports, volumes vary by 1.5"),
        .measure = [] { return change_of_value<3>(true); },
        .sabotaged = [] { return change_of_value<3>(false); }},
};
}  // namespace
}  // namespace sph_interpolation_claims
