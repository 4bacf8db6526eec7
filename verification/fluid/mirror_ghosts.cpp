#include "solver/fluid/mirror_ghosts.h"

#include "solver/fluid/ghost_density.h"
#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace mirror_ghosts_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double h = 2.6, speed_of_wall = 0.7;
template <int Dim> using W = WendlandC2<Dim>;

/// A drop before the plane through the origin whose normal is the last axis; what is behind it is left out.
template <int Dim> Drop<Dim> half_of_drop() {
    Drop<Dim> drop;
    Drop<Dim> half = drop;
    half.x.clear(), half.v.clear(), half.m.clear();
    for (std::size_t i = 0; i < drop.x.size(); ++i)
        if (drop.x[i][Dim - 1] > 0.0)
            half.x.push_back(drop.x[i]), half.v.push_back(drop.v[i]), half.m.push_back(drop.m[i]);
    return half;
}
/// The half and its mirror image, both as particles; without slip all velocities turn round against the wall's.
template <int Dim> Drop<Dim> both_halves(bool slip) {
    Drop<Dim> drop = half_of_drop<Dim>();
    const std::size_t n = drop.x.size();
    for (std::size_t i = 0; i < n; ++i) {
        Vec<Dim> x = drop.x[i], v = drop.v[i];
        x[Dim - 1] = -x[Dim - 1];
        const double along = v[0];
        if (slip)
            v[Dim - 1] = -v[Dim - 1];
        else
            v = -v, v[0] = 2.0 * speed_of_wall - along;
        drop.x.push_back(x), drop.v.push_back(v), drop.m.push_back(drop.m[i]);
    }
    return drop;
}
template <int Dim> auto mirrored(bool slip, double offset) {
    MirrorPlane<Dim> plane{offset * Vec<Dim>::Unit(Dim - 1), Vec<Dim>::Unit(Dim - 1)};
    plane.slip = slip;
    plane.velocity = speed_of_wall * Vec<Dim>::Unit(0);
    Scene scene{StartOfDrop<Dim>{},
                MirrorGhosts<Dim>{{plane}, h},
                FindNeighbours<Dim, BruteForce<Dim>>{h},
                FindGhosts<Dim, BruteForce<Dim>>{h},
                SphDensity<W<Dim>>{W<Dim>(h)},
                AddGhostDensity<W<Dim>>{W<Dim>(h)}};
    fill(scene, half_of_drop<Dim>());
    scene.step(0.0);
    return scene;
}
/// Of the densities, and of Σₖ mₖ (vₖ − vᵢ) ω over the other half: the largest difference, over the largest density.
template <int Dim> double difference(bool slip, double offset) {
    const auto mirror = mirrored<Dim>(slip, offset);
    const auto whole = evaluated<Dim>(both_halves<Dim>(slip));
    const auto& rho = mirror.template get<Density>();
    const auto& x = mirror.template get<Positions<Dim>>();
    const auto& v = mirror.template get<Velocities<Dim>>();
    const auto& ghosts = mirror.template get<GhostPositions<Dim>>();
    const Drop<Dim> both = both_halves<Dim>(slip);
    double worst = 0.0, size = 0.0;
    for (std::size_t i = 0; i < rho.size(); ++i) {
        worst = std::max(worst, std::abs(rho[i] - whole.template get<Density>()[i]));
        size = std::max(size, rho[i]);
        Vec<Dim> drag = Vec<Dim>::Zero();
        for (std::size_t k = 0; k < ghosts.size(); ++k)
            drag += mirror.template get<GhostMasses>()[k] *
                    W<Dim>(h).value((x[i] - ghosts[k]).norm()) *
                    (mirror.template get<GhostVelocities<Dim>>()[k] - v[i]);
        for (std::size_t j = rho.size(); j < both.x.size(); ++j)
            drag -= both.m[j] * W<Dim>(h).value((x[i] - both.x[j]).norm()) * (both.v[j] - v[i]);
        worst = std::max(worst, drag.norm());
    }
    return worst / size;
}

constexpr const char* same_terms =
    "the same 20 to 80 terms, distances off by a rounding, in another order: 100 · 1.1e-16, times "
    "3 for "
    "velocities";
const Register with_slip{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "mirror_ghosts.are_the_other_half",
                 .source = {Paper::adams2009, "Sec. 6.3"},
                 .says =
                     "densities, and velocities around particles, at a wall with slip are those "
                     "inside a fluid that is its own mirror image; wrong: a plane 1 % of a spacing "
                     "off",
                 .bound = at_most(4e-14, same_terms),
                 .measure = [] { return difference<D>(true, 0.0); },
                 .sabotaged = [] { return difference<D>(true, 0.01); }};
})};
const Register without_slip{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "mirror_ghosts.stick_to_the_wall",
                 .source = {Paper::literature, "Morris et al. 1997"},
                 .says =
                     "the same at a moving wall without slip, whose velocity is the mean of each "
                     "particle's and its image's",
                 .bound = at_most(4e-14, same_terms),
                 .measure = [] { return difference<D>(false, 0.0); },
                 .sabotaged = [] { return difference<D>(false, 0.01); }};
})};
}  // namespace
}  // namespace mirror_ghosts_claims
