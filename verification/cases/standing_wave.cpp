#include "verification/cases/channel.h"
#include "verification/framework/registry.h"

#include <numbers>

namespace standing_wave_claims {
namespace {
using namespace verification;

constexpr double k = std::numbers::pi, nu = 0.005, g = 1.0;

Channel water(double spacing, double gravity = g, double viscosity = nu) {
    return {.spacing = spacing, .gravity = {0.0, -gravity}, .viscosity = viscosity};
}
/// ω/√(g k tanh k) − 1, of waves of the steepness 0.1.
double error_of_frequency(double spacing, double gravity) {
    const double omega = std::sqrt(g * k * std::tanh(k));
    return std::abs(standing_wave(water(spacing, gravity), 0.1).frequency / omega - 1.0);
}
/// How much faster the wave decays with 3 ν than with ν, over Lamb's 2 · 2 ν k² π/ω; what damps beside viscosity is the
/// same in both.
double ratio_of_decay(double times) {
    const double spacing = 1.0 / 12.0, omega = std::sqrt(g * k * std::tanh(k));
    const double more = standing_wave(water(spacing, g, times * nu), 0.1).decay;
    const double less = standing_wave(water(spacing, g, nu), 0.1).decay;
    return (more - less) / (4.0 * nu * k * k * k / omega);
}

const Register claims_of_standing_wave{
    Claim{
        .id = "standing_wave.frequency",
        .source = {Paper::literature, "Lamb 1932; Tadjbakhsh and Keller 1960"},
        .says =
            "a standing wave as long as twice its depth, 12 particles deep, steepness 0.1: ω² "
            "against g k tanh kH, relative error of ω; with a fifth less gravity it is too slow",
        .bound = at_most(0.04,
                         "density and pressure are averages over the kernel, of the second moment "
                         "0.07 h², k h = 0.8: each takes 2 % of ω², and so do the spacing that "
                         "the surface is known to, ν k²/ω = 3 % in quadrature and the steepness, "
                         "0.1²/8; 4 % of ω² together, and as much again for the missing half of "
                         "the kernel at the surface"),
        .measure = [] { return error_of_frequency(1.0 / 12.0, g); },
        .sabotaged = [] { return error_of_frequency(1.0 / 12.0, 0.8 * g); }},
    Claim{
        .id = "standing_wave.decay",
        .source = {Paper::literature, "Lamb 1932"},
        .says =
            "of the same: how much faster it decays with 3 ν = 0.015 than with ν, over Lamb's "
            "4 ν k² t: half as much, since Brookshaw's form, without the transposed gradient, does "
            "not know of a surface without stress; twice that if the larger one is 5 ν",
        .bound =
            between(0.27, 0.55,
                    "it takes μ ∫ |∇v|² dA of the energy, where a fluid takes 2 μ ∫ e:e, and in "
                    "a wave, v = ∇φ, e = ∇v: 1/2. Lamb's formula neglects ν k²/ω = 8 %; 0.8 of "
                    "the strain is within a support of the surface, 2 k h = 1.6, where on average "
                    "a quarter of the neighbours is missing, on both sides of a pair: up to 0.4 "
                    "less. 0.5 · 0.6 · 0.92 to 0.5 · 1.08"),
        .measure = [] { return ratio_of_decay(3.0); },
        .sabotaged = [] { return ratio_of_decay(5.0); }}};
}  // namespace
}  // namespace standing_wave_claims
