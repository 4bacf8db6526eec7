#include "solver/surface/density_field.h"

#include "solver/kernels/wendland_c2.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"
#include "verification/surface/particle_surface.h"

namespace density_field_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// How far the surface of a block is from half a spacing beyond its outermost particles [spacings].
template <int Dim> double off_the_plane(double level) {
    using W = WendlandC2<Dim>;
    const Level found = level_above_block<Dim>(
        [=](std::span<const double> m) {
            return DensityField<W>{W(3.0), m, level};
        },
        0.25);
    return std::max(std::abs(found.low), std::abs(found.high));
}
const Register plane{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "density_field.flat_surface",
        .source = {Paper::adams2009, "Sec. 6.5"},
        .says =
            "where the density of a block is half of that inside, half a spacing beyond its "
            "particles, is its surface: largest distance from it [spacings]; not at a quarter",
        .bound = at_most(
            0.1,
            "half of the kernel's mass is on either side of the plane. Its lattice sum, h = 3 "
            "spacings, errs by less than 2 % of the density inside, over a slope of at "
            "least 1 / h: 0.06; and cell² f″ / 8 = 0.0625 · 2 / h / 8 for the grid, 0.01"),
        .measure = [] { return off_the_plane<Dim>(0.5); },
        .sabotaged = [] { return off_the_plane<Dim>(0.25); }};
})};
}  // namespace
}  // namespace density_field_claims
