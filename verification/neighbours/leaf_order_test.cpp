#include "solver/neighbours/leaf_order.h"

#include "verification/neighbours/clouds.h"

#include <catch2/catch.hpp>

#include <set>

using namespace plumbline;

TEMPLATE_TEST_CASE_SIG("leaf order: every point once, in leaves that hold it, none too large", "",
                       ((int Dim), Dim), 1, 2, 3) {
    for (const auto& cloud : verification::hard_clouds<Dim>(1000)) {
        INFO(cloud.name);
        constexpr Index leaf_size = 7;
        LeafOrder<Dim, double> order;
        order.sort(cloud.points, leaf_size);
        std::set<Index> seen;
        Index next = 0;
        bool small = true, inside = true, same = true;
        for (std::size_t l = 0; l < order.leaves(); ++l) {
            const auto& leaf = order.leaf(l);
            CHECK(leaf.first == next);
            next = leaf.last;
            small &= leaf.last - leaf.first <= leaf_size;
            for (Index k = leaf.first; k < leaf.last; ++k) {
                const Vec<Dim>& x = order.position(k);
                inside &=
                    (leaf.low.array() <= x.array()).all() && (x.array() <= leaf.high.array()).all();
                same &= x == cloud.points[order.order(k)] && order.x(Dim - 1)[k] == x[Dim - 1];
                seen.insert(order.order(k));
            }
        }
        CHECK(next == cloud.points.size());
        CHECK(small);
        CHECK(inside);
        CHECK(same);
        CHECK(seen.size() == cloud.points.size());
        CHECK(order.holds(cloud.points));
    }
}
