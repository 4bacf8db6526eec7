#include "solver/approximation/neighbourhood.h"

#include "solver/kernels/spiky.h"

#include <catch2/catch.hpp>

namespace neighbourhood_test {
namespace {
using namespace plumbline;

const Points<2> x{{0.1, 0.5}, {0.9, 0.5}, {0.4, 0.5}};
const NeighbourLists everybody{{0, 3, 6, 9}, {0, 1, 2, 0, 1, 2, 0, 1, 2}};

TEST_CASE("a neighbourhood sums over the neighbours of a particle, itself included") {
    const Neighbourhood<2> near{everybody, OpenSpace<2>{}};
    CHECK(near.sum<double>(x, 0, [](const auto&) { return 1.0; }) == 3.0);
    CHECK(near.sum<double>(x, 0, [](const auto& n) { return n.r; }) == Approx(0.8 + 0.3));
    const auto towards = [](const auto& n) -> Vec<2> { return n.x; };
    CHECK(near.sum<Vec<2>>(x, 0, towards).x() == Approx(-0.8 - 0.3));
}

TEST_CASE("in a periodic box the nearest images count") {
    const Neighbourhood<2, PeriodicBox<2>> near{everybody, PeriodicBox<2>({0, 0}, {1, 1})};
    const auto towards = [](const auto& n) -> Vec<2> { return n.x; };
    CHECK(near.sum<Vec<2>>(x, 0, towards).x() == Approx(0.2 - 0.3));
}

TEST_CASE("neighbours may be of another set") {
    const Neighbourhood<2> near{{{0, 1}, {0}}, OpenSpace<2>{}};
    const Points<2> others{{0.1, 0.9}};
    CHECK(near.sum<double>(x, 0, others, [](const auto& n) { return n.x.y(); }) == Approx(-0.4));
}

TEST_CASE("the gradient of a neighbour is that of the kernel, and 0 where both coincide") {
    const Spiky<2> w(1.0);
    const Vec<2> d(0.3, -0.4);
    CHECK(gradient(w, Neighbour<2>{0, d, d.norm()}) == gradient(w, d));
    CHECK(gradient(w, Neighbour<2>{0, Vec<2>::Zero(), 0.0}) == Vec<2>::Zero());
}
}  // namespace
}  // namespace neighbourhood_test
