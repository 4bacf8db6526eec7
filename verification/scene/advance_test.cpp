#include "solver/scene/advance.h"

#include "solver/fluid/gravity.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"

#include <catch2/catch.hpp>

namespace advance_test {
namespace {
using namespace plumbline;

auto falling() {
    Scene scene{Given<Positions<2>, Velocities<2>>{}, Gravity<2>{{0, -10}}, ForceLimit<2>{0.1},
                ViscousLimit{1.0, 0.1}, SymplecticEuler<2>{}};
    scene.get<Positions<2>>().assign(1, Vec<2>::Zero());
    scene.get<Velocities<2>>().assign(1, Vec<2>::Zero());
    return scene;
}

TEST_CASE("fixed steps fill the duration, the last one shorter") {
    auto scene = falling();
    const Advance record = advance_by_fixed_steps(scene, 1.0, 0.3);
    CHECK(record.steps == 4);
    CHECK(record.decided.at("fixed") == 3);
    CHECK(record.decided.at("end") == 1);
    CHECK(scene.get<Velocities<2>>()[0].y() == Approx(-10.0));
    CHECK(advance_by_fixed_steps(scene, 1.0, 0.1).decided ==
          std::map<std::string_view, int>{{"fixed", 10}});
    CHECK(advance_by_fixed_steps(scene, 0.0, 0.1).steps == 0);
}

TEST_CASE("steps follow the smallest limit, and say which that was") {
    auto scene = falling();
    const Advance record = advance_by_limits(scene, 0.0098);
    CHECK(record.decided == std::map<std::string_view, int>{{"viscous", 23}, {"end", 2}});
    CHECK(record.smallest_step == Approx(0.04 * 0.1 * 0.1));
    CHECK(scene.get<Velocities<2>>()[0].y() == Approx(-0.098));
    CHECK(advance_by_limits(scene, 0.01, 1e-4).decided.at("fixed") >= 99);
}

TEST_CASE("bad steps are refused") {
    auto scene = falling();
    CHECK_THROWS_AS(advance_by_fixed_steps(scene, 1.0, 0.0), InvalidInput);
    CHECK_THROWS_AS(advance_by_fixed_steps(scene, -1.0, 0.1), InvalidInput);
    Scene blown_up{Given<Positions<2>, Velocities<2>>{}, ViscousLimit{HUGE_VAL, 0.1},
                   SymplecticEuler<2>{}};
    CHECK_THROWS_WITH(advance_by_limits(blown_up, 1.0), Catch::Contains("viscous"));
}
}  // namespace
}  // namespace advance_test
