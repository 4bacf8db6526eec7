#include "solver/particles/closed_mesh.h"

#include "solver/foundation/parallel.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace plumbline {

namespace {
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Exact::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangles =
    CGAL::AABB_tree<CGAL::AABB_traits<Exact, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;
namespace processing = CGAL::Polygon_mesh_processing;

void require_vertices_and_corners(const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        throw InvalidInput("mesh: expected at least one triangle, found none");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!mesh.vertices[i].allFinite())
            throw InvalidInput("mesh: vertex " + std::to_string(i) +
                               ": expected finite coordinates, found others");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const Index corner : mesh.triangles[t])
            if (corner >= mesh.vertices.size())
                throw InvalidInput(
                    "mesh: triangle " + std::to_string(t) + ": expected corners below " +
                    std::to_string(mesh.vertices.size()) + ", found " + std::to_string(corner));
}

Mesh outward_surface(const TriangleMesh& mesh) {
    require_vertices_and_corners(mesh);
    std::vector<Point> points;
    for (const Vec<3>& x : mesh.vertices) points.emplace_back(x[0], x[1], x[2]);
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const auto& t : mesh.triangles) triangles.push_back({t[0], t[1], t[2]});
    if (!processing::orient_polygon_soup(points, triangles) ||
        !processing::is_polygon_soup_a_polygon_mesh(triangles))
        throw InvalidInput(
            "mesh: expected a surface, found edges shared by more than two triangles"
            " or triangles that cannot be oriented alike");
    Mesh surface;
    processing::polygon_soup_to_polygon_mesh(points, triangles, surface);
    std::size_t open = 0;
    for (const auto edge : surface.edges()) open += surface.is_border(edge);
    if (open > 0)
        throw InvalidInput("mesh: expected a closed surface, found " + std::to_string(open) +
                           " edges with a triangle on one side only");
    if (processing::does_self_intersect(surface))
        throw InvalidInput(
            "mesh: expected a surface that does not cut itself, found one that does");
    processing::orient_to_bound_a_volume(surface);
    return surface;
}
}  // namespace

struct ClosedMesh::Surface {
    explicit Surface(const TriangleMesh& triangles)
        : mesh{outward_surface(triangles)},
          side_of{mesh},
          faces(mesh.faces().begin(), mesh.faces().end(), mesh) {
        // Now, so that threads may share the trees that queries need.
        faces.accelerate_distance_queries();
        side_of(Point(0.0, 0.0, 0.0));
        faces.closest_point(Point(0.0, 0.0, 0.0));
    }
    Mesh mesh;
    CGAL::Side_of_triangle_mesh<Mesh, Exact> side_of;
    Triangles faces;
};

ClosedMesh::ClosedMesh(const TriangleMesh& mesh) : surface_{std::make_unique<Surface>(mesh)} {}
ClosedMesh::~ClosedMesh() = default;
ClosedMesh::ClosedMesh(ClosedMesh&&) noexcept = default;
ClosedMesh& ClosedMesh::operator=(ClosedMesh&&) noexcept = default;

bool ClosedMesh::contains(const Vec<3>& x) const {
    return x.allFinite() && surface_->side_of(Point(x[0], x[1], x[2])) != CGAL::ON_UNBOUNDED_SIDE;
}

FromSurface<3> ClosedMesh::from_surface(const Vec<3>& x) const {
    const auto [nearest, face] =
        surface_->faces.closest_point_and_primitive(Point(x[0], x[1], x[2]));
    const Vec<3> foot(nearest.x(), nearest.y(), nearest.z());
    const double outwards = contains(x) ? -1.0 : 1.0;
    const Vec<3> arm = x - foot;
    const double distance = arm.norm();
    // Rounding leaves no direction to an arm this short.
    if (distance > 1e-12 * (1.0 + x.cwiseAbs().maxCoeff()))
        return {outwards * distance, outwards / distance * arm};
    const auto n = processing::compute_face_normal(face, surface_->mesh);
    return {outwards * distance, Vec<3>(n.x(), n.y(), n.z())};
}

double ClosedMesh::volume() const { return CGAL::to_double(processing::volume(surface_->mesh)); }

TriangleMesh ClosedMesh::triangles() const {
    const Mesh& mesh = surface_->mesh;
    TriangleMesh triangles;
    for (const Point& x : mesh.points()) triangles.vertices.emplace_back(x.x(), x.y(), x.z());
    for (const auto face : mesh.faces()) {
        std::array<Index, 3> corners{};
        std::size_t k = 0;
        for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            corners[k++] = static_cast<Index>(std::size_t{vertex});
        triangles.triangles.push_back(corners);
    }
    return triangles;
}

Box<3> ClosedMesh::bounds() const {
    const auto box = processing::bbox(surface_->mesh);
    return {{box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()}};
}

Points<3> inside(const ClosedMesh& mesh, const Points<3>& points) {
    std::vector<char> is_in(points.size());
    parallel_for(points.size(), [&](std::size_t i) { is_in[i] = mesh.contains(points[i]); });
    Points<3> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_in[i]) kept.push_back(points[i]);
    return kept;
}

}  // namespace plumbline
