#include "solver/surface/isosurface.h"

#include "solver/foundation/random.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"
#include "verification/surface/topology.h"

#include <numbers>

namespace isosurface_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// f at the nodes of a grid of this spacing over [−1.5, 1.5]^Dim, shifted by a random part of a cell.
template <int Dim, class F> ScalarGrid<Dim> sampled(double spacing, std::uint64_t seed, F f) {
    Random random(seed);
    ScalarGrid<Dim> grid{{}, spacing, {}};
    for (int d = 0; d < Dim; ++d) grid.origin[d] = -1.5 - spacing * random.uniform();
    grid.size.fill(static_cast<std::size_t>(std::ceil(3.0 / spacing)) + 2);
    for (std::size_t node = 0; node < grid.nodes(); ++node)
        grid.values.push_back(f(grid.position(node)));
    return grid;
}
/// The unit sphere (circle) as the zero of its distance, r − 1.
template <int Dim> Isosurface<Dim> sphere(double spacing, std::uint64_t seed) {
    return isosurface(sampled<Dim>(spacing, seed, [](const Vec<Dim>& x) { return x.norm() - 1.0; }),
                      0.0);
}
/// The same, but all that the field says is inside or outside: vertices in the middle of their edges.
template <int Dim> Isosurface<Dim> from_signs(double spacing, std::uint64_t seed) {
    return isosurface(
        sampled<Dim>(spacing, seed, [](const Vec<Dim>& x) { return x.norm() < 1.0 ? -1.0 : 1.0; }),
        0.0);
}

struct Errors {
    double largest_radius = 0.0, radius = 0.0, normal = 0.0, area = 0.0, volume = 0.0;
};
template <int Dim> Errors errors_of(const Isosurface<Dim>& s) {
    const double true_area = (Dim == 2 ? 2.0 : 4.0) * std::numbers::pi;
    Errors e;
    for (std::size_t v = 0; v < s.vertices.size(); ++v) {
        const double off = s.vertices[v].norm() - 1.0;
        e.largest_radius = std::max(e.largest_radius, std::abs(off));
        e.radius += off * off / static_cast<double>(s.vertices.size());
        e.normal = std::max(e.normal, (s.normals[v] - s.vertices[v].normalized()).norm());
    }
    e.radius = std::sqrt(e.radius);
    e.area = std::abs(area(s) / true_area - 1.0);
    e.volume = std::abs(volume(s) / (true_area / Dim) - 1.0);
    return e;
}

template <int Dim> Study study_of_sphere() {
    return {
        .id = "isosurface.sphere_" + std::to_string(Dim) + "d",
        .source = {Paper::literature, "Lorensen and Cline 1987"},
        .says =
            "the surface of a unit sphere (circle), given by its distance on a grid, is of order 2 "
            "in all respects; with vertices in the middle of their edges of order 1",
        .quantity = "error of radius [m], normals, area and volume (relative), over the grid [m]",
        .spacing = {0.2, 0.1, 0.05, 0.025, 0.0125},
        .series = {{"radius, rms of the vertices",
                    between(1.9, 2.1, "linear interpolation: t (1 − t) h² f″/2 / |∇f|")},
                   {"normal, largest error",
                    between(1.8, 2.2, "central differences, linear between nodes: both h²")},
                   {"area", between(1.9, 2.1, "facets are chords: h² of the curvature")},
                   {"volume", between(1.9, 2.1, "facets are chords: h² of the curvature")},
                   {"radius, vertices in the middle", between(1.9, 2.1, "off by half a spacing"),
                    false, true}},
        .errors = [](double spacing, std::uint64_t seed) {
            const Errors e = errors_of(sphere<Dim>(spacing, seed));
            return std::vector{e.radius, e.normal, e.area, e.volume,
                               errors_of(from_signs<Dim>(spacing, seed)).radius};
        }};
}
const Register studies{study_of_sphere<2>(), study_of_sphere<3>()};

/// Largest |r − 1| over h²/8, with a grid of h = 0.05.
template <int Dim> double radius_over_limit(const Isosurface<Dim>& s) {
    return errors_of(s).largest_radius / (0.05 * 0.05 / 8.0);
}
const Register radius{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "isosurface.radius_of_sphere",
        .source = {Paper::literature, "Lorensen and Cline 1987"},
        .says =
            "largest error of the radius of a unit sphere, over h²/8; not if vertices are "
            "in the middle of their edges",
        .bound = at_most(1.1 / (1.0 - 0.025),
                         "r along an edge bends by at most (1 − cos²)/r, cos the share of "
                         "the slope, and lies below its chord by h²/8 of that; r ≥ 1 − h/2 "
                         "there; 10 % for higher orders"),
        .measure = [] { return radius_over_limit(sphere<Dim>(0.05, 1)); },
        .sabotaged = [] { return radius_over_limit(from_signs<Dim>(0.05, 1)); }};
})};

template <int Dim> Isosurface<Dim> without_a_facet(Isosurface<Dim> s) {
    s.facets.pop_back();
    return s;
}
const Register sphere_topology{Claim{
    .id = "isosurface.euler_number_of_sphere",
    .source = {Paper::plumbline, "docstring of isosurface"},
    .says = "V − E + F = 2 for a sphere, at 5 places on the grid: largest difference; not if a "
            "facet is lost",
    .bound = at_most(0.0, "whole numbers"),
    .measure =
        [] {
            double worst = 0.0;
            for (std::uint64_t seed = 1; seed <= 5; ++seed)
                worst = std::max(worst, std::abs(euler_number(sphere<3>(0.1, seed)) - 2.0));
            return worst;
        },
    .sabotaged = [] { return std::abs(euler_number(without_a_facet(sphere<3>(0.1, 1))) - 2.0); }}};

/// A ring around the last axis: radius 1 to the middle of a tube of 0.35.
double euler_number_of_ring(double to_middle) {
    return euler_number(isosurface(
        sampled<3>(0.1, 1,
                   [=](const Vec<3>& x) {
                       return std::hypot(std::hypot(x[0], x[1]) - to_middle, x[2]) - 0.35;
                   }),
        0.0));
}
const Register ring_topology{
    Claim{.id = "isosurface.euler_number_of_ring",
          .source = {Paper::plumbline, "docstring of isosurface"},
          .says = "V − E + F = 0 for a ring; 2 if its hole is closed",
          .bound = at_most(0.0, "whole numbers"),
          .measure = [] { return std::abs(euler_number_of_ring(1.0)); },
          .sabotaged = [] { return std::abs(euler_number_of_ring(0.2)); }}};
}  // namespace
}  // namespace isosurface_claims
