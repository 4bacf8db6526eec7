#include "verification/cases/channel.h"
#include "verification/framework/registry.h"

namespace hydrostatic_column_claims {
namespace {
using namespace verification;

constexpr double spacing = 1.0 / 20.0;

/// The column after 1 s, which sound crosses ten times; it starts from exact hydrostatics.
ChannelState column(double gravity) {
    return simulate({.spacing = spacing,
                     .gravity = {0.0, gravity},
                     .viscosity = 0.02,
                     .slip = true,
                     .lid = false},
                    1.0);
}
/// max |p − ρ₀ g (1 − y)| / (ρ₀ g H) farther than a support from the wall and the surface.
double error_of_pressure(double gravity) {
    const ChannelState end = column(gravity);
    double worst = 0.0;
    for (std::size_t i = 0; i < end.x.size(); ++i) {
        const double y = end.x[i][1];
        if (y > 3.0 * spacing && y < 1.0 - 3.0 * spacing)
            worst = std::max(worst, std::abs(end.pressure[i] - (1.0 - y)));
    }
    return worst;
}
const Register claims_of_column{Claim{
    .id = "hydrostatic_column.pressure",
    .source = {Paper::adams2009, "Eqs. 47, 48, 55; Sec. 6.3"},
    .says = "pressure of a column of 20 particles, 1 s after its start, over ρ₀ g H; without the "
            "external force, which Algorithm 5 leaves out, it expands",
    .bound = at_most(0.05,
                     "a ghost has the pressure of the particle, not that of its own depth: "
                     "the wall is felt up to one spacing off, ρ₀ g times 0.05 H"),
    .measure = [] { return error_of_pressure(-1.0); },
    .sabotaged = [] { return error_of_pressure(0.0); },
    .erratum = 31}};
}  // namespace
}  // namespace hydrostatic_column_claims
