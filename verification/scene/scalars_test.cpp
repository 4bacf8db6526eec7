#include "solver/scene/scalars.h"

#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace scalars_test {
namespace {
using namespace plumbline;
using namespace verification;

const SceneFile file = SceneFile::parse("s.toml", dam_break_scene(2, "sph", 1.0));

struct TwoParticles {
    std::vector<double> x{0.0, 0.1, 0.2, 0.3}, v{3, 4, 0, 1}, m{2, 1}, rho{1000, 1000}, p{50, 70};
    Snapshot snapshot() const { return {2, x, v, m, rho, p, {}}; }
};

TEST_CASE("scalars of two particles, by hand") {
    const TwoParticles two;
    const Scalars all = scalars_of(file, two.snapshot());
    CHECK(all.kinetic == Approx(0.5 * 2 * 25 + 0.5 * 1));
    CHECK(all.potential == Approx(9.81 * (2 * 0.1 + 1 * 0.3)));
    CHECK(all.internal == Approx(0.0).margin(1e-12));
    CHECK(all.momentum.isApprox(Vec<3>(6, 9, 0)));
    CHECK(all.angular_momentum.isApprox(Vec<3>(0, 0, 2 * (0.0 * 4 - 0.1 * 3) + 0.2)));
    CHECK(all.centre.isApprox(Vec<3>(0.2 / 3, 0.5 / 3, 0)));
    CHECK(all.front == 0.2);
    CHECK(all.height == 0.3);
    CHECK(all.largest_speed == 5.0);
}

TEST_CASE("probes average over the particles around, and are 0 in air") {
    const TwoParticles two;
    const auto read = [&](Probe::Quantity quantity, double x, double y) {
        return reading({quantity, "", Vec<3>(x, y, 0)}, file, two.snapshot());
    };
    CHECK(read(Probe::Quantity::pressure, 0.01, 0.1) == Approx(50.0));
    CHECK(read(Probe::Quantity::speed, 0.2, 0.31) == Approx(1.0));
    CHECK(read(Probe::Quantity::density, 0.2, 0.31) == Approx(1000.0));
    CHECK(read(Probe::Quantity::pressure, 5.0, 5.0) == 0.0);
    CHECK(read(Probe::Quantity::height, 0.19, 0.0) == 0.3);
    CHECK(std::isnan(read(Probe::Quantity::height, 0.1, 0.0)));
}
}  // namespace
}  // namespace scalars_test
