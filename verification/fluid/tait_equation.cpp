#include "solver/fluid/tait_equation.h"

#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

namespace tait_equation_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double exponents[] = {1.0, 1.4, 4.0, 7.0};

/// max |p − K ((ρ/ρ₀)^γ − 1)| / (ρ₀ c₀²), in 50 digits, over compressions of 10 %.
double error_of_pressure(double factor_of_stiffness) {
    double worst = 0.0;
    for (const double gamma : exponents) {
        const TaitEquation tait(1000.0, 20.0, gamma);
        for (int k = -10; k <= 10; ++k) {
            const double rho = 1000.0 + 10.0 * k;
            const Real50 K = Real50(1000.0) * 400.0 / gamma;
            const Real50 p = factor_of_stiffness * K * (pow(Real50(rho) / 1000, gamma) - 1);
            worst = std::max(worst, std::abs(static_cast<double>(tait.pressure(rho) - p)) / 4e5);
        }
    }
    return worst;
}
/// max |f′ − difference quotient of f| / scale, for c² = dp/dρ and p/ρ² = de/dρ.
template <class F, class Slope> double error_of_slope(F f, Slope slope, double scale) {
    double worst = 0.0;
    for (const double gamma : exponents) {
        const TaitEquation tait(1000.0, 20.0, gamma);
        for (const double rho : {950.0, 1000.0, 1003.0, 1100.0}) {
            const double d = 0.5;
            const double quotient = (8.0 * (f(tait, rho + d) - f(tait, rho - d)) -
                                     (f(tait, rho + 2 * d) - f(tait, rho - 2 * d))) /
                                    (12.0 * d);
            worst = std::max(worst, std::abs(quotient - slope(tait, rho)) / scale);
        }
    }
    return worst;
}
double error_of_sound(double power) {
    return error_of_slope(
        [](const TaitEquation& t, double rho) { return t.pressure(rho); },
        [=](const TaitEquation& t, double rho) { return std::pow(t.speed_of_sound(rho), power); },
        400.0);
}
double error_of_energy(bool without_square) {
    return error_of_slope([](const TaitEquation& t, double rho) { return t.energy(rho); },
                          [=](const TaitEquation& t, double rho) {
                              return t.pressure(rho) / rho / (without_square ? 1000.0 : rho);
                          },
                          4e5 / 1e6);
}
double error_of_inverse(double p_added) {
    double worst = 0.0;
    for (const double gamma : exponents) {
        const TaitEquation tait(1000.0, 20.0, gamma);
        for (double rho = 900.0; rho < 1100.0; rho += 0.7)
            worst =
                std::max(worst, std::abs(tait.density(tait.pressure(rho) + p_added) / rho - 1.0));
    }
    return worst;
}
/// The density of a column at rest under gravity, from dp/dz = −ρ g integrated over the column.
double error_of_column(double exponent_of_table) {
    const Reference table("hydrostatic_tait_exact");
    return worst_difference(table, "rho_over_rho0", [=](const ReferenceRow& r) {
        const TaitEquation tait(1.0, r("c0_over_sqrt_gH"), r("gamma") + exponent_of_table);
        return tait.density(r("p"));
    });
}
/// How many of nine bad sets of parameters are taken; with γ larger by `more` only eight are bad.
double accepted(double more) {
    int accepted = 0;
    const double bad[][3] = {{0, 1, 7},  {-1, 1, 7},  {1, 0, 7},   {1, -2, 7},      {1, 1, 0.5},
                             {1, 1, -7}, {NAN, 1, 7}, {1, 1, NAN}, {1, HUGE_VAL, 7}};
    for (const auto& [rho, c, gamma] : bad) try {
            TaitEquation(rho, c, gamma + more);
            ++accepted;
        } catch (const InvalidInput&) {
            continue;
        }
    return accepted;
}

const Register claims_of_tait{
    Claim{
        .id = "tait_equation.pressure",
        .source = {Paper::adams2009, "Eq. 47"},
        .says = "p = K ((ρ/ρ₀)^γ − 1), K = ρ₀ c₀²/γ, in units of ρ₀ c₀², for ρ/ρ₀ from 0.9 to 1.1",
        .bound = at_most(1e-15,
                         "(ρ/ρ₀)^γ < 2 is off by 7 · 1.1e-16 from ρ/ρ₀ and one unit from "
                         "pow, times 1/γ: 1.95 (7 · 1.1e-16 + 2.2e-16)/7 and two products"),
        .measure = [] { return error_of_pressure(1.0); },
        .sabotaged = [] { return error_of_pressure(7.0); }},
    Claim{.id = "tait_equation.speed_of_sound",
          .source = {Paper::adams2009, "Eq. 47; Sec. 6"},
          .says = "c² = dp/dρ, in units of c₀²: K is chosen by the speed of sound",
          .bound = at_most(1e-10,
                           "differences of fourth order over 0.5 kg/m³: (5e-4)⁴/30 · "
                           "6·5·4·3·2 = 2e-12, and rounding 1e-15 ρ₀/0.5 = 2e-12"),
          .measure = [] { return error_of_sound(2.0); },
          .sabotaged = [] { return error_of_sound(1.99); }},
    Claim{.id = "tait_equation.energy",
          .source = {Paper::plumbline, "docstring of TaitEquation::energy"},
          .says = "de/dρ = p/ρ², in units of c₀²/ρ₀",
          .bound = at_most(1e-10,
                           "differences of fourth order as for the speed of sound; e cancels "
                           "from terms of size c₀²: rounding 1e-15 ρ₀/0.5 = 2e-12"),
          .measure = [] { return error_of_energy(false); },
          .sabotaged = [] { return error_of_energy(true); }},
    Claim{.id = "tait_equation.inverse",
          .source = {Paper::plumbline, "docstring of TaitEquation::density"},
          .says = "ρ(p(ρ)) = ρ for ρ/ρ₀ from 0.9 to 1.1",
          .bound = at_most(4e-15,
                           "p/K + 1 is off by 3e-16 · 2/0.47, its root by 1/γ of that and 2 "
                           "roundings; for γ = 1 by all of it, p being a product"),
          .measure = [] { return error_of_inverse(0.0); },
          .sabotaged = [] { return error_of_inverse(1.0); }},
    Claim{.id = "tait_equation.hydrostatic_column",
          .source = {Paper::adams2009, "Eq. 47"},
          .says = "ρ at the pressures of the exact column, γ of 1 and 7",
          .bound = at_most(
              6e-12, "12 printed digits of ρ/ρ₀ and of p, the latter divided by ρ₀ c₀² > 50 p"),
          .measure = [] { return error_of_column(0.0); },
          .sabotaged = [] { return error_of_column(1.0); }},
    Claim{.id = "tait_equation.refuses_bad_parameters",
          .source = {Paper::plumbline, "docstring of TaitEquation"},
          .says = "InvalidInput for each of 9 sets of parameters that are not positive or not "
                  "finite, or with γ < 1",
          .bound = at_most(0.0, "a count"),
          .measure = [] { return accepted(0.0); },
          .sabotaged = [] { return accepted(0.5); }},
};
}  // namespace
}  // namespace tait_equation_claims
