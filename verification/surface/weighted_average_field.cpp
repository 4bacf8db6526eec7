#include "solver/surface/weighted_average_field.h"

#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"
#include "verification/surface/particle_surface.h"

namespace weighted_average_field_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double cell = 0.05;

const Register sphere{in_dimensions<2, 3>([]<int Dim>() {
    const auto error = [](auto field) { return error_around_one<Dim>(field, 0.5, cell); };
    return Claim{
        .id = "weighted_average_field.sphere_of_one_particle",
        .source = {Paper::literature, "Zhu and Bridson 2005"},
        .says =
            "a particle alone has a sphere of radius r: largest error [R]; not with the "
            "sum of the blobs in place of the distance",
        .bound = at_most(1.1 * cell * cell / 8.0 / (0.5 - 0.5 * cell),
                         "cell²/8 of the bend of a distance along an edge, at most 1 / (r − "
                         "cell/2); 10 % for higher orders"),
        .measure =
            [=] {
                return error(WeightedAverageField<Dim>{1.0, 0.5});
            },
        .sabotaged =
            [=] {
                return error(BlobbyField<Dim>{1.0, 0.5});
            }};
})};

/// The distance from the nearest particle: balls, each for itself.
template <int Dim> struct Balls {
    double radius;
    double reach() const { return 2.0 * radius; }
    double far() const { return radius; }
    double value(const Vec<Dim>& x, std::span<const Vec<Dim>> points,
                 std::span<const Index> near) const {
        double nearest = reach();
        for (const Index j : near) nearest = std::min(nearest, (x - points[j]).norm());
        return nearest - radius;
    }
};
/// Highest less lowest point of the surface above a block [spacings].
template <int Dim, class Field> double bumps(const Field& field) {
    const Level found = level_above_block<Dim>([&](auto) { return field; }, 0.25);
    return found.high - found.low;
}
const Register flat{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "weighted_average_field.flat_surface",
        .source = {Paper::literature, "Zhu and Bridson 2005"},
        .says =
            "above the particles of a block the surface is flat: highest less lowest point "
            "[spacings]; not that of balls of the same radius, each for itself",
        .bound = at_most(0.1,
                         "half of what balls of radius 0.75 have in the plane, 0.75 − √(0.75² − "
                         "0.5²) = 0.19"),
        .measure =
            [] {
                return bumps<Dim>(WeightedAverageField<Dim>{3.0, 0.75});
            },
        .sabotaged = [] { return bumps<Dim>(Balls<Dim>{0.75}); }};
})};
}  // namespace
}  // namespace weighted_average_field_claims
