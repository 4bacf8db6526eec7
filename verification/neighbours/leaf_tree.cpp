#include "solver/neighbours/leaf_tree.h"

#include "verification/framework/registry.h"
#include "verification/neighbours/packed_claims.h"

namespace leaf_tree_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Wrong pairs for trees with leaves of 1, 3, 50 and 5000 points.
double wrong_for_other_leaves(double radius_factor) {
    return over_clouds<double, 2>(500, [&](const auto& cloud, const auto& points) {
        BruteForce<2> oracle;
        oracle.build(points, cloud.radius);
        const auto expected = oracle.query(points);
        std::size_t wrong = 0;
        for (const Index leaf_size : {1u, 3u, 50u, 5000u}) {
            LeafTree<2> tree({}, leaf_size);
            tree.build(points, cloud.radius * radius_factor);
            PackedLists lists;
            tree.pack(lists);
            wrong += wrong_pairs(ascending(lists), expected);
        }
        return wrong;
    });
}

template <class Real, int Dim> Claim packed_claim(const std::string& precision, double wider) {
    using Tree = LeafTree<Dim, OpenSpace<Dim>, Real>;
    return {
        .id = "leaf_tree." + precision + "_packed_equal_brute_force_" + std::to_string(Dim) + "d",
        .source = {Paper::plumbline, "docstring of LeafTree"},
        .says = "0 pairs missing, 0 spurious in the lists as found, in " + precision +
                " precision, against brute force in that precision, on all hard clouds",
        .bound = decided_alike(),
        .measure = [] { return wrong_packed<Tree, Real, Dim>(1.0); },
        .sabotaged = [wider] { return wrong_packed<Tree, Real, Dim>(wider); }};
}

const Register claims_of_leaf_tree{
    packed_claim<double, 3>("double", 1.0 + 0x1p-52),
    packed_claim<float, 3>("single", 1.0 + 0x1p-22),
    Claim{.id = "leaf_tree.pairs_once",
          .source = {Paper::plumbline, "docstring of GroupedSearch::pack_pairs"},
          .says = "half lists hold each pair of two different points once",
          .bound = decided_alike(),
          .measure = [] { return wrong_halves<LeafTree<2>>(OpenSpace<2>{}, false); },
          .sabotaged = [] { return wrong_halves<LeafTree<2>>(OpenSpace<2>{}, true); }},
    Claim{.id = "leaf_tree.lists_do_not_depend_on_leaves",
          .source = {Paper::adams2009, "Alg. 2"},
          .says = "leaves of 1, 3, 50 and 5000 points give the lists of brute force on every cloud",
          .bound = at_most(0.0, "a box is discarded only if its computed gap reaches the radius"),
          .measure = [] { return wrong_for_other_leaves(1.0); },
          .sabotaged = [] { return wrong_for_other_leaves(1.0 + 0x1p-52); }},
    Claim{.id = "leaf_tree.adapts_to_the_density",
          .source = {Paper::adams2009, "Sec. 5.3"},
          .says =
              "with radii that follow a density graded 1 : 1000, a tree computes hardly more "
              "distances per neighbour than at even density; a grid of one spacing, that of the "
              "largest radius, many more",
          .bound =
              at_most(1.3,
                      "the tree is the same up to a stretch of space; 30 % for radii that differ "
                      "within a leaf, whose largest decides, and for stretched boxes"),
          .measure = [] { return distances_over_those_at_even_density<LeafTree<3>>(); },
          .sabotaged = [] { return distances_over_those_at_even_density<CellGrid<3>>(); }},
};
}  // namespace
}  // namespace leaf_tree_claims
