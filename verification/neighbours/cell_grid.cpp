#include "solver/neighbours/cell_grid.h"

#include "verification/framework/registry.h"
#include "verification/neighbours/clouds.h"
#include "verification/neighbours/searches.h"

namespace cell_grid_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The lists of all points; or what comes of them if each thread appends its share of the rows as it
/// ends, the last one first.
template <class Search>
NeighbourLists lists_of(Search& search, const Points<2>& points, bool appended) {
    search.build(points, search.radius());
    if (!appended) return search.query(points);
    const std::size_t n = points.size(), threads = static_cast<std::size_t>(thread_count());
    NeighbourLists all{{0}, {}};
    for (std::size_t k = threads; k > 0; --k) {
        const std::size_t first = n * (k - 1) / threads, last = n * k / threads;
        const auto share = search.query(std::span(points).subspan(first, last - first));
        for (Index i = 0; i < share.size(); ++i) {
            all.indices.insert(all.indices.end(), share.of(i).begin(), share.of(i).end());
            all.offsets.push_back(all.indices.size());
        }
    }
    return all;
}

/// Clouds whose lists differ between one thread and three, over all searches.
double clouds_that_depend_on_threads(bool appended) {
    const int threads = thread_count();
    double different = 0.0;
    for (const auto& cloud : hard_clouds<2>(3000))
        for_each_search<2>([&](auto search) {
            set_thread_count(1);
            search.build(cloud.points, cloud.radius);
            const auto alone = lists_of(search, cloud.points, appended);
            set_thread_count(3);
            different += lists_of(search, cloud.points, appended) == alone ? 0.0 : 1.0;
        });
    set_thread_count(threads);
    return different;
}

/// Wrong pairs where the same points are queried in another order, so that they have to be sorted.
double wrong_in_another_order(bool forget_the_order) {
    double wrong = 0.0;
    for (const auto& cloud : hard_clouds<3>(1500)) {
        Points<3> reversed(cloud.points.rbegin(), cloud.points.rend());
        BruteForce<3> oracle;
        CellGrid<3> grid;
        oracle.build(cloud.points, cloud.radius);
        grid.build(cloud.points, cloud.radius);
        wrong += static_cast<double>(wrong_pairs(
            grid.query(forget_the_order ? cloud.points : reversed), oracle.query(reversed)));
    }
    return wrong;
}

/// The most bytes per point that the grid holds, over all clouds, however sparse.
double most_bytes_per_point() {
    double most = 0.0;
    for (const auto& cloud : hard_clouds<3>(3000)) {
        CellGrid<3> grid;
        grid.build(cloud.points, cloud.radius);
        most = std::max(
            most, static_cast<double>(grid.memory()) / static_cast<double>(cloud.points.size()));
    }
    return most;
}
double bytes_per_point_of_an_array_over_the_box() { return 4.0 * std::pow(2e9, 3) / 3000.0; }

const Register claims_of_cell_grid{
    Claim{.id = "cell_grid.lists_do_not_depend_on_threads",
          .source = {Paper::plumbline, "docstring of parallel_for"},
          .says = "every search gives the same lists with 1 and with 3 threads, on every cloud",
          .bound = at_most(0.0, "each thread writes rows of its own"),
          .measure = [] { return clouds_that_depend_on_threads(false); },
          .sabotaged = [] { return clouds_that_depend_on_threads(true); }},
    Claim{.id = "cell_grid.queries_in_any_order",
          .source = {Paper::plumbline, "docstring of CellGrid"},
          .says = "queries that are not the points as built are sorted, with the rows as given",
          .bound = at_most(0.0, "lists are equal, not similar"),
          .measure = [] { return wrong_in_another_order(false); },
          .sabotaged = [] { return wrong_in_another_order(true); }},
    Claim{.id = "cell_grid.memory_is_free_of_empty_cells",
          .source = {Paper::adams2009, "Sec. 5.2"},
          .says = "at most 88 bytes per point, counted by capacity, however sparse the points",
          .bound = at_most(
              89.0,
              "28 for a point (3 coordinates and its number); twice 8 for its cell and 12 "
              "for its row if it is alone in both, since arrays grow by doubling; 4 for its "
              "key and 16 to count 4 cells, where they are counted; ends of arrays"),
          .measure = most_bytes_per_point,
          .sabotaged = bytes_per_point_of_an_array_over_the_box},
};
}  // namespace
}  // namespace cell_grid_claims
