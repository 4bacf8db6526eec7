#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <cmath>
#include <numbers>

namespace channel_flow_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;
constexpr double pi = std::numbers::pi;

/// 4 y (1 − y) less what still decays; `terms` of the series.
double poiseuille(const Row& r, int terms) {
    const double tau = r("tau"), y = r("y_over_L");
    double u = 4 * y * (1 - y);
    for (int n = 0; n < terms; ++n) {
        const double k = (2 * n + 1) * pi;
        u -= 32 / (k * k * k) * std::sin(k * y) * std::exp(-k * k * tau);
    }
    return u;
}
/// Images of the moving wall: Σ erfc((2n + 1 − y)/2√τ) − erfc((2n + 1 + y)/2√τ). The other solution
/// of the same problem: no cancellation where the flow has hardly begun.
double couette(const Row& r, int images) {
    const double root = 2 * std::sqrt(r("tau")), y = r("y_over_L");
    double u = 0;
    for (int n = 0; n < images; ++n)
        u += std::erfc((2 * n + 1 - y) / root) - std::erfc((2 * n + 1 + y) / root);
    return u;
}

double worst_poiseuille(int terms) {
    return worst_difference(
        Reference("startup_poiseuille_couette"), "u_poiseuille",
        [=](const Row& r) { return poiseuille(r, terms); }, 0.01);
}
/// The series of the file was summed with 30 digits, of terms up to 2/π: what is below their last
/// place is noise, and relative to what is smaller than `floor` more than `accuracy`.
constexpr double last_place_of_series = 1e-30, accuracy = 1e-12;
double worst_couette(int images) {
    constexpr double floor = last_place_of_series / accuracy;
    return worst_difference(
        Reference("startup_poiseuille_couette"), "u_couette",
        [=](const Row& r) { return couette(r, images); }, floor);
}

const Register claims_of_channel_flow{
    Claim{.id = "reference_data.startup_of_poiseuille_flow",
          .source = {Paper::literature, "Morris, Fox and Zhu 1997"},
          .says = "the velocity between two plates after the force sets in",
          .bound = at_most(1e-12,
                           "14 printed digits; terms up to 1 for values from 0.01 on, 60 of "
                           "them: 60 · 1.1e-16 / 0.01"),
          .measure = [] { return worst_poiseuille(60); },
          .sabotaged = [] { return worst_poiseuille(2); }},
    Claim{.id = "reference_data.startup_of_couette_flow",
          .source = {Paper::literature, "Morris, Fox and Zhu 1997"},
          .says =
              "the series agrees with images of the moving wall, to 1e-12 or to the last of the 30 "
              "digits that the series was summed with",
          .bound = at_most(accuracy,
                           "14 printed digits, 30 in the series; erfc of x is off by 2x² · "
                           "1.1e-16 for arguments rounded once, x² up to 81, and 1e-16 by itself"),
          .measure = [] { return worst_couette(12); },
          .sabotaged = [] { return worst_couette(1); }},
};
}  // namespace
}  // namespace channel_flow_claims
