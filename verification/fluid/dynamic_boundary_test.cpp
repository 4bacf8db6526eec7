#include "solver/fluid/dynamic_boundary.h"

#include <catch2/catch.hpp>

namespace dynamic_boundary_test {

using namespace plumbline;

TEST_CASE("walls are held, and their density falls back to that at rest, not below") {
    IsWall wall;
    Density rho;
    Accelerations<2> a;
    Rate<Density> rate;
    wall.assign({0, 1, 1, 1});
    rho.assign({0.9, 0.9, 1.0, 1.1});
    a.assign(4, Vec<2>(1.0, -2.0));
    rate.assign(4, -3.0);
    HoldWalls<2>{1.0}.run(0.1, wall, rho, a, rate);
    CHECK(a[0] == Vec<2>(1.0, -2.0));
    CHECK(rate[0] == -3.0);
    for (const std::size_t k : {1u, 2u, 3u}) CHECK(a[k] == Vec<2>(0.0, 0.0));
    CHECK(rate[1] == 0.0);
    CHECK(rate[2] == 0.0);
    CHECK(rate[3] == -3.0);

    rate.assign(4, 3.0);
    HoldWalls<2>{1.0}.run(0.1, wall, rho, a, rate);
    for (const double r : rate) CHECK(r == 3.0);
}

}  // namespace dynamic_boundary_test
