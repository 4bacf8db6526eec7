#include "verification/cases/sloshing.h"
#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

namespace sloshing_claims {
namespace {
using namespace verification;

/// |ω/√(g k tanh kh) − 1| of the first mode in a tank, 12 particles deep.
double error_of_frequency(double support, double jitter) {
    const WaterTank tank{.tank = {0.5, 0.6},
                         .water = {0.5, 0.4},
                         .spacing = 0.4 / 12,
                         .support = support,
                         .sound = 10.0,
                         .jitter = jitter};
    return std::abs(sloshing_decay(tank, 0.1, 2).frequency / sloshing_frequency(tank) - 1.0);
}

/// Of the elevation that Faltinsen et al. measured with that of linear theory, `delay` later [s].
double correlation(double delay) {
    const Reference table("faltinsen_2000_sloshing_elevation");
    const WaterTank tank{
        .tank = {1.73, 1.15}, .water = {1.73, 0.6}, .spacing = 0.1, .sway = 0.032, .period = 1.3};
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t k = 0; k < table.rows(); ++k) {
        const double x = linear_elevation(tank, 0.05, table["t"][k] - delay), y = table["eta"][k];
        xx += x * x, xy += x * y, yy += y * y;
    }
    return xy / std::sqrt(xx * yy);
}

const Register claims_of_sloshing{
    Claim{
        .id = "sloshing.frequency",
        .source = {Paper::literature, "Lamb 1932"},
        .says =
            "the first mode of a tank, water 12 particles deep and 15 long, steepness 0.1: ω "
            "against √(g k tanh kh); with a support of 2.6 spacings instead of 4, a lattice under "
            "pressure resists shear, and it is too fast, however fine",
        .bound = at_most(0.032,
                         "density and pressure are averages over the kernel, of the second "
                         "moment 0.07 h², k h = 0.84: 5 % of ω², 2.5 % of ω; sound, "
                         "g H/c² = 1 %, half of that; steepness 0.1²/8, decay δ²/(2 ω²)"),
        .measure = [] { return error_of_frequency(4.0, 0.1); },
        .sabotaged = [] { return error_of_frequency(2.6, 0.0); }},
    Claim{.id = "sloshing.published_elevation_is_near_linear_theory",
          .source = {Paper::literature, "Faltinsen et al. 2000, Fig. 7"},
          .says =
              "how the tank was moved is told by what was measured: correlation of the elevation "
              "with that of linear theory for a sway as the cosine, from rest; for a sine, a "
              "quarter of a period later, there is none",
          .bound =
              at_least(0.9,
                       "waves of k a = 0.2 have second harmonics of up to a third of their height: "
                       "1/√(1 + 0.3²) = 0.96, and as much for crests late by a tenth of a "
                       "radian and for reading"),
          .measure = [] { return correlation(0.0); },
          .sabotaged = [] { return correlation(1.3 / 4); }}};
}  // namespace
}  // namespace sloshing_claims
