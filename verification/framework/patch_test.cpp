#include "verification/framework/patch.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace patch_test {

using namespace verification;
using plumbline::Vec;

namespace {
template <int Dim> std::size_t neighbours_of_centre(const Lattice<Dim>& lattice, double support) {
    const Patch<Dim> patch(lattice, {.support = support});
    return patch.neighbours.of(patch.centre).size() - 1;  // itself
}
}  // namespace

TEST_CASE("lattices have the coordination numbers of the textbooks") {
    CHECK(neighbours_of_centre(cubic_lattice<1>(0.5), 0.51) == 2);
    CHECK(neighbours_of_centre(cubic_lattice<2>(0.5), 0.51) == 4);
    CHECK(neighbours_of_centre(hexagonal_lattice(0.5), 0.51) == 6);
    CHECK(neighbours_of_centre(cubic_lattice<3>(0.5), 0.51) == 6);
    CHECK(neighbours_of_centre(body_centred_lattice(0.5), 0.51) == 8);
    CHECK(neighbours_of_centre(close_packed_lattice(0.5), 0.51) == 12);
}

TEST_CASE("a patch holds the lattice points of its ball, the centre at the origin") {
    const Patch<2> patch(cubic_lattice<2>(1.0), {.support = 2.5});
    CHECK(patch.x.size() == 81);  // Gauss's circle problem: N(5) = 81
    CHECK(patch.x[patch.centre].norm() == 0.0);
    CHECK(patch.V[0] == 1.0);
}

TEST_CASE("free faces cut the last axes, and keep the centre") {
    for (const int faces : {1, 2, 3}) {
        const Patch<3> patch(cubic_lattice<3>(1.0), {.support = 2.0, .free_faces = faces});
        CHECK(patch.x[patch.centre].norm() == 0.0);
        const auto outside = [&](const Vec<3>& x) {
            return x[2] < 0.0 || (faces > 1 && x[1] < 0.0) || (faces > 2 && x[0] < 0.0);
        };
        CHECK(std::ranges::none_of(patch.x, outside));
        CHECK(std::ranges::any_of(patch.x, [](const Vec<3>& x) { return x[2] > 1.0; }));
    }
}

TEST_CASE("jitter stays below its size, and its seed makes it") {
    const PatchShape shape{.support = 2.0, .jitter = 0.2};
    const Patch<2> lattice(cubic_lattice<2>(1.0), {.support = 2.0});
    const Patch<2> once(cubic_lattice<2>(1.0), shape), again(cubic_lattice<2>(1.0), shape);
    PatchShape other_seed = shape;
    other_seed.seed = 2;
    const Patch<2> other(cubic_lattice<2>(1.0), other_seed);
    double largest = 0.0;
    for (std::size_t i = 0; i < once.x.size(); ++i)
        largest = std::max(largest, (once.x[i] - lattice.x[i]).cwiseAbs().maxCoeff());
    CHECK(largest <= 0.2);
    CHECK(largest > 0.1);
    CHECK(once.x == again.x);
    CHECK(once.x != other.x);
}

}  // namespace patch_test
