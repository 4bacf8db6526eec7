#include "solver/particles/hilbert_order.h"
#include "solver/particles/morton_order.h"

#include <catch2/catch.hpp>

namespace space_filling_order_test {

using namespace plumbline;

TEST_CASE("points of one cell keep their order along a curve") {
    const Points<2> coincident(3, Vec<2>(1.0, 2.0));
    CHECK(morton_order<2>(coincident) == std::vector<Index>{0, 1, 2});
    CHECK(hilbert_order<2>(coincident) == std::vector<Index>{0, 1, 2});
}

TEST_CASE("the Morton curve visits the corners of a square x after y") {
    const Points<2> corners{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    CHECK(morton_order<2>(corners) == std::vector<Index>{0, 2, 1, 3});
}

TEST_CASE("no points have an empty order, and a coordinate that is not finite has none") {
    CHECK(hilbert_order<3>(Points<3>{}).empty());
    const Points<3> bad{{0.0, 0.0, 0.0}, {0.0, std::nan(""), 0.0}};
    CHECK_THROWS_WITH(hilbert_order<3>(bad), Catch::Contains("point 1"));
}

}  // namespace space_filling_order_test
