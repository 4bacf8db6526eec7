#include "solver/fluid/dfsph.h"

#include "solver/fluid/sph_density.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/brute_force.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"

#include <catch2/catch.hpp>

namespace dfsph_test {
namespace {
using namespace plumbline;

using W = WendlandC2<2>;
using Search = BruteForce<2>;

/// Particles of mass 1, far nearer to each other than the rest density of 0.5 allows.
auto pressed_together(const std::vector<Vec<2>>& x, ProjectionLimits limits) {
    Scene scene{Given<Positions<2>, Velocities<2>, Masses>{},
                Given<GhostPositions<2>, GhostVelocities<2>, GhostMasses>{},
                FindNeighbours<2, Search>{2.0},
                FindGhosts<2, Search>{2.0},
                SphDensity<W>{W(2.0)},
                CollectGradients<W>{W(2.0)},
                Kick<2>{},
                ConstantDensity<2>{0.5, limits},
                Drift<2>{}};
    scene.get<Positions<2>>().assign(x.begin(), x.end());
    scene.get<Velocities<2>>().assign(x.size(), Vec<2>::Zero());
    scene.get<Masses>().assign(x.size(), 1.0);
    return scene;
}
const std::vector<Vec<2>> three = {{0.0, 0.0}, {0.5, 0.0}, {0.2, 0.4}};

TEST_CASE("a solve that does not converge says so, and the next one that does") {
    auto scene = pressed_together(three, {.tolerance = 1e-9, .most = 1});
    scene.step(0.1);
    const auto& report = scene.get<DensityReport>();
    CHECK(!report.converged);
    CHECK(report.iterations == 1);
    CHECK(report.failures == 1);
    CHECK(report.error > 1e-9);

    auto patient = pressed_together(three, {.tolerance = 1e-9, .most = 1000});
    patient.step(0.1);
    CHECK(patient.get<DensityReport>().converged);
    CHECK(patient.get<DensityReport>().error <= 1e-9);
    CHECK(patient.get<DensityReport>().failures == 0);
}

TEST_CASE("a step of no time solves nothing") {
    auto scene = pressed_together(three, {.tolerance = 1e-9});
    scene.step(0.0);
    CHECK(scene.get<DensityReport>().solves == 0);
    CHECK(scene.get<Velocities<2>>() == std::vector<Vec<2>>(3, Vec<2>::Zero()));
}

TEST_CASE("a particle alone, two in one place and none at all are no trouble") {
    auto alone = pressed_together({{0.0, 0.0}}, {.tolerance = 1e-4, .most = 5});
    alone.step(0.1);
    CHECK(alone.get<Velocities<2>>()[0] == Vec<2>::Zero());
    CHECK(!alone.get<DensityReport>().converged);  // it is too dense, and nothing can push it

    auto twice = pressed_together({{0.0, 0.0}, {0.0, 0.0}}, {.tolerance = 1e-4, .most = 5});
    twice.step(0.1);
    CHECK(twice.get<Velocities<2>>()[1] == Vec<2>::Zero());

    auto nothing = pressed_together({}, {.tolerance = 1e-4});
    nothing.step(0.1);
    CHECK(nothing.get<DensityReport>().converged);
}

TEST_CASE("not a number is a failure, not a success") {
    auto scene = pressed_together(three, {.tolerance = 1e-4, .most = 5});
    scene.get<Velocities<2>>()[0][0] = NAN;
    scene.step(0.1);
    CHECK(!scene.get<DensityReport>().converged);
    CHECK(scene.get<DensityReport>().failures == 1);
}

/// Factors that promise too much, as with most of their second sum left out.
struct SpoilFactors {
    using Reads = Quantities<>;
    using Writes = Quantities<PairGradients<double, 2>>;
    void run(double, PairGradients<double, 2>& pairs) const {
        for (double& alpha : pairs.factors) alpha *= 16.0;
    }
};

TEST_CASE("a solve that goes too far finds how far it may go") {
    Scene scene{Given<Positions<2>, Velocities<2>, Masses>{},
                Given<GhostPositions<2>, GhostVelocities<2>, GhostMasses>{},
                FindNeighbours<2, Search>{2.0},
                FindGhosts<2, Search>{2.0},
                SphDensity<W>{W(2.0)},
                CollectGradients<W>{W(2.0)},
                SpoilFactors{},
                ConstantDensity<2>{0.5, {.tolerance = 1e-9, .most = 1000}}};
    scene.get<Positions<2>>().assign(three.begin(), three.end());
    scene.get<Velocities<2>>().assign(three.size(), Vec<2>::Zero());
    scene.get<Masses>().assign(three.size(), 1.0);
    scene.step(0.1);
    CHECK(scene.get<DensityReport>().converged);
    CHECK(scene.get<DensityStep>().length < 1.0 / 16.0);
}

TEST_CASE("a warm start takes fewer iterations") {
    std::vector<Vec<2>> block;
    for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b) block.push_back({0.97 * a, 0.97 * b + 0.1 * (a % 2)});
    int cold = 0, warm = 0;
    for (const bool start : {false, true}) {
        auto scene = pressed_together(block, {.tolerance = 1e-5, .warm_start = start});
        for (int n = 0; n < 2; ++n) {
            // The same state twice: what was found for it is what is wanted.
            auto& x = scene.get<Positions<2>>();
            x.assign(block.begin(), block.end());
            scene.get<Velocities<2>>().assign(block.size(), Vec<2>::Zero());
            scene.step(0.1);
        }
        (start ? warm : cold) = scene.get<DensityReport>().iterations;
    }
    CHECK(warm < cold);
}
}  // namespace
}  // namespace dfsph_test
