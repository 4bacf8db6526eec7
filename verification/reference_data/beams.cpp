#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"
#include "verification/reference_data/solve.h"

#include <cmath>
#include <numbers>

namespace beams_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;
constexpr double pi = std::numbers::pi;

/// A bar that is pulled at its tip from t = 0 on: d'Alembert's wave, period 4.
double bar(double sigma_of_reflection) {
    const Reference table("bar_step_load");
    const auto time = [](const Row& r) { return std::fmod(r("t"), 4.0); };
    return std::max(
        {worst_difference(
             table, "u_tip", [=](const Row& r) { return std::min(time(r), 4 - time(r)); }, 1.0),
         worst_difference(
             table, "v_tip", [=](const Row& r) { return time(r) < 2 ? 1.0 : -1.0; }, 1.0),
         worst_difference(
             table, "sigma_fixed_end",
             [=](const Row& r) { return time(r) >= 1 && time(r) < 3 ? sigma_of_reflection : 0.0; },
             1.0)});
}

/// Deflections under a tip load: P L³/3EI, and the shear terms of two theories.
double cantilever(double shear_coefficient_of_a_rectangle) {
    const Reference table("cantilever_small_load");
    const auto squared = [](const Row& r) { return std::pow(r("L_over_h"), -2); };
    return std::max(
        {worst_difference(table, "w_EB_over_P",
                          [](const Row& r) { return 4 * std::pow(r("L_over_h"), 3); }),
         worst_difference(table, "timoshenko_over_EB",
                          [=](const Row& r) {  // 3 E I / (κ G A L²)
                              const double nu = r("nu");
                              const double kappa = shear_coefficient_of_a_rectangle > 0
                                                       ? shear_coefficient_of_a_rectangle
                                                       : 10 * (1 + nu) / (12 + 11 * nu);
                              return 1 + 3 * 2 * (1 + nu) / (12 * kappa) * squared(r);
                          }),
         worst_difference(table, "timoshenko_goodier_plane_stress_over_EB",
                          [=](const Row& r) { return 1 + (4 + 5 * r("nu")) / 8 * squared(r); })});
}

/// The elastica θ″ = −α cos θ from its free tip, where θ′ = 0, to the clamp.
/// y = (θ, θ′, ∫ sin θ, ∫ (1 − cos θ)).
std::vector<double> elastica_from_tip(double alpha, double tip_angle) {
    const auto rates = [=](double, const double y[], double change[]) {
        change[0] = y[1];
        change[1] = -alpha * std::cos(y[0]);
        change[2] = std::sin(y[0]);
        change[3] = 2 * std::pow(std::sin(y[0] / 2), 2);
    };
    return solve_ode(rates, {tip_angle, 0, 0, 0}, 1);
}
double tip_angle(double alpha) {
    return root([=](double angle) { return elastica_from_tip(alpha, angle)[0]; }, 1e-4,
                pi / 2 - 1e-6);
}
double elastica(bool linear) {
    const Reference table("elastica_tip_load");
    double worst = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double alpha = table["alpha"][i], angle = linear ? alpha / 2 : tip_angle(alpha);
        const auto y = elastica_from_tip(alpha, angle);
        const double w = linear ? alpha / 3 : y[2];
        const auto compare = [&](const char* column, double exact) {
            worst = std::max(worst, std::abs(table[column][i] / exact - 1));
        };
        compare("w_over_L", w);
        compare("u_over_L", y[3]);
        compare("theta_tip", angle);
        compare("w_linear_euler", alpha / 3);
    }
    return worst;
}
/// Of the five digits that Mattiasson printed, how far the table is off, in units of the last.
double mattiasson(double shift) {
    const Reference table("elastica_tip_load");
    double worst = 0;
    for (std::size_t i = 0; i < table.rows(); ++i)
        for (const auto& [printed, exact] :
             {std::pair{"mattiasson_w", "w_over_L"}, std::pair{"mattiasson_u", "u_over_L"}})
            if (!std::isnan(table[printed][i]))
                worst =
                    std::max(worst, std::abs(table[printed][i] - table[exact][i] - shift) / 1e-5);
    return worst;
}

/// Bending moment and shear force at the tip for two unit states at the clamp; zero determinant at a
/// frequency of the Timoshenko beam in plane strain.
double determinant(const Row& r, double omega, double kappa) {
    const double L = r("L"), H = r("H"), E = r("E"), nu = r("nu"), rho = r("rho");
    const double EI = E / (1 - nu * nu) * H * H * H / 12, GA = kappa * E / (2 * (1 + nu)) * H;
    const double rho_A = rho * H * omega * omega, rho_I = rho * H * H * H / 12 * omega * omega;
    const auto rates = [=](double, const double y[], double change[]) {
        for (const int k : {0, 4}) {  // w, φ, M, Q of either state
            change[k] = y[k + 1] + y[k + 3] / GA;
            change[k + 1] = y[k + 2] / EI;
            change[k + 2] = -y[k + 3] - rho_I * y[k + 1];
            change[k + 3] = -rho_A * y[k];
        }
    };
    const auto y = solve_ode(rates, {0, 0, EI / L, 0, 0, 0, 0, EI / (L * L)}, L);
    return y[2] * y[7] - y[3] * y[6];
}
double thin_frequency(const Row& r) {
    static const double kL =
        root([](double x) { return std::cos(x) * std::cosh(x) + 1; }, 1.8, 1.9);
    const double nu = r("nu");
    return std::sqrt(r("E") * std::pow(r("H"), 2) / (12 * r("rho") * (1 - nu * nu))) *
           std::pow(kL / r("L"), 2);
}
double timoshenko_frequency(const Row& r, double kappa) {
    const double thin = thin_frequency(r);
    return root([&](double omega) { return determinant(r, omega, kappa); }, 0.9 * thin, thin);
}
/// Cowper's coefficient with the ratio of plane strain, ν/(1 − ν).
double cowper(const Row& r) {
    const double nu = r("nu") / (1 - r("nu"));
    return 10 * (1 + nu) / (12 + 11 * nu);
}
double plate(bool cowpers) {
    const Reference table("oscillating_plate_period");
    const auto timoshenko = [=](const Row& r) {
        return timoshenko_frequency(r, cowpers ? cowper(r) : 5.0 / 6.0);
    };
    return std::max(
        {worst_difference(table, "omega_thin", thin_frequency),
         worst_difference(table, "T_thin", [](const Row& r) { return 2 * pi / thin_frequency(r); }),
         worst_difference(table, "omega_timoshenko", timoshenko),
         worst_difference(table, "T_timoshenko",
                          [=](const Row& r) { return 2 * pi / timoshenko(r); }),
         worst_difference(table, "c0_bulk", [](const Row& r) {
             return std::sqrt(r("E") / (3 * (1 - 2 * r("nu"))) / r("rho"));
         })});
}

const Register claims_of_beams{
    Claim{.id = "reference_data.bar_step_load",
          .source = {Paper::literature, "d'Alembert 1747"},
          .says = "tip and clamp of a bar pulled from t = 0 on; the stress doubles at the clamp",
          .bound = at_most(0, "whole multiples of 1/4, exact in binary"),
          .measure = [] { return bar(2); },
          .sabotaged = [] { return bar(1); }},
    Claim{.id = "reference_data.cantilever_small_load",
          .source = {Paper::literature, "Timoshenko and Goodier; Cowper 1966"},
          .says = "P L³/3EI, and the corrections for shear of two theories",
          .bound = at_most(rounding_to(10), "10 printed digits"),
          .measure = [] { return cantilever(0); },
          .sabotaged = [] { return cantilever(5.0 / 6.0); }},
    Claim{.id = "reference_data.elastica",
          .source = {Paper::literature, "Euler 1744"},
          .says = "the large bending of a beam, by shooting from the tip",
          .bound = at_most(2e-11,
                           "12 printed digits, 5e-12; the ODE with 1e-14 per step, some 30 "
                           "steps, and an angle that α = 15 makes 40 times as sensitive"),
          .measure = [] { return elastica(false); },
          .sabotaged = [] { return elastica(true); }},
    Claim{.id = "reference_data.elastica_of_mattiasson",
          .source = {Paper::literature, "Mattiasson 1981, Table 1"},
          .says = "agrees with the printed table to half a unit of its last digit",
          .bound = at_most(0.5001, "half a unit, and the rounding of the decimals"),
          .measure = [] { return mattiasson(0); },
          .sabotaged = [] { return mattiasson(1e-5); }},
    Claim{.id = "reference_data.oscillating_plate",
          .source = {Paper::literature, "Gray, Monaghan and Swift 2001; Cowper 1966"},
          .says = "periods of the thin plate and of Timoshenko's, plane strain",
          .bound = at_most(rounding_to(10), "10 printed digits"),
          .measure = [] { return plate(true); },
          .sabotaged = [] { return plate(false); }},
};
}  // namespace
}  // namespace beams_claims
