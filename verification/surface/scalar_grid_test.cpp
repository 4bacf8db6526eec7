#include "solver/surface/scalar_grid.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace scalar_grid_test {
namespace {
using namespace plumbline;

template <int Dim> ScalarGrid<Dim> around(const Points<Dim>& x, double margin, double spacing) {
    return grid_around<Dim>(std::span<const Vec<Dim>>(x), margin, spacing);
}

TEST_CASE("a grid covers the points and their margin, with nodes at multiples of its spacing") {
    const auto grid = around<2>({{0.31, -1.0}, {0.9, 0.0}}, 0.2, 0.25);
    CHECK(grid.origin == Vec<2>(0.0, -1.25));
    CHECK(grid.size == std::array<std::size_t, 2>{6, 7});
    CHECK(grid.position(grid.nodes() - 1) == Vec<2>(1.25, 0.25));
    CHECK(grid.place(7) == std::array<std::size_t, 2>{1, 1});
    CHECK(grid.stride(1) == 6);
}

TEST_CASE("no grid around nothing, around infinity, or of too many nodes") {
    CHECK_THROWS_AS(around<3>({}, 0.1, 0.1), InvalidInput);
    CHECK_THROWS_AS(around<3>({{0, NAN, 0}}, 0.1, 0.1), InvalidInput);
    CHECK_THROWS_AS(around<3>({{0, 0, 0}, {1, 1, 1}}, 0.1, 0.0), InvalidInput);
    CHECK_THROWS_WITH((around<3>({{0, 0, 0}, {1, 1, 1}}, 0.1, 1e-4)),
                      Catch::Contains("at most 2^32 nodes"));
}
}  // namespace
}  // namespace scalar_grid_test
