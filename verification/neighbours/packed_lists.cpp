#include "solver/neighbours/packed_lists.h"

#include "verification/framework/registry.h"
#include "verification/neighbours/packed_claims.h"

namespace packed_lists_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <class Real, int Dim> double wrong_in_box(bool open) {
    const PeriodicBox<Dim> box(Vec<Dim>::Zero(), Vec<Dim>::Ones());
    return over_clouds<Real, Dim>(700, [&](const auto& cloud, auto points) {
        for (auto& x : points) x = box.wrap(x.template cast<double>()).template cast<Real>();
        BruteForce<Dim, PeriodicBox<Dim>, Real> oracle(box);
        oracle.build(points, cloud.radius);
        PackedLists lists;
        if (open)
            pack<OpenSpace<Dim>>({}, points, cloud.radius, lists);
        else
            pack(box, points, cloud.radius, lists);
        return wrong_pairs(ascending(lists), oracle.query(points));
    });
}

/// Counts and rows that differ from those of the lists.
template <class Real> double wrong_without_lists(bool forget_oneself) {
    return over_clouds<Real, 3>(600, [&](const auto& cloud, const auto& points) {
        CellGrid<3, OpenSpace<3>, Real> grid;
        grid.build(points, cloud.radius);
        PackedLists lists;
        grid.pack(lists);
        std::vector<Index> counts;
        grid.count(counts);
        std::vector<char> same(points.size(), 0);
        grid.for_each_row([&](Index i, std::span<const Index> row) {
            same[i] = std::ranges::equal(row, lists.of(i)) &&
                      counts[i] - (forget_oneself ? 1 : 0) == row.size();
        });
        return std::ranges::count(same, 0);
    });
}

/// Wrong pairs for radii from a third to five times that of the grid, all alike and mixed.
double wrong_for_other_radii(bool of_the_grid) {
    return over_clouds<double, 3>(500, [&](const auto& cloud, const auto& points) {
        BruteForce<3> oracle;
        CellGrid<3> grid;
        grid.build(points, cloud.radius);
        std::vector<double> radii(points.size());
        std::size_t wrong = 0;
        const std::vector<double> factors{0.33, 0.99, 1.7, 5.0};
        for (std::size_t i = 0; i < radii.size(); ++i)
            radii[i] = factors[i % factors.size()] * cloud.radius;
        PackedLists lists;
        for (const double factor : factors) {
            const double radius = factor * cloud.radius;
            oracle.build(points, radius);
            grid.pack(of_the_grid ? cloud.radius : radius, lists);
            wrong += wrong_pairs(ascending(lists), oracle.query(points));
        }
        grid.pack(radii, lists);
        return wrong + wrong_pairs(ascending(lists), oracle.query(points, radii));
    });
}

/// Clouds whose rows, in the order as found, differ between one thread and three.
double clouds_that_depend_on_threads(bool shuffled) {
    const int threads = thread_count();
    const double different =
        over_clouds<double, 3>(3000, [&](const auto& cloud, const auto& points) {
            set_thread_count(1);
            PackedLists alone, together;
            pack<OpenSpace<3>>({}, points, cloud.radius, alone);
            auto again = points;
            if (shuffled) std::ranges::reverse(again);
            set_thread_count(3);
            pack<OpenSpace<3>>({}, again, cloud.radius, together);
            for (Index i = 0; i < points.size(); ++i)
                if (!std::ranges::equal(alone.of(i), together.of(i))) return 1;
            return 0;
        });
    set_thread_count(threads);
    return different;
}

/// Bytes of grid and lists over those of positions and bare lists, for 30 neighbours.
template <class Real> double memory_over_least(int searches, bool forget) {
    constexpr Index n = 30000;
    const int threads = thread_count();
    set_thread_count(1);
    const auto points = in_precision<Real, 3>(uniform_random(unit_box<3>(), n, 6));
    CellGrid<3, OpenSpace<3>, Real> grid;
    PackedLists lists;
    std::size_t lists_memory = 0;
    for (int k = 0; k < searches; ++k) {
        PackedLists fresh;
        PackedLists& used = forget ? fresh : lists;
        grid.build(points, radius_for<3>(30.0, n));
        grid.pack(used);
        lists_memory = forget ? lists_memory + used.memory() : used.memory();
    }
    grid.pack(lists);
    set_thread_count(threads);
    const std::size_t least = n * sizeof(points[0]) + lists.pairs() * sizeof(Index);
    return static_cast<double>(lists_memory + grid.memory()) / static_cast<double>(least);
}

template <class Real, int Dim> using Grid = CellGrid<Dim, OpenSpace<Dim>, Real>;
const PeriodicBox<2> box(Vec<2>::Zero(), Vec<2>::Ones());
const Bound none = decided_alike();
const Bound memory_bound = at_most(
    1.5,
    "a point has 12 or 24 bytes of position and 120 of neighbours; beside them 4 for its number, 4 "
    "for its key, 16 for its row, up to 40 / 7 for its share of a cell, and 256 kB / 30000 for the "
    "block that the thread has not filled: 39 / 132 and 39 / 144");

template <class Real> Claim memory_claim(const std::string& precision) {
    return {
        .id = "packed_lists.memory_" + precision,
        .source = {Paper::plumbline, "docstring of PackedLists"},
        .says =
            "grid and lists of one thread take at most 1.5 times positions and bare lists, also "
            "after ten searches, counted by capacity; each other thread adds a block",
        .bound = memory_bound,
        .measure = [] { return memory_over_least<Real>(10, false); },
        .sabotaged = [] { return memory_over_least<Real>(10, true); }};
}
template <class Real, int Dim> Claim packed_claim(const std::string& precision, double wider) {
    return {.id = "packed_lists." + precision + "_equal_brute_force_" + std::to_string(Dim) + "d",
            .source = {Paper::plumbline, "docstring of CellGrid"},
            .says = "0 pairs missing, 0 spurious in the lists as found, in " + precision +
                    " precision, against brute force in that precision, on all hard clouds",
            .bound = none,
            .measure = [] { return wrong_packed<Grid<Real, Dim>, Real, Dim>(1.0); },
            .sabotaged = [wider] { return wrong_packed<Grid<Real, Dim>, Real, Dim>(wider); }};
}
template <class Real, int Dim> Claim periodic_claim(const std::string& precision) {
    return {.id = "packed_lists." + precision + "_periodic_equal_brute_force_" +
                  std::to_string(Dim) + "d",
            .source = {Paper::plumbline, "docstring of PeriodicBox"},
            .says = "the same in a periodic box",
            .bound = none,
            .measure = [] { return wrong_in_box<Real, Dim>(false); },
            .sabotaged = [] { return wrong_in_box<Real, Dim>(true); }};
}

const Register claims_of_packed_lists{
    packed_claim<double, 2>("double", 1.0 + 0x1p-52),
    packed_claim<double, 3>("double", 1.0 + 0x1p-52),
    packed_claim<float, 2>("single", 1.0 + 0x1p-22),
    packed_claim<float, 3>("single", 1.0 + 0x1p-22),
    periodic_claim<double, 3>("double"),
    periodic_claim<float, 2>("single"),
    periodic_claim<float, 3>("single"),
    Claim{.id = "packed_lists.pairs_once",
          .source = {Paper::plumbline, "docstring of CellGrid::pack_pairs"},
          .says = "half lists hold each pair of two different points once: completed by the other "
                  "half and by oneself they are those of brute force",
          .bound = none,
          .measure = [] { return wrong_halves<CellGrid<2>>(OpenSpace<2>{}, false); },
          .sabotaged = [] { return wrong_halves<CellGrid<2>>(OpenSpace<2>{}, true); }},
    Claim{.id = "packed_lists.pairs_once_periodic",
          .source = {Paper::plumbline, "docstring of CellGrid::pack_pairs"},
          .says = "the same in a periodic box",
          .bound = none,
          .measure = [] { return wrong_halves<CellGrid<2, PeriodicBox<2>>>(box, false); },
          .sabotaged = [] { return wrong_halves<CellGrid<2, PeriodicBox<2>>>(box, true); }},
    Claim{.id = "packed_lists.counts_and_rows_without_lists",
          .source = {Paper::plumbline, "docstring of CellGrid"},
          .says = "count and for_each_row give lengths and rows of the lists",
          .bound = none,
          .measure =
              [] { return wrong_without_lists<double>(false) + wrong_without_lists<float>(false); },
          .sabotaged = [] { return wrong_without_lists<double>(true); }},
    Claim{.id = "packed_lists.other_radii_without_a_new_grid",
          .source = {Paper::plumbline, "docstring of CellGrid"},
          .says = "a grid answers for radii from a third to five times its own, alike or mixed",
          .bound = none,
          .measure = [] { return wrong_for_other_radii(false); },
          .sabotaged = [] { return wrong_for_other_radii(true); }},
    Claim{.id = "packed_lists.do_not_depend_on_threads",
          .source = {Paper::plumbline, "docstring of PackedLists"},
          .says = "rows are the same, in the same order, with 1 and with 3 threads",
          .bound = at_most(0.0, "a row is found by one thread, in the order of the cells"),
          .measure = [] { return clouds_that_depend_on_threads(false); },
          .sabotaged = [] { return clouds_that_depend_on_threads(true); }},
    memory_claim<double>("double"),
    memory_claim<float>("single"),
};
}  // namespace
}  // namespace packed_lists_claims
