#include "solver/neighbours/hash_grid.h"

#include "solver/foundation/sum.h"
#include "solver/kernels/poly6.h"
#include "solver/particles/jittered.h"
#include "verification/framework/oracle.h"
#include "verification/framework/registry.h"
#include "verification/neighbours/clouds.h"
#include "verification/neighbours/searches.h"
#include "verification/neighbours/under_test.h"

#include <set>

namespace hash_grid_claims {
namespace {
using namespace plumbline;
using namespace verification;

// Erratum 16: which cells are visited.

template <int Dim> Cloud<Dim> even_cloud(Index n, double neighbours, double edge = 1.0) {
    const Box<Dim> box{Vec<Dim>::Zero(), Vec<Dim>::Constant(edge)};
    return {"even", uniform_random(box, n, 5),
            radius_for<Dim>(neighbours, n / std::pow(edge, Dim))};
}

/// Neighbours that `search` misses / all, of the queries farther than the radius from the faces.
template <int Dim, class Search>
double loss(Search search, const Cloud<Dim>& cloud, bool count_the_query_itself = false) {
    CellGrid<Dim> oracle;
    oracle.build(cloud.points, cloud.radius);
    search.build(cloud.points, cloud.radius);
    Points<Dim> inner;
    for (const Vec<Dim>& x : cloud.points)
        if ((x.array() - 0.5).abs().maxCoeff() < 0.5 - cloud.radius) inner.push_back(x);
    const auto all = oracle.query(inner), found = search.query(inner);
    const auto expected = all.indices.size() - (count_the_query_itself ? 0 : inner.size());
    return static_cast<double>(all.indices.size() - found.indices.size()) /
           static_cast<double>(expected);
}

/// The mean over the ball of the product of the shares kept along each axis: of the neighbours at the
/// distance s r along an axis all are kept up to s = 1/2, then 3/2 − s of them, as the far cell border
/// is at (1/2 .. 1) r from the query, and half of the neighbours are on its side.
double kept_share(int dim, double squared_radius_left) {
    if (dim == 0) return 1.0;
    const double most = std::sqrt(squared_radius_left);
    return 2.0 * integrate(
                     [&](double s) {
                         const double kept = s <= 0.5 ? 1.0 : 1.5 - s;
                         return kept *
                                kept_share(dim - 1, std::max(0.0, squared_radius_left - s * s));
                     },
                     0.0, most, most > 0.5 ? std::vector{0.5} : std::vector<double>{});
}
template <int Dim> double loss_in_theory() {
    constexpr double pi = 3.14159265358979323846;
    return 1.0 - kept_share(Dim, 1.0) / (Dim == 1 ? 2.0 : Dim == 2 ? pi : 4.0 / 3.0 * pi);
}

template <int Dim> double deviation_from_theory(bool count_the_query_itself) {
    const auto cloud = even_cloud<Dim>(25000, 7.0);
    return std::abs(loss(PrintedHashGrid<Dim>(1.0), cloud, count_the_query_itself) -
                    loss_in_theory<Dim>());
}
template <int Dim> double lost_at_spacing(HashSpacing spacing) {
    const auto cloud = even_cloud<Dim>(5000, 20.0);
    return spacing == HashSpacing::diameter ? loss(HashGridUnderTest<Dim>(), cloud)
                                            : loss(HashGrid<Dim, HashSpacing::radius>(), cloud);
}

// Algorithm 5 builds with d = h and queries by Algorithm 4.

const Cloud<3> fluid{"jittered lattice", jittered(unit_box<3>(), 0.05, 0.2, 6), 0.125};

/// max over the particles of (ρ − ρ found) / ρ.
template <class Search> double density_missing(Search search) {
    const Poly6<3> w(fluid.radius);
    const auto density = [&](const NeighbourLists& lists, Index i) {
        return sum<double>(lists.of(i), [&](Index j) {
            return w.value((fluid.points[i] - fluid.points[j]).norm());
        });
    };
    BruteForce<3> oracle;
    oracle.build(fluid.points, fluid.radius);
    search.build(fluid.points, fluid.radius);
    const auto all = oracle.query(fluid.points), found = search.query(fluid.points);
    double worst = 0.0;
    for (Index i = 0; i < all.size(); ++i)
        worst = std::max(worst, 1.0 - density(found, i) / density(all, i));
    return worst;
}
/// The share of pairs in which i lists j, but j does not list i.
template <class Search> double one_sided_share(Search search) {
    search.build(fluid.points, fluid.radius);
    const auto lists = search.query(fluid.points);
    std::size_t one_sided = 0;
    for (Index i = 0; i < lists.size(); ++i)
        for (const Index j : lists.of(i))
            if (!std::ranges::binary_search(lists.of(j), i)) ++one_sided;
    return static_cast<double>(one_sided) / static_cast<double>(lists.indices.size());
}

// Erratum 26: the hash.

constexpr int table_size = 4093;

/// The share of the cells within 20 of the origin whose bucket is none of the table's.
template <class Hash> double share_out_of_table(Hash hash_of) {
    const CellRange<3> range{{-20, -20, -20}, {19, 19, 19}};
    int out = 0;
    range.for_each([&](const Cell<3>& cell) {
        const auto bucket = static_cast<std::int64_t>(hash_of(cell));
        if (bucket < 0 || bucket >= table_size) ++out;
    });
    return out / range.count();
}

// Buckets.

const Cloud<3> small = even_cloud<3>(3000, 20.0);
constexpr double points_per_bucket = 30.0;

double points_listed_twice() {
    HashGrid<3> grid(OpenSpace<3>{}, points_per_bucket);
    grid.build(small.points, small.radius);
    const auto lists = grid.query(small.points);
    std::size_t twice = 0;
    for (Index i = 0; i < lists.size(); ++i) {
        const auto row = lists.of(i);
        for (std::size_t k = 1; k < row.size(); ++k) twice += row[k] == row[k - 1] ? 1 : 0;
    }
    return static_cast<double>(twice);
}
/// Queries two of whose eight cells fall in one bucket of the same table.
double queries_that_meet_a_bucket_twice() {
    const std::size_t buckets = prime_from(static_cast<std::size_t>(3000 / points_per_bucket));
    const EndlessGrid<3, OpenSpace<3>> grid(OpenSpace<3>{}, 2.0 * small.radius);
    int queries = 0;
    for (const Vec<3>& x : small.points) {
        std::set<std::size_t> met;
        int cells = 0;
        grid.around(x, small.radius).for_each([&](const Cell<3>& cell) {
            met.insert(hash<3>(cell, buckets));
            ++cells;
        });
        queries += static_cast<int>(met.size()) < cells ? 1 : 0;
    }
    return queries;
}

// Cost, in points tested per query.

template <int Dim, HashSpacing Spacing>
double points_tested(const Cloud<Dim>& cloud, std::span<const Vec<Dim>> queries) {
    HashGrid<Dim, Spacing> grid(OpenSpace<Dim>{}, 0.05);
    grid.build(cloud.points, cloud.radius);
    double tested = 0.0;
    for (const Vec<Dim>& x : queries)
        grid.for_each_bucket(x, cloud.radius,
                             [&](Index first, Index last) { tested += last - first; });
    return tested / static_cast<double>(queries.size());
}
template <int Dim> Points<Dim> middle_of(double edge) {
    const Vec<Dim> centre = Vec<Dim>::Constant(0.5 * edge);
    const Box<Dim> box{centre.array() - 0.2 * edge, centre.array() + 0.2 * edge};
    return uniform_random(box, 2000, 7);
}
template <int Dim, HashSpacing Spacing> double tested_over_theory() {
    constexpr double neighbours = 20.0, pi = 3.14159265358979323846;
    const double ball = Dim == 2 ? pi : 4.0 / 3.0 * pi;
    const double cells = std::pow(Spacing == HashSpacing::radius ? 3.0 : 4.0, Dim);
    return points_tested<Dim, Spacing>(even_cloud<Dim>(40000, neighbours), middle_of<Dim>(1.0)) /
           (neighbours * cells / ball);
}
/// Growth of the points tested per query when there are 8 times as many points, at the same radius.
double growth_with_number(bool same_volume) {
    const double few =
        points_tested<3, HashSpacing::diameter>(even_cloud<3>(8000, 20.0, 1.0), middle_of<3>(1.0));
    Cloud<3> more = even_cloud<3>(64000, 20.0, same_volume ? 1.0 : 2.0);
    more.radius = even_cloud<3>(8000, 20.0, 1.0).radius;
    return points_tested<3, HashSpacing::diameter>(more, middle_of<3>(same_volume ? 1.0 : 2.0)) /
           few;
}
/// Memory for two halves of a cloud 1e6 radii apart / memory for the cloud.
double memory_for_empty_cells() {
    Cloud<3> apart = small;
    for (std::size_t i = 0; i < apart.points.size(); i += 2)
        apart.points[i].array() += 1e6 * apart.radius;
    HashGrid<3> near_grid, apart_grid;
    near_grid.build(small.points, small.radius);
    apart_grid.build(apart.points, apart.radius);
    return static_cast<double>(apart_grid.memory()) / static_cast<double>(near_grid.memory());
}
double memory_of_array_over_the_box() { return std::pow(1e6 / 2.0, 3) / 3000.0; }

const std::string theory_of_loss =
    "the theory: a lattice plane of cells is uniform from the query, so along an axis all "
    "neighbours "
    "up to r/2 are visited, then the share 3/2 − s/r: 1/8, 0.159, 0.162 lost in 1D, 2D, 3D. The "
    "losses "
    "of one query depend on each other: at worst a standard error of √(0.16 · 0.84 / 17000) = "
    "0.0028 "
    "for the queries that are left, times 4";

const Register claims_of_hash_grid{
    Erratum{16,
            {Paper::adams2009, "Algs. 4, 5"},
            "spacing d = r (caption of Alg. 4, call in Alg. 5) with the 2^k nearest cells",
            "2^k cells for d ≥ 2r, as the text of Sec. 5.2 says; 3^k cells for d = r"},
    Erratum{
        26,
        {Paper::adams2009, "Eq. 43; Alg. 3"},
        "H = (i p₁ xor j p₂ xor k p₃) mod s of signed cell numbers; Alg. 3: H ← H + pᵢ xᵢ, no mod",
        "the same in unsigned arithmetic, of the cell numbers I[i], and mod s"},
    Erratum{46,
            {Paper::plumbline, "catalogue of formulas, Alg. 4"},
            "with d = r 14 % of the neighbours are lost in the plane, 15 % in space",
            "15.9 % and 16.2 %: the others count the query, which is never lost, among them"},
    &alg_4_with_one_radius,
    &eq_43_in_signed_numbers,
    &alg_3_without_modulus,
    Claim{.id = "hash_grid.loses_no_neighbour_2d",
          .source = {Paper::adams2009, "Alg. 4; Sec. 5.2"},
          .says = "the 4 cells nearest to the query hold all neighbours",
          .bound = at_most(0.0, "the ball of radius r meets at most 2 cells of 2r along each axis"),
          .measure = [] { return lost_at_spacing<2>(HashSpacing::diameter); },
          .sabotaged = [] { return loss(PrintedHashGrid<2>(1.0), even_cloud<2>(5000, 20.0)); },
          .erratum = 16},
    Claim{.id = "hash_grid.loses_no_neighbour_3d",
          .source = {Paper::adams2009, "Alg. 4; Sec. 5.2"},
          .says = "the 8 cells nearest to the query hold all neighbours",
          .bound = at_most(0.0, "the ball of radius r meets at most 2 cells of 2r along each axis"),
          .measure = [] { return lost_at_spacing<3>(HashSpacing::diameter); },
          .sabotaged = [] { return loss(PrintedHashGrid<3>(1.0), even_cloud<3>(5000, 20.0)); },
          .erratum = 16},
    Claim{.id = "hash_grid_r.loses_no_neighbour_3d",
          .source = {Paper::adams2009, "Sec. 5.2"},
          .says = "with d = r the 27 cells around the query hold all neighbours",
          .bound = at_most(0.0, "the ball of radius r meets at most 3 cells of r along each axis"),
          .measure = [] { return lost_at_spacing<3>(HashSpacing::radius); },
          .sabotaged = [] { return loss(PrintedHashGrid<3>(1.0), even_cloud<3>(5000, 20.0)); },
          .erratum = 16},
    Claim{
        .id = "hash_grid.loss_of_the_printed_spacing_2d",
        .source = {Paper::adams2009, "Alg. 4"},
        .says = "Algorithm 4 with d = r loses 15.9 % of the neighbours other than the query itself",
        .bound = at_most(0.0112, theory_of_loss),
        .measure = [] { return deviation_from_theory<2>(false); },
        .sabotaged = [] { return deviation_from_theory<2>(true); },
        .erratum = 46},
    Claim{
        .id = "hash_grid.loss_of_the_printed_spacing_3d",
        .source = {Paper::adams2009, "Alg. 4"},
        .says = "Algorithm 4 with d = r loses 16.2 % of the neighbours other than the query itself",
        .bound = at_most(0.0112, theory_of_loss),
        .measure = [] { return deviation_from_theory<3>(false); },
        .sabotaged = [] { return deviation_from_theory<3>(true); },
        .erratum = 46},
    Claim{.id = "hash_grid.density_of_algorithm_5",
          .source = {Paper::adams2009, "Alg. 5"},
          .says = "the density of a fluid (poly6, h = 2.5 spacings) misses no neighbour's share",
          .bound = at_most(0.0, "equal lists give equal sums"),
          .measure = [] { return density_missing(HashGridUnderTest<3>()); },
          .sabotaged = [] { return density_missing(PrintedHashGrid<3>(1.0)); },
          .erratum = 16},
    Claim{.id = "hash_grid.neighbours_are_mutual",
          .source = {Paper::adams2009, "Alg. 5"},
          .says = "j is a neighbour of i iff i is one of j, without which momentum is lost",
          .bound = at_most(0.0, "a − b and b − a differ in sign only, also when rounded"),
          .measure = [] { return one_sided_share(HashGridUnderTest<3>()); },
          .sabotaged = [] { return one_sided_share(PrintedHashGrid<3>(1.0)); },
          .erratum = 16},
    Claim{.id = "hash_grid.hash_is_a_bucket",
          .source = {Paper::adams2009, "Eq. 43"},
          .says = "the hash of each cell, also at negative coordinates, is one of the s buckets",
          .bound = at_most(0.0, "a remainder of unsigned numbers is in [0, s)"),
          .measure =
              [] {
                  return share_out_of_table(
                      [](const Cell<3>& c) { return bucket_under_test<3>(c, table_size); });
              },
          .sabotaged =
              [] {
                  return share_out_of_table(
                      [](const Cell<3>& c) { return printed_hash<3>(c, table_size); });
              },
          .erratum = 26},
    Claim{.id = "hash_grid.sum_is_a_bucket_only_with_a_modulus",
          .source = {Paper::adams2009, "Alg. 3"},
          .says = "the sum of Algorithm 3 is a bucket once it is taken mod s",
          .bound = at_most(0.0, "a remainder of unsigned numbers is in [0, s)"),
          .measure =
              [] {
                  return share_out_of_table(
                      [](const Cell<3>& c) { return printed_sum<3>(c) % table_size; });
              },
          .sabotaged = [] { return share_out_of_table(printed_sum<3>); },
          .erratum = 26},
    Claim{
        .id = "hash_grid.no_point_twice",
        .source = {Paper::adams2009, "Alg. 4"},
        .says = "two cells of a query that share a bucket do not list a point twice (101 buckets)",
        .bound = at_most(0.0, "each bucket is searched once"),
        .measure = points_listed_twice,
        .sabotaged = queries_that_meet_a_bucket_twice},
    Claim{.id = "hash_grid.points_tested_2d",
          .source = {Paper::adams2009, "Sec. 5.2"},
          .says = "d = 2r tests 16/π points for each neighbour",
          .bound = between(0.97, 1.03,
                           "4 cells of 2r hold 16 r² ρ points, the disc π r² ρ; over 6400 "
                           "points in the middle, 4 standard errors are 4/√6400 = 0.05 "
                           "for the sum of all, 0.03 as queries overlap 20 times"),
          .measure = tested_over_theory<2, HashSpacing::diameter>,
          .sabotaged = [] { return tested_over_theory<2, HashSpacing::radius>() * 9.0 / 16.0; }},
    Claim{.id = "hash_grid.points_tested_3d",
          .source = {Paper::adams2009, "Sec. 5.2"},
          .says = "d = 2r tests 48/π points for each neighbour",
          .bound = between(0.9, 1.1,
                           "8 cells of 2r hold 64 r³ ρ points, the ball 4/3 π r³ ρ; 2560 "
                           "points in the middle: 4/√2560 = 0.08"),
          .measure = tested_over_theory<3, HashSpacing::diameter>,
          .sabotaged = [] { return tested_over_theory<3, HashSpacing::radius>() * 27.0 / 64.0; }},
    Claim{.id = "hash_grid_r.points_tested_3d",
          .source = {Paper::adams2009, "Sec. 5.2"},
          .says = "d = r tests 81/(4π) points for each neighbour, 27/64 of those of d = 2r",
          .bound = between(0.9, 1.1, "27 cells of r hold 27 r³ ρ points, the ball 4/3 π r³ ρ"),
          .measure = tested_over_theory<3, HashSpacing::radius>,
          .sabotaged = [] { return tested_over_theory<3, HashSpacing::diameter>() * 64.0 / 27.0; }},
    Claim{.id = "hash_grid.retrieval_is_constant",
          .source = {Paper::adams2009, "Sec. 5.3"},
          .says = "at constant density a query tests as many points among 64000 as among 8000",
          .bound = between(0.85, 1.15, "512 and 4096 points in the two middles: 3/√512 = 0.13"),
          .measure = [] { return growth_with_number(false); },
          .sabotaged = [] { return growth_with_number(true); }},
    Claim{.id = "hash_grid.memory_is_free_of_empty_cells",
          .source = {Paper::adams2009, "Sec. 5.2"},
          .says = "two halves of a cloud take as much memory 1e6 radii apart as together",
          .bound = at_most(1.0, "points and table of s ≈ n buckets are all that is stored"),
          .measure = memory_for_empty_cells,
          .sabotaged = memory_of_array_over_the_box},
};
}  // namespace
}  // namespace hash_grid_claims
