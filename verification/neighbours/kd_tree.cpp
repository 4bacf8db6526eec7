#include "solver/neighbours/kd_tree.h"

#include "verification/framework/registry.h"
#include "verification/neighbours/clouds.h"
#include "verification/neighbours/searches.h"
#include "verification/neighbours/under_test.h"

namespace kd_tree_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr Index leaf_size = 8;
const Points<3> nine_coincident(9, Vec<3>(0.1, 0.2, 0.3));
/// 512 points, but two values only along each axis.
Points<3> on_corners_of_a_cube() {
    Points<3> points = uniform_random(unit_box<3>(), 512, 1);
    for (Vec<3>& x : points) x = x.array().round();
    return points;
}

template <int Dim> double nodes_of(const Points<Dim>& points, Index largest_leaf = leaf_size) {
    KdTreeUnderTest<Dim> tree({}, largest_leaf);
    tree.build(points, 1.0);
    return static_cast<double>(tree.nodes());
}

/// The worst over all clouds of nodes / (2 ⌈n / (leaf_size / 2)⌉), the most that halving can make.
double nodes_over_most(Index largest_leaf) {
    double worst = 0.0;
    for (const auto& cloud : hard_clouds<3>(3000))
        worst = std::max(worst, nodes_of(cloud.points, largest_leaf) /
                                    (2.0 * std::ceil(static_cast<double>(cloud.points.size()) /
                                                     (leaf_size / 2))));
    return worst;
}

/// Wrong pairs over all clouds for trees of other shapes.
double wrong_for_other_leaves(double radius_factor) {
    double wrong = 0.0;
    for (const auto& cloud : hard_clouds<2>(700)) {
        BruteForce<2> oracle;
        oracle.build(cloud.points, cloud.radius);
        const auto expected = oracle.query(cloud.points);
        for (const Index leaf : {1u, 2u, 50u, 5000u}) {
            KdTreeUnderTest<2> tree({}, leaf);
            tree.build(cloud.points, cloud.radius * radius_factor);
            wrong += static_cast<double>(wrong_pairs(tree.query(cloud.points), expected));
        }
    }
    return wrong;
}

/// Nodes visited by a query for a ball that holds no point, but the one at its centre.
double nodes_visited(Index n) {
    const Points<3> points = uniform_random(unit_box<3>(), n, 8);
    KdTreeUnderTest<3> tree({}, leaf_size);
    tree.build(points, 1e-9);
    double visited = 0.0;
    for (Index i = 0; i < 1000; ++i)
        visited +=
            static_cast<double>(tree.for_each_near_leaf(points[i], 1e-18, [](Index, Index) {}));
    return visited / 1000.0;
}

struct Tested {
    double tree, grid;  // points tested for each neighbour found
};

/// Radii that follow the density, as in adaptive SPH: about 30 neighbours everywhere.
Tested tested_at(double contrast) {
    constexpr Index n = 20000;
    const Points<2> points = graded(unit_box<2>(), n, contrast);
    const double growth = std::log(contrast);
    const auto radius = [&](const Vec<2>& x) {
        const double density =
            growth == 0.0 ? n : n * growth / (contrast - 1.0) * std::exp(growth * x[0]);
        return radius_for<2>(30.0, density);
    };
    std::vector<double> radii;
    for (const Vec<2>& x : points) radii.push_back(radius(x));
    KdTree<2> tree;
    HashGrid<2> grid;
    tree.build(points, 1.0);
    grid.build(points, *std::ranges::max_element(radii));
    double neighbours = 0.0;
    Tested tested{0.0, 0.0};
    for (Index i = 0; i < n; i += 7) {
        const double r = radii[i];
        tree.for_each_near_leaf(points[i], r * r,
                                [&](Index first, Index last) { tested.tree += last - first; });
        grid.for_each_bucket(points[i], r,
                             [&](Index first, Index last) { tested.grid += last - first; });
        for (const Vec<2>& x : points)
            neighbours += (x - points[i]).squaredNorm() < r * r ? 1.0 : 0.0;
    }
    return {tested.tree / neighbours, tested.grid / neighbours};
}

const Register claims_of_kd_tree{
    Erratum{
        27,
        {Paper::adams2009, "Alg. 1"},
        "S_l = {x : x[axis] < median}, until |S| ≤ s: does not end where more than s points have "
        "no point strictly below their median on any axis, e.g. coincide",
        "split by rank, n/2 points on either side; points that coincide are one leaf"},
    &alg_1_by_value,
    Claim{.id = "kd_tree.ends_on_coincident_points",
          .source = {Paper::adams2009, "Alg. 1"},
          .says = "nine points that coincide, leaf size 8, are one node",
          .bound = at_most(1.0, "a box without extent cannot be split"),
          .measure = [] { return nodes_of(nine_coincident); },
          .sabotaged = [] { return depth_of_algorithm_1<3>(nine_coincident, leaf_size, 0, 1000); },
          .erratum = 27},
    Claim{
        .id = "kd_tree.depth_with_tied_coordinates",
        .source = {Paper::adams2009, "Alg. 1; Sec. 5.1"},
        .says = "512 points on the 8 corners of a cube are 8 leaves, 15 nodes, or few more",
        .bound = at_most(2.0 * 512 / (leaf_size / 2), "halving ends at leaves of 4 points or more"),
        .measure = [] { return nodes_of(on_corners_of_a_cube()); },
        .sabotaged =
            [] { return depth_of_algorithm_1<3>(on_corners_of_a_cube(), leaf_size, 0, 1000); },
        .erratum = 27},
    Claim{.id = "kd_tree.is_balanced",
          .source = {Paper::adams2009, "Sec. 5.1"},
          .says =
              "a tree has at most 2n / (s/2) nodes on every cloud: log₂ n levels of n points each "
              "to sort, hence O(n log n)",
          .bound = at_most(1.0, "halves differ by one point at most, so a leaf has s/2 or more"),
          .measure = [] { return nodes_over_most(leaf_size); },
          .sabotaged = [] { return nodes_over_most(1); }},
    Claim{.id = "kd_tree.lists_do_not_depend_on_leaves",
          .source = {Paper::adams2009, "Alg. 2"},
          .says = "leaves of 1, 2, 50 and 5000 points give the lists of brute force on every cloud",
          .bound = at_most(0.0, "a box is discarded only if its computed gap reaches the radius"),
          .measure = [] { return wrong_for_other_leaves(1.0); },
          .sabotaged = [] { return wrong_for_other_leaves(1.0 + 0x1p-52); }},
    Claim{
        .id = "kd_tree.query_is_logarithmic",
        .source = {Paper::adams2009, "Alg. 2; Sec. 5.1"},
        .says = "32 times as many points add at most 3 visited nodes for each of the 5 new levels",
        .bound = at_most(15.0,
                         "a ball that meets one child only visits two nodes on each level; one "
                         "more where it meets the other child's box too"),
        .measure = [] { return nodes_visited(64000) - nodes_visited(2000); },
        .sabotaged = [] { return nodes_of(uniform_random(unit_box<3>(), 64000, 8)); }},
    Claim{
        .id = "kd_tree.adapts_to_the_density",
        .source = {Paper::adams2009, "Sec. 5.3"},
        .says =
            "with radii that follow a density graded 1 : 1000, a kd-tree tests no more points per "
            "neighbour than at even density; a hash grid, whose spacing has to be that of the "
            "largest radius, tests many more",
        .bound = at_most(1.3,
                         "the tree is the same up to a stretch of space; 30 % for its boxes, "
                         "which are no longer as wide as long"),
        .measure = [] { return tested_at(1000.0).tree / tested_at(1.0 + 1e-9).tree; },
        .sabotaged = [] { return tested_at(1000.0).grid / tested_at(1.0 + 1e-9).grid; }},
};
}  // namespace
}  // namespace kd_tree_claims
