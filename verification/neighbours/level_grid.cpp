#include "solver/neighbours/level_grid.h"

#include "solver/foundation/random.h"
#include "verification/framework/registry.h"
#include "verification/neighbours/packed_claims.h"

namespace level_grid_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Radii from a hundredth to ten times one of a cloud, even in the logarithm.
std::vector<double> mixed_radii(std::size_t n, double radius) {
    Random random(41);
    std::vector<double> radii(n);
    for (double& r : radii) r = radius * std::pow(10.0, random.uniform(-2.0, 1.0));
    return radii;
}

/// The wrong variant asks with the larger of the radii of both points, as symmetric forces do.
template <class Real, int Dim, class Space>
NeighbourLists by_either_radius(const Space& space, const std::vector<VecOf<Real, Dim>>& points,
                                const std::vector<double>& radii) {
    NeighbourLists lists{{0}, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (Index j = 0; j < points.size(); ++j) {
            const auto r = static_cast<Real>(std::max(radii[i], radii[j]));
            if (squared_distance(space, points[i], points[j]) < r * r) lists.indices.push_back(j);
        }
        lists.offsets.push_back(lists.indices.size());
    }
    return lists;
}

/// Wrong pairs with mixed radii on all clouds.
template <class Real, int Dim, class Space> double wrong_for_mixed_radii(bool either) {
    return over_clouds<Real, Dim>(400, [&](const auto& cloud, auto points) {
        const Space space = [] {
            if constexpr (Space::is_periodic)
                return Space(Vec<Dim>::Zero(), Vec<Dim>::Ones());
            else
                return Space();
        }();
        if constexpr (Space::is_periodic)
            for (auto& x : points) x = space.wrap(x.template cast<double>()).template cast<Real>();
        std::vector<double> radii = mixed_radii(points.size(), cloud.radius);
        if constexpr (Space::is_periodic)
            for (double& r : radii) r = std::min(r, 0.49);
        LevelGrid<Dim, Space, Real> grid(space);
        BruteForce<Dim, Space, Real> oracle(space);
        grid.build(points, cloud.radius);
        oracle.build(points, cloud.radius);
        PackedLists lists;
        grid.pack(radii, lists);
        return wrong_pairs(ascending(lists), either ? by_either_radius(space, points, radii)
                                                    : oracle.query(points, radii));
    });
}
double wrong_in_open_space(bool either) {
    return wrong_for_mixed_radii<double, 3, OpenSpace<3>>(either) +
           wrong_for_mixed_radii<double, 2, OpenSpace<2>>(either);
}

/// Wrong pairs if the grid is built for radii from 1e-4 to 1e4 times those that are asked.
double wrong_for_other_builds(double radius_factor) {
    return over_clouds<double, 3>(400, [&](const auto& cloud, const auto& points) {
        BruteForce<3> oracle;
        oracle.build(points, cloud.radius);
        const auto expected = oracle.query(points);
        std::size_t wrong = 0;
        for (const double factor : {1e-4, 0.3, 1e4}) {
            LevelGrid<3> grid;
            grid.build(points, factor * cloud.radius);
            PackedLists lists;
            grid.pack(cloud.radius * radius_factor, lists);
            wrong += wrong_pairs(ascending(lists), expected);
        }
        return wrong;
    });
}

const Register claims_of_level_grid{
    Claim{.id = "level_grid.mixed_radii_equal_brute_force",
          .source = {Paper::plumbline, "docstring of VariableRadiusSearch"},
          .says =
              "0 pairs missing, 0 spurious for radii mixed 1 : 1000, in 2D and 3D, in double and "
              "single precision, on all hard clouds",
          .bound = decided_alike(),
          .measure = [] { return wrong_in_open_space(false); },
          .sabotaged = [] { return wrong_in_open_space(true); }},
    Claim{
        .id = "level_grid.mixed_radii_equal_brute_force_periodic",
        .source = {Paper::plumbline, "docstring of VariableRadiusSearch"},
        .says = "the same in a periodic box, in single precision, for radii below half of its edge",
        .bound = decided_alike(),
        .measure = [] { return wrong_for_mixed_radii<float, 3, PeriodicBox<3>>(false); },
        .sabotaged = [] { return wrong_for_mixed_radii<float, 3, PeriodicBox<3>>(true); }},
    Claim{.id = "level_grid.lists_do_not_depend_on_the_radius_of_build",
          .source = {Paper::plumbline, "docstring of VariableRadiusSearch"},
          .says = "built for a radius of 1e-4, 0.3 and 1e4 times that asked, lists are the same",
          .bound = decided_alike(),
          .measure = [] { return wrong_for_other_builds(1.0); },
          .sabotaged = [] { return wrong_for_other_builds(1.0 + 0x1p-52); }},
    Claim{.id = "level_grid.pairs_once",
          .source = {Paper::plumbline, "docstring of GroupedSearch::pack_pairs"},
          .says = "half lists hold each pair of two different points once",
          .bound = decided_alike(),
          .measure = [] { return wrong_halves<LevelGrid<2>>(OpenSpace<2>{}, false); },
          .sabotaged = [] { return wrong_halves<LevelGrid<2>>(OpenSpace<2>{}, true); }},
    Claim{
        .id = "level_grid.adapts_to_the_density",
        .source = {Paper::adams2009, "Sec. 5.3"},
        .says =
            "with radii that follow a density graded 1 : 1000, distances computed per neighbour "
            "stay near those at even density; those of a grid of one spacing, that of the "
            "largest radius, do not",
        .bound = at_most(
            2.6,
            "a cell holds a 2^3th to all of 24 points, depending on where widths fall: a group of "
            "24 in a cell of (24 / 7.2)^(1/3) = 1.5 radii has (1.5^3 + 6 1.5^2 + 3 pi 1.5 + 4 pi / "
            "3) / (4 pi / 3) = 8.4 candidates per neighbour within reach of its box, a group of 3 "
            "in "
            "one of 0.75 radii 4.5; so at most 1.9 between the two, and 1.3 as for the tree, for "
            "radii "
            "that differ within a cell: 2.5, and the tree's own margin for stretched boxes is in "
            "it"),
        .measure = [] { return distances_over_those_at_even_density<LevelGrid<3>>(); },
        .sabotaged = [] { return distances_over_those_at_even_density<CellGrid<3>>(); }},
};
}  // namespace
}  // namespace level_grid_claims
