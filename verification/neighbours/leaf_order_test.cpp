#include "solver/neighbours/leaf_order.h"

#include "solver/foundation/parallel.h"
#include "verification/neighbours/clouds.h"

#include <catch2/catch.hpp>

#include <set>

namespace leaf_order_test {

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

TEST_CASE("leaf order: the same nodes, leaves and order with 1 thread and with 3") {
    const Points<3> points = clustered(unit_box<3>(), 50000, {6, 0.05, 100.0}, 2);
    LeafOrder<3, double> alone, together;
    const int threads = thread_count();
    set_thread_count(1);
    alone.sort(points, 24);
    set_thread_count(3);
    together.sort(points, 24);
    set_thread_count(threads);
    REQUIRE(alone.nodes().size() == together.nodes().size());
    REQUIRE(alone.leaves() == together.leaves());
    bool same = true;
    for (std::size_t n = 0; n < alone.nodes().size(); ++n) {
        const auto &a = alone.nodes()[n], &b = together.nodes()[n];
        same &= a.low == b.low && a.high == b.high && a.first == b.first && a.last == b.last &&
                a.next == b.next && a.leaf == b.leaf;
    }
    for (std::size_t k = 0; k < points.size(); ++k) same &= alone.order(k) == together.order(k);
    CHECK(same);
    Index covered = 0;
    for (std::size_t l = 0; l < alone.leaves(); ++l) {
        same &= alone.leaf(l).first == covered && alone.leaf(l).leaf;
        covered = alone.leaf(l).last;
    }
    CHECK(same);
    CHECK(covered == points.size());
    CHECK(alone.nodes().front().next == alone.nodes().size());
}

}  // namespace leaf_order_test
