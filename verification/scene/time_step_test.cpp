#include "solver/scene/time_step.h"

#include <catch2/catch.hpp>

namespace time_step_test {
namespace {
using namespace plumbline;

TEST_CASE("nothing limits a step at first") {
    const TimeStepLimits limits;
    CHECK(limits.smallest() == HUGE_VAL);
}

TEST_CASE("sound at the largest density and the largest speed limit a step") {
    Velocities<2> v;
    v.assign({{3, 4}, {0, 1}});
    Density rho;
    rho.assign({1.0, 1.1});
    TimeStepLimits limits;
    AcousticLimit<2>{TaitEquation(1.0, 10.0, 7.0), 0.2}.run(0.0, v, rho, limits);
    CHECK(limits.acoustic == Approx(0.4 * 0.2 / (10.0 * std::pow(1.1, 3) + 5.0)));
    CHECK(limits.binding() == "acoustic");
}

TEST_CASE("viscosity and forces limit a step") {
    TimeStepLimits limits;
    ViscousLimit{0.5, 0.2}.run(0.0, limits);
    CHECK(limits.viscous == Approx(0.04 * 0.04 / 0.5));
    CHECK(limits.binding() == "viscous");
    Accelerations<2> a;
    a.assign({{0, 1e6}, {0, 0}});
    ForceLimit<2>{0.2}.run(0.0, a, limits);
    CHECK(limits.force == Approx(0.25 * std::sqrt(0.2e-6)));
    CHECK(limits.binding() == "force");
}

TEST_CASE("no acceleration, no limit") {
    TimeStepLimits limits;
    Accelerations<2> a;
    a.assign(2, Vec<2>::Zero());
    ForceLimit<2>{0.2}.run(0.0, a, limits);
    CHECK(limits.force == HUGE_VAL);
}
}  // namespace
}  // namespace time_step_test
