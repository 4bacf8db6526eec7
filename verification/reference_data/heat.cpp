#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"
#include "verification/reference_data/solve.h"

#include <cmath>
#include <numbers>

namespace heat_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;

double gaussian(double extra_dimension) {
    const Reference table("heat_gaussian");
    return std::max(
        worst_difference(table, "T_peak",
                         [=](const Row& r) {
                             return std::pow(1 + 2 * r("tau"), -(r("dim") + extra_dimension) / 2);
                         }),
        worst_difference(table, "width", [](const Row& r) { return std::sqrt(1 + 2 * r("tau")); }));
}

/// Half spaces of 0 (left, α = 1) and 1 (right, conductivity and α `ratio` times as large).
double two_slabs(const Row& r, double ratio, double interface_temperature) {
    const double x = r("x"), t = r("t");
    if (x <= 0) return interface_temperature * std::erfc(-x / (2 * std::sqrt(t)));
    return 1 - (1 - interface_temperature) * std::erfc(x / (2 * std::sqrt(ratio * t)));
}
double worst_slabs(double unequal_interface) {
    const Reference table("heat_two_slabs");
    return std::max(worst_difference(
                        table, "T_equal", [](const Row& r) { return two_slabs(r, 1, 0.5); }, 1.0),
                    worst_difference(
                        table, "T_unequal_kappa",
                        [=](const Row& r) { return two_slabs(r, 10, unequal_interface); }, 1.0));
}
/// √(κρc) decides who gives way.
double interface_of_effusivities() { return std::sqrt(10.0) / (1 + std::sqrt(10.0)); }
double interface_of_conductivities() { return 10.0 / 11.0; }

/// √π λ exp(λ²) erf λ = St.
double stefan_number(double lambda) {
    return std::sqrt(std::numbers::pi) * lambda * std::exp(lambda * lambda) * std::erf(lambda);
}
double stefan(double factor) {
    const Reference table("stefan_one_phase");
    const auto lambda = [=](const Row& r) {
        const double St = r("St");
        return root([=](double l) { return stefan_number(l) - factor * St; }, 1e-6, 4);
    };
    return std::max({worst_difference(table, "lambda", lambda),
                     worst_difference(table, "X_over_sqrt_alpha_t",
                                      [=](const Row& r) { return 2 * lambda(r); }),
                     worst_difference(table, "lambda_over_quasi_steady", [=](const Row& r) {
                         return lambda(r) / std::sqrt(r("St") / 2);
                     })});
}

/// Heat that the liquid brings less what the solid takes, over that of melting.
double two_phase_balance(double lambda, double alpha, double hot, double cold) {
    constexpr double rho = 1000, k_l = 0.6, k_s = 2.2, c_s = 2100, latent = 334000;
    const double alpha_s = k_s / (rho * c_s), q = alpha / alpha_s, l2 = lambda * lambda;
    const double from_liquid =
        k_l * hot / std::sqrt(std::numbers::pi * alpha) * std::exp(-l2) / std::erf(lambda);
    const double into_solid = k_s * cold / std::sqrt(std::numbers::pi * alpha_s) *
                              std::exp(-l2 * q) / std::erfc(lambda * std::sqrt(q));
    return (from_liquid - into_solid) / (rho * latent * std::sqrt(alpha)) - lambda;
}
double stefan_two_phases(bool solid_takes_heat) {
    const Reference table("stefan_two_phase_example");
    const double alpha = 0.6 / (1000 * 4186.0);
    const auto lambda = [=](const Row& r) {
        const double hot = r("Tw"), cold = solid_takes_heat ? -r("Ti") : 0.0;
        return root([=](double l) { return two_phase_balance(l, alpha, hot, cold); }, 1e-3, 2);
    };
    return std::max({worst_difference(table, "alpha_l", [=](const Row&) { return alpha; }),
                     worst_difference(table, "lambda", lambda),
                     worst_difference(table, "X_at_100s", [=](const Row& r) {
                         return 2 * lambda(r) * std::sqrt(100 * alpha);
                     })});
}

const Register claims_of_heat{
    Claim{.id = "reference_data.heat_gaussian",
          .source = {Paper::literature, "fundamental solution of the heat equation"},
          .says = "peak (1 + 2τ)^(−d/2) and width √(1 + 2τ) of a spreading Gaussian",
          .bound = at_most(rounding_to(10), "10 printed digits"),
          .measure = [] { return gaussian(0); },
          .sabotaged = [] { return gaussian(1); }},
    Claim{.id = "reference_data.heat_two_slabs",
          .source = {Paper::literature, "Cleary and Monaghan 1999"},
          .says = "two half spaces in contact, of equal and of tenfold conductivity",
          .bound = at_most(1e-12, "12 printed digits, of a temperature difference of 1"),
          .measure = [] { return worst_slabs(interface_of_effusivities()); },
          .sabotaged = [] { return worst_slabs(interface_of_conductivities()); }},
    Claim{.id = "reference_data.stefan_one_phase",
          .source = {Paper::literature, "Neumann's similarity solution"},
          .says = "the front of melting, √π λ exp(λ²) erf λ = St",
          .bound = at_most(1e-14, "15 printed digits; the root to 1e-15"),
          .measure = [] { return stefan(1); },
          .sabotaged = [] { return stefan(std::sqrt(std::numbers::pi)); }},
    Claim{.id = "reference_data.stefan_two_phases",
          .source = {Paper::literature, "Neumann's similarity solution"},
          .says = "the front of melting into ice below its melting point",
          .bound = at_most(rounding_to(12), "12 printed digits"),
          .measure = [] { return stefan_two_phases(true); },
          .sabotaged = [] { return stefan_two_phases(false); }},
};
}  // namespace
}  // namespace heat_claims
