#include "solver/neighbours/cell_window.h"

#include "solver/particles/uniform_random.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>

namespace cell_window_test {
namespace {
using namespace plumbline;

/// The candidates of every cell with a reach, by looking at every point's cell.
template <bool Wraps> void check_windows(const CellFrame<3>& frame, const Points<3>& points) {
    CellOrder<3> order;
    order.sort(frame, points);
    CellWindow<3, Wraps> window(frame, order);
    Candidates<3> near;
    bool all_right = true;
    for (const std::int64_t reach : {1, 2, 1, 9}) {
        for (std::size_t r = 0; r < order.rows(); ++r)
            for (Index c = order.first_cell(r); c < order.first_cell(r + 1); ++c) {
                window.move_to(order.row(r), order.column(c), order.column(c), reach);
                window.gather(near);
                std::multiset<Index> found(near.id(), near.id() + near.size()), expected;
                const auto home = frame.cell(points[order.order(order.first_point(c))]);
                for (Index i = 0; i < points.size(); ++i) {
                    const auto cell = frame.cell(points[i]);
                    bool within = true;
                    for (int a = 0; a < 3; ++a) {
                        std::int64_t apart = std::abs(std::int64_t{cell[a]} - home[a]);
                        if (Wraps) apart = std::min(apart, frame.cells(a) - apart);
                        within &= apart <= reach;
                    }
                    if (within) expected.insert(i);
                }
                all_right &= found == expected;
                for (std::size_t k = 0; k < near.size(); ++k)
                    all_right &= near.x(1)[k] == points[near.id()[k]][1];
            }
    }
    CHECK(all_right);
}
}  // namespace

TEST_CASE("cell window: the points of the cells within reach, each once") {
    const Points<3> points = uniform_random(unit_box<3>(), 300, 1);
    for (const double radius : {0.02, 0.04, 0.08, 0.12, 0.26, 0.4, 2.0}) {
        INFO(radius);
        check_windows<false>(CellFrame<3>::around(points, radius), points);
    }
}

TEST_CASE("cell window: the same with a table of all cells, of each row, and with none") {
    const Points<3> even = uniform_random(unit_box<3>(), 300, 1);
    Points<3> pairs;  // far apart along each axis, close together in twos
    for (const Vec<3>& x : even) pairs.push_back(x), pairs.push_back(x + Vec<3>(0.003, 0.0, 0.0));
    Points<3> lines;  // few rows of many cells, most of them empty
    for (const Vec<3>& x : even) lines.push_back({x[0], std::round(2.0 * x[1]), 0.0});
    const auto tables = [](const Points<3>& points, double radius) {
        const auto frame = CellFrame<3>::around(points, radius);
        check_windows<false>(frame, points);
        CellOrder<3> order;
        order.sort(frame, points);
        if (order.has_table()) return std::string("all");
        return std::string(order.row_of_cells(0).starts == nullptr ? "none" : "rows");
    };
    CHECK(tables(even, 0.12) == "all");
    CHECK(tables(even, 0.08) == "rows");
    CHECK(tables(lines, 0.0005) == "none");
    CHECK(tables(pairs, 0.002) == "rows");
}

TEST_CASE("cell window: the same through the faces of a periodic box of 1, 2, 3 and more cells") {
    const Points<3> points = uniform_random(unit_box<3>(), 300, 1);
    const PeriodicBox<3> box(Vec<3>::Zero(), Vec<3>::Ones());
    for (const double radius : {0.12, 0.26, 0.34, 0.499999}) {
        INFO(radius);
        check_windows<true>(CellFrame<3>::filling(box, radius), points);
    }
}

}  // namespace cell_window_test
