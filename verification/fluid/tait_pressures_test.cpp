#include "solver/fluid/tait_pressures.h"

#include <catch2/catch.hpp>

namespace tait_pressures_test {
namespace {
using namespace plumbline;

const TaitEquation water(1000.0, 30.0, 7.0), oil(800.0, 20.0, 1.0);

Pressure pressures(const std::vector<double>& densities, const std::vector<Index>& fluids) {
    Density rho;
    Fluid fluid;
    Pressure p;
    rho.assign(densities.begin(), densities.end());
    fluid.assign(fluids.begin(), fluids.end());
    p.resize(densities.size());
    TaitPressures{{water, oil}}.run(0.0, rho, fluid, p);
    return p;
}
}  // namespace

TEST_CASE("each particle has the pressure of its own fluid") {
    const Pressure p = pressures({1001.0, 801.0, 801.0}, {0, 1, 0});
    CHECK(p[0] == water.pressure(1001.0));
    CHECK(p[1] == oil.pressure(801.0));
    CHECK(p[2] == water.pressure(801.0));
}

TEST_CASE("a fluid that is not there is refused, with the particle") {
    CHECK_THROWS_WITH(pressures({1000.0, 800.0}, {0, 2}),
                      Catch::Contains("below 2, found 2 at particle 1"));
}

}  // namespace tait_pressures_test
