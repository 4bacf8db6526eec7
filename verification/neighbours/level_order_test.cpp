#include "solver/neighbours/level_order.h"

#include "verification/neighbours/clouds.h"

#include <catch2/catch.hpp>

#include <set>

namespace level_order_test {

using namespace plumbline;

TEMPLATE_TEST_CASE_SIG(
    "level order: every point once, in a cell that is not crowded, under crowded ones", "",
    ((int Dim), Dim), 1, 2, 3) {
    for (const auto& cloud : verification::hard_clouds<Dim>(1000)) {
        if (cloud.name == "all but a few coincident") continue;  // no width parts those
        INFO(cloud.name);
        LevelOrder<Dim, OpenSpace<Dim>, double> order;
        order.sort({}, cloud.points, cloud.radius);
        CHECK(order.size() == cloud.points.size());
        CHECK(order.holds(cloud.points));
        std::set<Index> seen;
        bool same = true, small = true, crowded_before = true;
        std::size_t blocks = 0;
        for (std::size_t l = 0; l < order.levels(); ++l) {
            const auto& level = order.level(l);
            CHECK(level.first == seen.size());
            CHECK(level.first_block == blocks);
            blocks += level.points.blocks();
            for (std::size_t b = level.first_block; b < blocks; ++b)
                CHECK(order.level_of_block(b) == l);
            for (std::size_t c = 0; c < level.points.cells(); ++c)
                small &= level.points.first_point(c + 1) - level.points.first_point(c) <=
                         order.most_points;
            for (std::size_t k = 0; k < level.points.size(); ++k) {
                const Vec<Dim>& x = cloud.points[level.points.order(k)];
                same &= order.order(level.first + k) == level.points.order(k) &&
                        level.points.position(k) == x;
                seen.insert(level.points.order(k));
                for (std::size_t before = 0; before < l; ++before) {
                    const auto& frame = order.level(before).frame;
                    const auto& heads = order.level(before).crowded;
                    bool found = false;
                    for (std::size_t h = 0; h < heads.size(); ++h)
                        found |= frame.cell(heads.position(h)) == frame.cell(x);
                    crowded_before &= found;
                }
            }
        }
        CHECK(order.blocks() == blocks);
        CHECK(same);
        CHECK(small);
        CHECK(crowded_before);
        CHECK(seen.size() == cloud.points.size());
    }
}

TEST_CASE("level order: coincident points end in one level, none at all in no level") {
    LevelOrder<2, OpenSpace<2>, double> order;
    order.sort({}, Points<2>(500, Vec<2>(3, 4)), 0.1);
    CHECK(order.size() == 500);
    CHECK(order.levels() == 1);
    order.sort({}, {}, 0.1);
    CHECK(order.size() == 0);
    CHECK(order.blocks() == 0);
}

}  // namespace level_order_test
