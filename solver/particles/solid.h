#pragma once

#include "solver/particles/box.h"
#include "solver/particles/closed_mesh.h"

#include <concepts>
#include <memory>
#include <variant>

namespace plumbline {

/// A solid as its signed distance φ: < 0 inside, and ∇φ, of length 1, outwards. Where several points of the
/// surface are nearest, ∇φ is that of one of them.
template <class S, int Dim>
concept SignedDistance = requires(const S& solid, const Vec<Dim>& x) {
    { solid.from_surface(x) } -> std::same_as<FromSurface<Dim>>;
};

/// All that lies behind a plane: φ = ⟨n, x − point⟩; n has the length 1.
template <int Dim> struct HalfSpace {
    Vec<Dim> point;  // [m]
    Vec<Dim> n;

    FromSurface<Dim> from_surface(const Vec<Dim>& x) const { return {n.dot(x - point), n}; }
};

/// What lies between two corners, edges along the axes. φ = ‖max(q, 0)‖ outside and max q inside, with
/// q = |x − centre| − half of the edges, by component.
template <int Dim> struct Cuboid {
    Vec<Dim> low, high;  // [m]

    FromSurface<Dim> from_surface(const Vec<Dim>& x) const {
        const Vec<Dim> from_centre = x - 0.5 * (low + high);
        const Vec<Dim> q = from_centre.cwiseAbs() - 0.5 * (high - low);
        const auto side = [&](int d) { return from_centre[d] < 0.0 ? -1.0 : 1.0; };
        int last = 0;
        const double most = q.maxCoeff(&last);
        if (most <= 0.0) return {most, side(last) * Vec<Dim>::Unit(last)};
        Vec<Dim> out = q.cwiseMax(0.0);
        const double distance = out.norm();
        for (int d = 0; d < Dim; ++d) out[d] *= side(d) / distance;
        return {distance, out};
    }
};

/// A ball, in the plane a disc: φ = ‖x − centre‖ − radius.
template <int Dim> struct Ball {
    Vec<Dim> centre;  // [m]
    double radius;    // [m]

    FromSurface<Dim> from_surface(const Vec<Dim>& x) const {
        const Vec<Dim> arm = x - centre;
        const double r = arm.norm();
        return {r - radius, r > 0.0 ? Vec<Dim>(arm / r) : Vec<Dim>::Unit(0)};
    }
};

/// What a closed surface of triangles bounds. Copies share the mesh.
struct MeshSolid {
    std::shared_ptr<const ClosedMesh> mesh;

    FromSurface<3> from_surface(const Vec<3>& x) const { return mesh->from_surface(x); }
};

namespace detail {
template <int Dim> struct Shapes {
    using type = std::variant<HalfSpace<Dim>, Cuboid<Dim>, Ball<Dim>>;
};
template <> struct Shapes<3> {
    using type = std::variant<HalfSpace<3>, Cuboid<3>, Ball<3>, MeshSolid>;
};
}  // namespace detail
/// One of the shapes, chosen at run time; meshes are for space only.
template <int Dim> using Shape = typename detail::Shapes<Dim>::type;

template <int Dim> FromSurface<Dim> from_surface(const Shape<Dim>& shape, const Vec<Dim>& x) {
    return std::visit([&](const auto& s) { return s.from_surface(x); }, shape);
}

/// All that is not in `solid`, which becomes a hole.
template <class S> struct Cavity {
    S solid;

    template <int Dim>
    requires SignedDistance<S, Dim> FromSurface<Dim> from_surface(const Vec<Dim>& x)
    const {
        const FromSurface<Dim> inside = solid.from_surface(x);
        return {-inside.distance, -inside.normal};
    }
};
template <class S> Cavity(S) -> Cavity<S>;

}  // namespace plumbline
