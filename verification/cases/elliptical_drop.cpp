#include "verification/cases/elliptical_drop.h"

#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

namespace elliptical_drop_claims {
namespace {
using namespace verification;

constexpr double end = 0.0076, spacing = 1.0 / 14.0;

double exact(const std::string& column) {
    const Reference table("elliptical_drop_exact");
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (std::abs(table["t"][row] - end) < 1e-12) return table[column][row];
    return NAN;
}
double error_of_long_axis(double alpha) {
    return std::abs(simulate({.spacing = spacing, .alpha = alpha}, end).half_axis_y - exact("b_y"));
}
double error_of_short_axis(double alpha) {
    return std::abs(simulate({.spacing = spacing, .alpha = alpha}, end).half_axis_x - exact("a_x"));
}
double loss_of_energy(double alpha) {
    return 1.0 - simulate({.spacing = spacing, .alpha = alpha}, end).kinetic_energy;
}

const Register claims_of_elliptical_drop{
    Claim{.id = "elliptical_drop.long_axis",
          .source = {Paper::literature, "Monaghan 1994"},
          .says = "half axis at t = 0.0076 s with 14 particles per radius, where it is 1.9445 m: "
                  "error [m]",
          .bound = at_most(0.5 * spacing,
                           "the edge of a drop made of particles is known to half of a "
                           "spacing"),
          .measure = [] { return error_of_long_axis(0.0); },
          .sabotaged = [] { return error_of_long_axis(1.0); }},
    Claim{.id = "elliptical_drop.short_axis",
          .source = {Paper::literature, "Monaghan 1994"},
          .says = "the other half axis, 0.5143 m: error [m]",
          .bound = at_most(0.5 * spacing,
                           "the edge of a drop made of particles is known to half of a "
                           "spacing"),
          .measure = [] { return error_of_short_axis(0.0); },
          .sabotaged = [] { return error_of_short_axis(1.0); }},
    Claim{.id = "elliptical_drop.kinetic_energy",
          .source = {Paper::literature, "Monaghan 1994"},
          .says = "an incompressible drop keeps all of its kinetic energy: the part that is lost",
          .bound = between(-0.02, 0.02,
                           "the compression that (v/c)² = 0.5 % allows, and as much again for "
                           "waves from its start, each as kinetic and as stored energy"),
          .measure = [] { return loss_of_energy(0.0); },
          .sabotaged = [] { return loss_of_energy(0.1); }}};
}  // namespace
}  // namespace elliptical_drop_claims
