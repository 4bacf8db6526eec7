#include "solver/surface/isosurface.h"

#include "solver/particles/closed_mesh.h"
#include "solver/surface/particle_field.h"
#include "solver/surface/weighted_average_field.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace isosurface_test {
namespace {
using namespace plumbline;

template <int Dim> ScalarGrid<Dim> cube(std::size_t n) {
    ScalarGrid<Dim> grid{Vec<Dim>::Zero(), 1.0, {}};
    grid.size.fill(n);
    grid.values.assign(grid.nodes(), 1.0);
    return grid;
}

TEST_CASE("CGAL finds the surface of a sphere closed, and measures the same volume") {
    const Points<3> x{{0.3, 0.2, 0.1}};
    const auto s = isosurface(
        on_grid<3>(WeightedAverageField<3>{1.0, 0.5}, std::span<const Vec<3>>(x), 0.07), 0.0);
    const ClosedMesh mesh({s.vertices, s.facets});
    CHECK(mesh.volume() == Approx(volume(s)).epsilon(1e-12));
    CHECK(mesh.contains(x[0]));
    CHECK_FALSE(mesh.contains({0.3, 0.2, 0.65}));
}

TEST_CASE("one node inside makes a surface of 2 dim facets, half a spacing from it") {
    auto grid = cube<2>(3);
    grid.values[4] = -1.0;
    const auto s = isosurface(grid, 0.0);
    CHECK(s.vertices.size() == 4);
    CHECK(area(s) == Approx(4.0 * std::sqrt(0.5)));
    CHECK(volume(s) == Approx(0.5));
    auto grid3 = cube<3>(3);
    grid3.values[13] = -1.0;
    const auto s3 = isosurface(grid3, 0.0);
    CHECK(s3.vertices.size() == 6);
    CHECK(s3.facets.size() == 8);
    CHECK(volume(s3) == Approx(1.0 / 6.0));
}

TEST_CASE("no surface where nothing is inside, or everything") {
    CHECK(isosurface(cube<3>(4), 0.0).facets.empty());
    CHECK(isosurface(cube<3>(4), 2.0).facets.empty());
}

TEST_CASE("values that are not finite are outside") {
    auto grid = cube<2>(3);
    grid.values.assign(9, NAN);
    grid.values[0] = INFINITY;
    grid.values[4] = -1.0;
    const auto s = isosurface(grid, 0.0);
    CHECK(volume(s) == Approx(0.5));
    for (const Vec<2>& n : s.normals) CHECK(n == Vec<2>::Zero());
}

TEST_CASE("a field without a value for each node, or without cells, is refused") {
    auto grid = cube<3>(3);
    grid.values.pop_back();
    CHECK_THROWS_WITH(isosurface(grid, 0.0), Catch::Contains("expected 27 values"));
    CHECK_THROWS_WITH(isosurface(cube<2>(1), 0.0), Catch::Contains("at least 2 nodes"));
}
}  // namespace
}  // namespace isosurface_test
