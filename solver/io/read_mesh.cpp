#include "solver/io/read_mesh.h"

#include "solver/io/source_text.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>

namespace plumbline {

namespace {
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Polygon = std::vector<std::size_t>;
namespace processing = CGAL::Polygon_mesh_processing;

[[noreturn]] void reject(const std::filesystem::path& path, const std::string& found) {
    throw InvalidInput(path.string() +
                       ": expected a mesh in the format of its extension (.obj, "
                       ".off, .ply or .stl), found " +
                       found);
}

void read_soup(const std::filesystem::path& path, std::vector<Point>& points,
               std::vector<Polygon>& polygons) {
    // A count in the header that the file cannot hold ends in one of these exceptions, too.
    try {
        if (!CGAL::IO::read_polygon_soup(path.string(), points, polygons))
            reject(path, "something else");
    } catch (const InvalidInput&) {
        throw;
    } catch (const std::exception& e) {
        reject(path, std::string("something else: ") + e.what());
    }
    for (const Polygon& polygon : polygons)
        if (polygon.size() < 3 || std::ranges::max(polygon) >= points.size())
            reject(path, "a face without three corners among the vertices");
    if (polygons.empty()) reject(path, "no faces");
}

/// Appends the triangles of a polygon, which need be neither convex nor exactly plane.
void add_triangles(const std::vector<Point>& points, const Polygon& polygon, TriangleMesh& mesh) {
    const auto corner = [&](int k) { return static_cast<Index>(polygon[k]); };
    std::vector<CGAL::Triple<int, int, int>> parts;
    if (polygon.size() == 3) {
        parts.emplace_back(0, 1, 2);
    } else {
        std::vector<Point> corners;
        for (const std::size_t i : polygon) corners.push_back(points[i]);
        processing::triangulate_hole_polyline(corners, std::back_inserter(parts));
    }
    for (const auto& t : parts)
        mesh.triangles.push_back({corner(t.first), corner(t.second), corner(t.third)});
}
}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
    SourceText::read(path);  // for its messages
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    read_soup(path, points, polygons);
    processing::merge_duplicate_points_in_polygon_soup(points, polygons);

    TriangleMesh mesh;
    for (const Point& p : points) mesh.vertices.emplace_back(p.x(), p.y(), p.z());
    for (const Polygon& polygon : polygons) add_triangles(points, polygon, mesh);
    return mesh;
}

}  // namespace plumbline
