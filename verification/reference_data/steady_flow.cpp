#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <cmath>
#include <numbers>

namespace steady_flow_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;
constexpr double pi = std::numbers::pi;

double decay(const Row& r, double power) {
    return std::exp(-power * 8 * pi * pi / r("Re") * r("t"));
}
double taylor_green(double power_of_energy) {
    const Reference table("taylor_green_decay");
    const auto worst = [&](const char* column, double power) {
        return worst_difference(table, column, [=](const Row& r) { return decay(r, power); });
    };
    return std::max({worst("umax_exact", 1), worst("ke_over_ke0_exact", power_of_energy),
                     worst("umax_if_laplacian_is_1.5x", 1.5), worst("umax_if_laplacian_is_2x", 2)});
}

/// ∫ v²/r dr + 5, in the three parts of the profile.
double gresho_pressure(const Row& row) {
    const double r = row("r");
    if (r <= 0.2) return 5 + 12.5 * r * r;
    if (r <= 0.4) return 9 + 12.5 * r * r - 20 * r + 4 * std::log(5 * r);
    return 3 + 4 * std::log(2.0);
}
double gresho_velocity(const Row& row) {
    return std::max(0.0, std::min(5 * row("r"), 2 - 5 * row("r")));
}

/// p of Δp = 2 on the unit square, zero at its faces: a parabola and a series of `terms`.
double square_patch_pressure(const Row& row, int terms) {
    const double x = row("x_over_L"), y = row("y_over_L");
    double p = x * x - 0.25;
    for (int n = 0; n < terms; ++n) {
        const double k = (2 * n + 1) * pi, sign = n % 2 == 0 ? 1 : -1;
        p += 8 * sign / (k * k * k) * std::cos(k * x) * std::cosh(k * y) / std::cosh(k / 2);
    }
    return p;
}
double square_patch(int terms) {
    return worst_difference(Reference("rotating_square_patch_p0"), "p",
                            [=](const Row& r) { return square_patch_pressure(r, terms); });
}

/// The manufactured flow and the force that drives it, each factor written out.
struct Manufactured {
    double u, v, p, S_x, S_y;
};
Manufactured manufactured(const Row& row, double nu) {
    const double k = 2 * pi, e = std::exp(-row("t"));
    const double sx = std::sin(k * row("x")), cx = std::cos(k * row("x"));
    const double sy = std::sin(k * row("y")), cy = std::cos(k * row("y"));
    const double s2y = std::sin(2 * k * row("y")), c2y = std::cos(2 * k * row("y"));
    const double u = sx * cy * e, v = -cx * sy * e, p = 0.5 * cx * c2y * e;
    const double u_x = k * cx * cy * e, u_y = -k * sx * sy * e;
    const double v_x = k * sx * sy * e, v_y = -k * cx * cy * e;
    const double p_x = -0.5 * k * sx * c2y * e, p_y = -k * cx * s2y * e;
    return {u, v, p, -u + u * u_x + v * u_y + p_x + 2 * nu * k * k * u,
            -v + u * v_x + v * v_y + p_y + 2 * nu * k * k * v};
}
double manufactured_flow(double nu) {
    const Reference table("mms_fluid_periodic");
    const auto worst = [&](const char* column, double Manufactured::*part) {
        return worst_difference(table, column,
                                [=](const Row& r) { return manufactured(r, nu).*part; });
    };
    return std::max({worst("u", &Manufactured::u), worst("v", &Manufactured::v),
                     worst("p", &Manufactured::p), worst("S_x", &Manufactured::S_x),
                     worst("S_y", &Manufactured::S_y)});
}

const Register claims_of_steady_flow{
    Claim{.id = "reference_data.taylor_green_decay",
          .source = {Paper::literature, "Taylor and Green 1937"},
          .says =
              "velocity decays as exp(−8π² t/Re), energy as its square, also with wrong viscosity",
          .bound = at_most(rounding_to(10), "10 printed digits"),
          .measure = [] { return taylor_green(2); },
          .sabotaged = [] { return taylor_green(1); }},
    Claim{.id = "reference_data.gresho_vortex",
          .source = {Paper::literature, "Gresho and Chan 1990"},
          .says = "the velocity, and the pressure that balances it",
          .bound = at_most(rounding_to(10), "10 printed digits"),
          .measure =
              [] {
                  const Reference table("gresho_vortex");
                  return std::max(worst_difference(table, "p", gresho_pressure),
                                  worst_difference(table, "v_phi", gresho_velocity, 1e-3));
              },
          .sabotaged =
              [] {  // solid rotation all the way
                  return worst_difference(Reference("gresho_vortex"), "p",
                                          [](const Row& r) { return 5 + 12.5 * r("r") * r("r"); });
              }},
    Claim{.id = "reference_data.rotating_square_patch",
          .source = {Paper::literature, "Colagrossi 2005"},
          .says = "Δp = 2ρω² in the square, p = 0 on its faces",
          .bound = at_most(1e-12,
                           "14 printed digits, the smallest value 0.0087 of terms up to 0.25: "
                           "25 · 1.1e-16 / 0.0087"),
          .measure = [] { return square_patch(100); },
          .sabotaged = [] { return square_patch(3); }},
    Claim{.id = "reference_data.manufactured_flow",
          .source = {Paper::literature, "Negi and Ramachandran 2021"},
          .says = "the force is Du/Dt + ∇p − ν Δu of the field in the file",
          .bound = at_most(1e-13,
                           "14 printed digits; sums of terms up to 10 for values from 0.1 on: "
                           "8 · 10 · 1.1e-16 / 0.1"),
          .measure = [] { return manufactured_flow(0.01); },
          .sabotaged = [] { return manufactured_flow(0.02); }},
};
}  // namespace
}  // namespace steady_flow_claims
