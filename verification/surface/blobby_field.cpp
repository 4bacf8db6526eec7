#include "solver/surface/blobby_field.h"

#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"
#include "verification/surface/particle_surface.h"

namespace blobby_field_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double level = 0.5, cell = 0.05;

template <int Dim> double error_of_radius(double exponent) {
    const double radius = std::sqrt(1.0 - std::pow(level, exponent));
    return error_around_one<Dim>(BlobbyField<Dim>{1.0, level}, radius, cell);
}
const Register sphere{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "blobby_field.sphere_of_one_particle",
        .source = {Paper::literature, "Zhu and Bridson 2005"},
        .says =
            "a particle alone has a sphere of radius R √(1 − level^⅓): largest error [R]; not with "
            "the square root of the level",
        .bound =
            at_most(1.1 * 0.275 * cell * cell,
                    "cell²/8 of the bend along an edge, at most |k′|/s = 6 (1 − s²)² = 3.78 or "
                    "|k″| = 0.15, over the slope |k′| = 1.72: 0.275 cell²; 10 % for higher orders"),
        .measure = [] { return error_of_radius<Dim>(1.0 / 3.0); },
        .sabotaged = [] { return error_of_radius<Dim>(1.0 / 2.0); }};
})};
}  // namespace
}  // namespace blobby_field_claims
