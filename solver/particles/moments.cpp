#include "solver/particles/moments.h"

#include <Eigen/Geometry>

#include <numbers>

namespace plumbline {

namespace {
Moments<3> of_mesh(const TriangleMesh& mesh) {
    Moments<3> all{0.0, Vec<3>::Zero(), Mat<3>::Zero()};
    for (const auto& t : mesh.triangles) {
        const Vec<3>&a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec<3> s = a + b + c;
        const double volume = a.dot(b.cross(c)) / 6.0;
        all.volume += volume;
        all.centre += volume / 4.0 * s;
        all.second +=
            volume / 20.0 *
            (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
    all.centre /= all.volume;
    all.second -= all.volume * all.centre * all.centre.transpose();
    return all;
}

template <int Dim> struct MomentsOf {
    Moments<Dim> operator()(const HalfSpace<Dim>&) const {
        throw InvalidInput("moments: expected a shape that ends somewhere, found a half-space");
    }
    Moments<Dim> operator()(const Cuboid<Dim>& box) const {
        const Vec<Dim> edges = box.high - box.low;
        const double volume = edges.prod();
        return {volume, 0.5 * (box.low + box.high),
                volume / 12.0 * Mat<Dim>(edges.cwiseAbs2().asDiagonal())};
    }
    Moments<Dim> operator()(const Ball<Dim>& ball) const {
        const double r = ball.radius, pi = std::numbers::pi;
        const double volume = Dim == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r;
        return {volume, ball.centre, volume * r * r / (Dim + 2.0) * Mat<Dim>::Identity()};
    }
    Moments<3> operator()(const MeshSolid& solid) const {
        // From a corner of its box: far from the origin the sums would cancel.
        TriangleMesh mesh = solid.mesh->triangles();
        const Vec<3> low = solid.mesh->bounds().low;
        for (Vec<3>& x : mesh.vertices) x -= low;
        Moments<3> all = of_mesh(mesh);
        all.centre += low;
        return all;
    }
};
template <int Dim> struct Move {
    Vec<Dim> by;
    Shape<Dim> operator()(HalfSpace<Dim> s) const {
        s.point += by;
        return s;
    }
    Shape<Dim> operator()(Cuboid<Dim> s) const {
        s.low += by, s.high += by;
        return s;
    }
    Shape<Dim> operator()(Ball<Dim> s) const {
        s.centre += by;
        return s;
    }
    Shape<3> operator()(const MeshSolid& s) const {
        TriangleMesh mesh = s.mesh->triangles();
        for (Vec<3>& x : mesh.vertices) x += by;
        return MeshSolid{std::make_shared<const ClosedMesh>(mesh)};
    }
};
}  // namespace

template <int Dim> Moments<Dim> moments_of(const Shape<Dim>& shape) {
    return std::visit(MomentsOf<Dim>{}, shape);
}
template <int Dim> Shape<Dim> moved(const Shape<Dim>& shape, const Vec<Dim>& by) {
    return std::visit(Move<Dim>{by}, shape);
}

template Moments<2> moments_of<2>(const Shape<2>&);
template Moments<3> moments_of<3>(const Shape<3>&);
template Shape<2> moved<2>(const Shape<2>&, const Vec<2>&);
template Shape<3> moved<3>(const Shape<3>&, const Vec<3>&);

}  // namespace plumbline
