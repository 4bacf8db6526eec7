#include "solver/scene/one_of.h"

#include "solver/fluid/gravity.h"
#include "solver/fluid/tension.h"
#include "solver/scene/scene.h"

#include <catch2/catch.hpp>

namespace one_of_test {
namespace {
using namespace plumbline;

using Pull = OneOf<Skip, Gravity<2>>;
double acceleration_by(Pull pull) {
    Scene scene{Given<Positions<2>>{}, std::move(pull)};
    scene.get<Positions<2>>().assign(1, Vec<2>::Zero());
    scene.step(0.1);
    return scene.get<Accelerations<2>>()[0][1];
}

TEST_CASE("the chosen pass runs, and no other") {
    CHECK(acceleration_by(Gravity<2>{{0, -1}}) == -1.0);
    CHECK(acceleration_by(Skip{}) == 0.0);
}

TEST_CASE("what any of the passes writes is stored, what all of them need is read") {
    STATIC_REQUIRE(std::is_same_v<Pull::Writes, Quantities<Accelerations<2>>>);
    STATIC_REQUIRE(std::is_same_v<OneOf<Skip, ScaleTension>::Writes, Quantities<Pressure>>);
}
}  // namespace
}  // namespace one_of_test
