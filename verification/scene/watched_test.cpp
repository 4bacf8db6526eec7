#include "solver/scene/watched.h"

#include "solver/fluid/gravity.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"

#include <catch2/catch.hpp>

namespace watched_test {
namespace {
using namespace plumbline;

struct SpoilDensity {
    using Reads = Quantities<>;
    using Writes = Quantities<Density>;
    void run(double, Density& rho) const { rho[1] = NAN; }
};
using Push = Watched<2, Gravity<2>>;
using Spoil = Watched<2, SpoilDensity>;

TEST_CASE("an armed watch names the strongest term and the first number that is not finite") {
    Watch<2> watch;
    Scene scene{Given<Positions<2>, Velocities<2>, Density>{},
                Push{"weak", &watch, {{0, -1}}},
                Push{"strong", &watch, {{0, -9}}},
                Spoil{"bad", &watch, {}},
                Spoil{"worse", &watch, {}},
                Watched<2, SymplecticEuler<2>>{"time step", &watch, {}}};
    scene.get<Positions<2>>().assign(2, Vec<2>::Zero());
    scene.get<Velocities<2>>().assign(2, Vec<2>::Zero());
    scene.get<Density>().assign(2, 1.0);
    scene.step(0.1);
    CHECK_FALSE(watch.first_fault.has_value());
    watch = {.armed = true, .particle = 1};
    scene.step(0.1);
    REQUIRE(watch.first_fault.has_value());
    CHECK(watch.first_fault->term == "bad");
    CHECK(watch.first_fault->quantity == "density");
    CHECK(watch.first_fault->particle == 1);
    CHECK(watch.strongest_term == "strong");
    CHECK(watch.strongest == Approx(9.0));
}
}  // namespace
}  // namespace watched_test
