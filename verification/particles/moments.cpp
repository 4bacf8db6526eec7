#include "solver/particles/moments.h"

#include "solver/particles/lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace moments_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The box from (1, 2, 3) with edges 1, 0.5, 0.8, and the same of 12 triangles.
template <int Dim> Shape<Dim> box() {
    const Vec<3> low(1.0, 2.0, 3.0), edges(1.0, 0.5, 0.8);
    return Cuboid<Dim>{low.head<Dim>(), (low + edges).head<Dim>()};
}
Shape<3> box_of_triangles() {
    const auto& like = std::get<Cuboid<3>>(box<3>());
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k) {
        Vec<3> x;
        for (int d = 0; d < 3; ++d) x[d] = (k >> d & 1) != 0 ? like.high[d] : like.low[d];
        mesh.vertices.push_back(x);
    }
    for (const auto& [a, b, c, d] : {std::array<Index, 4>{0, 1, 3, 2},
                                     {4, 5, 7, 6},
                                     {0, 1, 5, 4},
                                     {2, 3, 7, 6},
                                     {0, 2, 6, 4},
                                     {1, 3, 7, 5}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return MeshSolid{std::make_shared<const ClosedMesh>(mesh)};
}
/// The largest difference of volume, centre and second moments, each over its size for a shape 1 wide.
template <int Dim> double difference(const Moments<Dim>& one, const Moments<Dim>& other) {
    return std::max({std::abs(one.volume - other.volume), (one.centre - other.centre).norm(),
                     (one.second - other.second).norm()});
}
/// By the midpoint rule on a lattice of 1/64.
template <int Dim> Moments<Dim> by_lattice(const Shape<Dim>& shape, bool about_centre) {
    Moments<Dim> sum{0.0, Vec<Dim>::Zero(), Mat<Dim>::Zero()};
    const double d = 1.0 / 64.0;
    for (const Vec<Dim>& x : lattice<Dim>({Vec<Dim>::Zero(), Vec<Dim>::Constant(4.0)}, d)) {
        if (from_surface<Dim>(shape, x).distance > 0.0) continue;
        sum.volume += std::pow(d, Dim);
        sum.centre += std::pow(d, Dim) * x;
        sum.second += std::pow(d, Dim) * x * x.transpose();
    }
    sum.centre /= sum.volume;
    if (about_centre) sum.second -= sum.volume * sum.centre * sum.centre.transpose();
    return sum;
}
template <int Dim> double error_against_lattice(bool about_centre) {
    const Shape<Dim> ball = Ball<Dim>{Vec<Dim>::Constant(2.0), 1.0};
    return std::max(
        difference<Dim>(moments_of<Dim>(ball), by_lattice<Dim>(ball, about_centre)),
        difference<Dim>(moments_of<Dim>(box<Dim>()), by_lattice<Dim>(box<Dim>(), about_centre)));
}

const Register against_lattice{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "moments.against_a_lattice",
        .source = {Paper::plumbline, "docstring of Moments"},
        .says =
            "volume, centre and second moments of a ball and a box against sums over a "
            "lattice of 1/64; wrong: the second moments about the origin",
        .bound = at_most(0.1,
                         "a surface below 13 in a layer of half a cell, 1/128, on one side "
                         "in the worst case"),
        .measure = [] { return error_against_lattice<Dim>(true); },
        .sabotaged = [] { return error_against_lattice<Dim>(false); }};
})};
const Register of_meshes{Claim{
    .id = "moments.mesh_of_a_box",
    .source = {Paper::plumbline, "docstring of moments_of"},
    .says = "moments of a box of 12 triangles against those of the box; wrong: one moved by 1e-6",
    .bound = at_most(1e-14,
                     "12 terms of numbers up to 4, rounded some ten times by 2e-16, of "
                     "which volumes have 1/6"),
    .measure =
        [] { return difference<3>(moments_of<3>(box_of_triangles()), moments_of<3>(box<3>())); },
    .sabotaged =
        [] {
            const Shape<3> other = moved<3>(box_of_triangles(), Vec<3>::Constant(1e-6));
            return difference<3>(moments_of<3>(other), moments_of<3>(box<3>()));
        }}};
}  // namespace
}  // namespace moments_claims
