#include "solver/neighbours/cell_order.h"

#include "verification/neighbours/clouds.h"

#include <catch2/catch.hpp>

#include <set>

namespace cell_order_test {

using namespace plumbline;

TEMPLATE_TEST_CASE_SIG("cell order: every point once, in the cell it lies in, cells ascending", "",
                       ((int Dim), Dim), 1, 2, 3) {
    for (const auto& cloud : verification::hard_clouds<Dim>(2000)) {
        INFO(cloud.name);
        const auto frame = CellFrame<Dim>::around(cloud.points, cloud.radius);
        CellOrder<Dim> order;
        order.sort(frame, cloud.points);
        REQUIRE(order.size() == cloud.points.size());
        std::set<Index> seen;
        bool right_cell = true, rows_ascend = true, columns_ascend = true, given_order = true;
        for (std::size_t r = 0; r < order.rows(); ++r) {
            rows_ascend &= r == 0 || order.row(r - 1) < order.row(r);
            for (Index c = order.first_cell(r); c < order.first_cell(r + 1); ++c) {
                columns_ascend &= c == order.first_cell(r) || order.column(c - 1) < order.column(c);
                for (Index k = order.first_point(c); k < order.first_point(c + 1); ++k) {
                    const auto cell = frame.cell(cloud.points[order.order(k)]);
                    right_cell &= frame.row(cell) == order.row(r) && cell[0] == order.column(c) &&
                                  order.position(k) == cloud.points[order.order(k)];
                    given_order &= k == order.first_point(c) || order.order(k - 1) < order.order(k);
                    seen.insert(order.order(k));
                }
            }
        }
        CHECK(right_cell);
        CHECK(rows_ascend);
        CHECK(columns_ascend);
        CHECK(given_order);
        CHECK(seen.size() == cloud.points.size());
        CHECK(order.holds(cloud.points));
    }
}

TEST_CASE("cell order: other points, or in another order, are not held") {
    Points<2> points = uniform_random(unit_box<2>(), 50, 1);
    CellOrder<2> order;
    order.sort(CellFrame<2>::around(points, 0.1), points);
    std::swap(points[3], points[40]);
    CHECK_FALSE(order.holds(points));
    std::swap(points[3], points[40]);
    CHECK(order.holds(points));
    points.pop_back();
    CHECK_FALSE(order.holds(points));
}

}  // namespace cell_order_test
