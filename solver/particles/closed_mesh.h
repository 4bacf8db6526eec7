#pragma once

#include "solver/particles/box.h"

#include <array>
#include <memory>

namespace plumbline {

/// A surface of triangles; each names its three corners.
struct TriangleMesh {
    Points<3> vertices;  // [m]
    std::vector<std::array<Index, 3>> triangles;
};

/// How a point lies to the surface of a solid.
template <int Dim> struct FromSurface {
    double distance;  // from the nearest point of the surface, < 0 inside [m]
    Vec<Dim> normal;  // ∇distance: of length 1, outwards
};

/// A body bounded by triangles, and the question whether a point is in it.
class ClosedMesh {
public:
    /// Throws InvalidInput unless the triangles form surfaces without boundary that do not cut
    /// themselves or one another; for corners beyond the vertices, and vertices that are not
    /// finite. Which way round the triangles are named does not matter.
    explicit ClosedMesh(const TriangleMesh& mesh);
    ~ClosedMesh();
    ClosedMesh(ClosedMesh&&) noexcept;
    ClosedMesh& operator=(ClosedMesh&&) noexcept;

    /// Whether x is inside or on the surface; exact (no rounding decides). Not finite: never.
    bool contains(const Vec<3>& x) const;
    /// The distance from the nearest triangle, < 0 inside, and its gradient; on a triangle, the normal of
    /// that. To rounding; x must be finite. Costs about the logarithm of the number of triangles.
    FromSurface<3> from_surface(const Vec<3>& x) const;
    /// V = Σ a · (b × c) / 6 over the triangles with corners a, b, c [m³].
    double volume() const;
    /// Its triangles, counter-clockwise as seen from outside.
    TriangleMesh triangles() const;
    /// The smallest box with all vertices; they lie on its faces.
    Box<3> bounds() const;

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

/// Those of `points` that the mesh contains, in their order: how any sampling of the box
/// mesh.bounds() becomes one of the body.
Points<3> inside(const ClosedMesh& mesh, const Points<3>& points);

}  // namespace plumbline
