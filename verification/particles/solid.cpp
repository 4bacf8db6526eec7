#include "solver/particles/solid.h"

#include "verification/framework/in_dimensions.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"

#include <functional>

namespace solid_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The cube [−1, 1]³: its corners, and two triangles for each of its sides.
ClosedMesh cube() {
    TriangleMesh mesh;
    for (Index k = 0; k < 8; ++k)
        mesh.vertices.push_back(
            {(k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, (k & 4) != 0 ? 1.0 : -1.0});
    for (const auto& [a, b, c, d] : {std::array<Index, 4>{0, 1, 3, 2},
                                     {4, 5, 7, 6},
                                     {0, 1, 5, 4},
                                     {2, 3, 7, 6},
                                     {0, 2, 6, 4},
                                     {1, 3, 7, 5}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return ClosedMesh(mesh);
}

template <int Dim> using Field = std::function<FromSurface<Dim>(const Vec<Dim>&)>;

/// One of each shape, about as large as 1, and their cavities.
template <int Dim> std::vector<Field<Dim>> solids() {
    const Cuboid<Dim> box{Vec<Dim>::Constant(-1.0), Vec<Dim>::Constant(1.0)};
    const Ball<Dim> ball{Vec<Dim>::Constant(0.1), 0.8};
    const HalfSpace<Dim> below{Vec<Dim>::Constant(0.2), Vec<Dim>::Ones().normalized()};
    std::vector<Field<Dim>> all;
    const auto add = [&](const auto& s) {
        all.push_back([s](const Vec<Dim>& x) { return s.from_surface(x); });
        all.push_back([s](const Vec<Dim>& x) { return Cavity{s}.from_surface(x); });
    };
    add(box), add(ball), add(below);
    if constexpr (Dim == 3) add(MeshSolid{std::make_shared<const ClosedMesh>(cube())});
    return all;
}
/// The box with the normal of a side also where an edge or a corner is nearest.
template <int Dim> std::vector<Field<Dim>> box_of_sides() {
    return {[](const Vec<Dim>& x) -> FromSurface<Dim> {
        int last = 0;
        (x.cwiseAbs() - Vec<Dim>::Ones()).maxCoeff(&last);
        const double distance =
            Cuboid<Dim>{-Vec<Dim>::Ones(), Vec<Dim>::Ones()}.from_surface(x).distance;
        return {distance, std::copysign(1.0, x[last]) * Vec<Dim>::Unit(last)};
    }};
}
/// The box with the largest of the distances along the axes, also outside.
template <int Dim> std::vector<Field<Dim>> box_by_largest() {
    return {[](const Vec<Dim>& x) -> FromSurface<Dim> {
        const auto at = Cuboid<Dim>{-Vec<Dim>::Ones(), Vec<Dim>::Ones()}.from_surface(x);
        return {x.cwiseAbs().maxCoeff() - 1.0, at.normal};
    }};
}

/// A point up to 2 from the origin, at least 0.05 from all edges, surfaces and planes of symmetry of
/// the shapes, where φ bends.
template <int Dim> Vec<Dim> ordinary_point(const Field<Dim>& solid) {
    Vec<Dim> x = point<Dim>(-2.0, 2.0);
    for (int tries = 0; tries < 1000; ++tries) {
        double nearest = std::abs(solid(x).distance);
        for (int d = 0; d < Dim; ++d) {
            nearest = std::min(nearest, std::abs(x[d] - 0.05));
            for (int e = 0; e < d; ++e)
                nearest = std::min(nearest, std::abs(std::abs(x[d]) - std::abs(x[e])));
        }
        if (nearest > 0.05) break;
        x += 0.61803 * Vec<Dim>::Ones();
        for (int d = 0; d < Dim; ++d) x[d] += x[d] > 2.0 ? -4.0 + 0.3 * d : 0.0;
    }
    return x;
}
template <int Dim> double error_of_normals(const std::vector<Field<Dim>>& all) {
    return worst_error(
        [=] {
            double worst = 0.0;
            for (const Field<Dim>& solid : all) {
                const Vec<Dim> x = ordinary_point(solid);
                const double step = 1e-6;
                const Vec<Dim> normal = solid(x).normal;
                for (int d = 0; d < Dim; ++d) {
                    const Vec<Dim> by = step * Vec<Dim>::Unit(d);
                    const double slope =
                        (solid(x + by).distance - solid(x - by).distance) / (2.0 * step);
                    worst = std::max(worst, std::abs(slope - normal[d]));
                }
            }
            return worst;
        },
        {.number = 1000});
}
template <int Dim> double error_of_feet(const std::vector<Field<Dim>>& all) {
    return worst_error([=] {
        double worst = 0.0;
        for (const Field<Dim>& solid : all) {
            const Vec<Dim> x = point<Dim>(-2.0, 2.0);
            const FromSurface<Dim> at = solid(x);
            const Vec<Dim> foot = x - at.distance * at.normal;
            worst = std::max(worst, std::abs(solid(foot).distance));
        }
        return worst;
    });
}
/// Largest difference of the mesh of a cube from the box.
double error_of_cube(bool with_sign) {
    const ClosedMesh mesh = cube();
    return worst_error([&] {
        const Vec<3> x = point<3>(-2.0, 2.0);
        const double expected = Cuboid<3>{-Vec<3>::Ones(), Vec<3>::Ones()}.from_surface(x).distance;
        const double found = mesh.from_surface(x).distance;
        return (with_sign ? found : std::abs(found)) - expected;
    });
}

const Register normals{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "solid.normal_is_the_gradient",
        .source = {Paper::plumbline, "docstring of SignedDistance"},
        .says =
            "differences of φ over 2e-6 against the normal: plane, box, ball, in space a "
            "mesh, and cavities of them; wrong: a box whose corners have the normal of a "
            "side",
        .bound = at_most(2e-5,
                         "φ bends by 1/r, r ≥ 0.05 from corners and the surface, so that the "
                         "slope changes by 1e-6/0.05 within a step; rounding 2e-16/1e-6"),
        .measure = [] { return error_of_normals<Dim>(solids<Dim>()); },
        .sabotaged = [] { return error_of_normals<Dim>(box_of_sides<Dim>()); }};
})};
const Register feet{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "solid.foot_lies_on_the_surface",
                 .source = {Paper::plumbline, "docstring of SignedDistance"},
                 .says =
                     "|φ(x − φ ∇φ)| of the same shapes; wrong: the largest distance along an axis "
                     "for that from a corner",
                 .bound = at_most(1e-14,
                                  "numbers up to 4, each rounded by 4e-16 in some ten operations, "
                                  "twice"),
                 .measure = [] { return error_of_feet<Dim>(solids<Dim>()); },
                 .sabotaged = [] { return error_of_feet<Dim>(box_by_largest<Dim>()); }};
})};
const Register meshes{
    Claim{.id = "solid.mesh_of_a_cube_is_a_box",
          .source = {Paper::plumbline, "docstring of ClosedMesh::from_surface"},
          .says = "φ of a cube of 12 triangles against that of a box; wrong: without the sign",
          .bound = at_most(1e-14, "coordinates up to 2, rounded in some ten operations each"),
          .measure = [] { return error_of_cube(true); },
          .sabotaged = [] { return error_of_cube(false); }}};
}  // namespace
}  // namespace solid_claims
