#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"
#include "verification/reference_data/solve.h"

#include <cmath>
#include <numbers>

namespace free_surface_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;

/// Density at depth z of a column at rest: dp/dz = ρ g with p = (c² ρ₀/γ)((ρ/ρ₀)^γ − 1).
double density_at_rest(const Row& r) {
    const double gamma = r("gamma"), c = r("c0_over_sqrt_gH"), z = r("depth_over_H");
    if (gamma == 1) return std::exp(z / (c * c));
    return std::pow(1 + (gamma - 1) * z / (c * c), 1 / (gamma - 1));
}
double pressure_at_rest(const Row& r) {
    const double gamma = r("gamma"), c = r("c0_over_sqrt_gH"), z = r("depth_over_H");
    // (1 + s)^a − 1 without cancellation
    return c * c / gamma *
           (gamma == 1 ? std::expm1(z / (c * c))
                       : std::expm1(gamma / (gamma - 1) * std::log1p((gamma - 1) * z / (c * c))));
}
double hydrostatic(bool stiff) {
    const Reference table("hydrostatic_tait_exact");
    const double p = worst_difference(
        table, "p", [=](const Row& r) { return stiff ? r("depth_over_H") : pressure_at_rest(r); },
        1e-3);
    const double rho = worst_difference(table, "rho_over_rho0", density_at_rest);
    const double excess = worst_difference(
        table, "rel_excess_over_linear",
        [](const Row& r) {
            return r("depth_over_H") == 0 ? 0.0 : pressure_at_rest(r) / r("depth_over_H") - 1;
        },
        1e-3);
    return std::max({p, rho, excess});
}

/// a, b: half axes [m]; A: rate of stretch [1/s] of u = (−A x, A y). sign: +1 as the pressure acts.
using Drop = std::vector<double>;
Drop drop_at(double time, double sign) {
    const auto rates = [=](double, const double y[], double change[]) {
        const double a = y[0], b = y[1], A = y[2];
        change[0] = -a * A;
        change[1] = b * A;
        change[2] = sign * A * A * (a * a - b * b) / (a * a + b * b);
    };
    return solve_ode(rates, {1, 1, 100}, time);
}
double elliptical_drop(double sign) {
    const Reference table("elliptical_drop_exact");
    const auto worst = [&](const char* column, auto value) {
        return worst_difference(table, column,
                                [=](const Row& r) { return value(drop_at(r("t"), sign)); });
    };
    return std::max({worst("a_x", [](const Drop& d) { return d[0]; }),
                     worst("b_y", [](const Drop& d) { return d[1]; }),
                     worst("A", [](const Drop& d) { return d[2]; }),
                     worst("p_centre",
                           [](const Drop& d) {
                               const double a = d[0], b = d[1], A = d[2];
                               return A * A * a * a * b * b / (a * a + b * b);
                           }),
                     worst("kinetic_energy", [](const Drop& d) {
                         return std::numbers::pi / 8 * d[2] * d[2] * (d[0] * d[0] + d[1] * d[1]);
                     })});
}

double first_order_frequency(const Row& r) { return std::sqrt(std::tanh(r("kh"))); }
/// ω = ω₀ + ε²/2 ω₂.
double second_order_frequency(const Row& r, double sign) {
    const double w = first_order_frequency(r);
    return (9 * std::pow(w, -7) - 12 * std::pow(w, -3) - 3 * w - sign * 2 * std::pow(w, 5)) / 32;
}
double standing_wave(double sign) {
    const Reference table("standing_wave_frequency");
    const auto ratio = [=](double eps) {
        return [=](const Row& r) {
            return 1 + eps * eps / 2 * second_order_frequency(r, sign) / first_order_frequency(r);
        };
    };
    // ω₂ goes through zero at kh = 1.058, where all its terms are 3/16.
    return std::max(
        {worst_difference(table, "omega0", first_order_frequency),
         worst_difference(
             table, "omega2", [=](const Row& r) { return second_order_frequency(r, sign); }, 0.1),
         worst_difference(table, "ratio_eps0.05", ratio(0.05)),
         worst_difference(table, "ratio_eps0.10", ratio(0.10))});
}

const Register claims_of_free_surface{
    Claim{.id = "reference_data.hydrostatic_tait",
          .source = {Paper::adams2009, "Eq. 47"},
          .says = "density and pressure of a column at rest under the Tait equation",
          .bound = at_most(1e-8,
                           "12 printed digits, of the pressure; its excess over the linear law "
                           "is 5e-5 at least, from pressures near 0.25 with 12 digits: "
                           "1e-12 / 0.25 / 5e-5, and 12 digits of its own"),
          .measure = [] { return hydrostatic(false); },
          .sabotaged = [] { return hydrostatic(true); }},
    Claim{
        .id = "reference_data.elliptical_drop",
        .source = {Paper::literature, "Monaghan 1994"},
        .says = "half axes, rate, pressure and energy of the drop that stretches itself",
        .bound = at_most(1e-12, "14 printed digits; tolerance 1e-14 per step of at most 100 steps"),
        .measure = [] { return elliptical_drop(1); },
        .sabotaged = [] { return elliptical_drop(-1); }},
    Claim{
        .id = "reference_data.standing_wave",
        .source = {Paper::literature, "Tadjbakhsh and Keller 1960"},
        .says = "linear frequency and the correction of second order in the steepness",
        .bound = at_most(1e-9, "10 printed digits, of kh, too: 5e-10 relative where that is 1.57"),
        .measure = [] { return standing_wave(1); },
        .sabotaged = [] { return standing_wave(-1); }},
};
}  // namespace
}  // namespace free_surface_claims
