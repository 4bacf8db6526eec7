#include "verification/cases/lid_driven_cavity.h"
#include "verification/framework/registry.h"
#include "verification/framework/validation.h"
#include "verification/reference_data/reference.h"

#include <algorithm>

namespace lid_driven_cavity_validation {
namespace {
using namespace verification;

/// One component on a centreline, walls left out, and how well it is known.
struct Profile {
    Curve curve;
    double uncertainty = 0.0;
    Profile(double reynolds, const std::string& component) {
        const Reference table("ghia_audit");
        std::vector<std::pair<double, double>> points;
        for (std::size_t k = 0; k < table.rows(); ++k) {
            const double at = table["position"][k];
            if (table["Re"][k] != reynolds || table.text("component")[k] != component) continue;
            if (at <= 0.0 || at >= 1.0) continue;
            points.emplace_back(at, table["recomputed"][k]);
            uncertainty = std::max(uncertainty, table["est_uncertainty"][k]);
        }
        std::ranges::sort(points);
        for (const auto& [at, value] : points) curve.x.push_back(at), curve.y.push_back(value);
    }
    double least() const { return std::ranges::min(curve.y); }
    double largest() const { return std::ranges::max(curve.y); }
};

/// Until e⁻⁴ is left of the slowest mode of a square, which decays with 2 π² ν ≈ 20/Re per second.
double steady_after(double reynolds) { return 0.2 * reynolds; }

Validation cavity(double reynolds) {
    const Profile u(reynolds, "u"), v(reynolds, "v");
    const auto quantity = [](const char* name, double measured, double uncertainty) {
        return Validation::Quantity{.name = name,
                                    .unit = "1",
                                    .measured = measured,
                                    .u_data = uncertainty,
                                    .u_input = 0.0,
                                    .why =
                                        "of the recomputed table, extrapolated from two grids; the "
                                        "case is defined exactly"};
    };
    const auto panel = [](const char* name, const char* x, const Profile& profile) {
        return Validation::Panel{.name = name,
                                 .x_label = x,
                                 .x_unit = "m",
                                 .y_label = std::string(name) + " over the speed of the lid",
                                 .y_unit = "1",
                                 .measured = profile.curve,
                                 .low = {},
                                 .high = {}};
    };
    return {
        .id = "lid_driven_cavity_" + std::to_string(std::lround(reynolds)),
        .source = {Paper::literature, "Ghia et al. 1982, recomputed"},
        .says =
            "Fluid in a square under a lid that moves: velocities on both centrelines, against a "
            "computation on 256² points, since the printed table has errors of several percent",
        .what_is_run =
            "weakly compressible, c₀ = 10, Wendland C2 of support 4 spacings, density diffusion "
            "0.1, "
            "shifting, averaged pressures over a background of 1 ρ U², walls of particles to which "
            "the fluid sticks",
        .spacing = {1.0 / 10, 1.0 / 14, 1.0 / 20, 1.0 / 28, 1.0 / 40},
        .quick_levels = 0,
        .quantities = {quantity("least u", u.least(), u.uncertainty),
                       quantity("least v", v.least(), v.uncertainty),
                       quantity("largest v", v.largest(), v.uncertainty)},
        .panels = {panel("u", "y at x = 0.5", u), panel("v", "x at y = 0.5", v)},
        .observe = [=](double spacing) -> Validation::Observation {
            const CavityProfiles found = profiles_of({.reynolds = reynolds, .spacing = spacing},
                                                     u.curve.x, v.curve.x, steady_after(reynolds));
            return {
                {std::ranges::min(found.u), std::ranges::min(found.v), std::ranges::max(found.v)},
                {{u.curve.x, found.u}, {v.curve.x, found.v}}};
        }};
}
const RegisterValidation re_100{cavity(100.0)}, re_400{cavity(400.0)}, re_1000{cavity(1000.0)};

/// √ mean (u − table)² on the vertical centreline at Re = 100, with 10² particles after 10 s, over √ mean table².
double error_of_profile(bool sticks) {
    const Profile table(100.0, "u");
    const CavityProfiles found =
        profiles_of({.spacing = 0.1, .sticks = sticks}, table.curve.x, {}, 10.0);
    double error = 0.0, all = 0.0;
    for (std::size_t k = 0; k < found.u.size(); ++k) {
        error += (found.u[k] - table.curve.y[k]) * (found.u[k] - table.curve.y[k]);
        all += table.curve.y[k] * table.curve.y[k];
    }
    return std::sqrt(error / all);
}
const Register claims{
    Claim{.id = "lid_driven_cavity.turns",
          .source = {Paper::literature, "Ghia et al. 1982, recomputed"},
          .says = "rms deviation of u on the vertical centreline from the recomputed table over "
                  "its rms, Re = 100, 10² "
                  "particles; a lid that slips turns nothing",
          .bound = at_most(0.5, "nearer to the table than to no flow, which is 1"),
          .measure = [] { return error_of_profile(true); },
          .sabotaged = [] { return error_of_profile(false); }}};
}  // namespace
}  // namespace lid_driven_cavity_validation
