#include "solver/particles/closed_mesh.h"

#include "solver/foundation/parallel.h"
#include "solver/foundation/random.h"
#include "solver/particles/halton.h"
#include "solver/particles/lattice.h"
#include "verification/framework/registry.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <Eigen/Geometry>

#include <map>
#include <numbers>

namespace closed_mesh_claims {
namespace {
using namespace plumbline;
using namespace verification;
using Rational = boost::multiprecision::cpp_rational;
using Triangles = std::vector<std::array<Index, 3>>;

TriangleMesh octahedron() {
    TriangleMesh mesh;
    for (int d = 0; d < 3; ++d)
        for (const double sign : {1.0, -1.0}) mesh.vertices.push_back(sign * Vec<3>::Unit(d));
    for (Index i : {0u, 1u})
        for (Index j : {2u, 3u})
            for (Index k : {4u, 5u}) mesh.triangles.push_back({i, j, k});
    return mesh;
}

/// Each triangle cut into four, the new corners moved onto the unit sphere.
TriangleMesh refined(const TriangleMesh& coarse) {
    TriangleMesh fine{coarse.vertices, {}};
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
        const auto [at, added] =
            middles.try_emplace(std::minmax(a, b), static_cast<Index>(fine.vertices.size()));
        if (added) fine.vertices.push_back((coarse.vertices[a] + coarse.vertices[b]).normalized());
        return at->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const auto& t : Triangles{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            fine.triangles.push_back(t);
    }
    return fine;
}
TriangleMesh sphere(int refinements) {
    TriangleMesh mesh = octahedron();
    for (int k = 0; k < refinements; ++k) mesh = refined(mesh);
    return mesh;
}

/// The sign of det(b − a, c − a, x − a), in exact arithmetic.
int side(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& x) {
    Rational m[3][3];
    const Vec<3>* rows[] = {&b, &c, &x};
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) m[i][d] = Rational((*rows[i])[d]) - Rational(a[d]);
    const Rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return det.sign();
}
/// A convex body with the origin inside: x is in it iff no face has x and the origin on two sides.
bool convex_contains(const TriangleMesh& mesh, const Vec<3>& x) {
    for (const auto& [i, j, k] : mesh.triangles) {
        const auto &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        if (side(a, b, c, x) * side(a, b, c, Vec<3>::Zero()) < 0) return false;
    }
    return true;
}

/// Points that rounding misjudges: on vertices, middles of edges and faces, and one bit beside.
Points<3> awkward_points(const TriangleMesh& mesh) {
    Points<3> points = mesh.vertices;
    for (const auto& [i, j, k] : mesh.triangles) {
        points.push_back(0.5 * (mesh.vertices[i] + mesh.vertices[j]));
        points.push_back((mesh.vertices[i] + mesh.vertices[j] + mesh.vertices[k]) / 3.0);
    }
    for (std::size_t n = points.size(), i = 0; i < n; ++i)
        for (int d = 0; d < 3; ++d) {
            points.push_back(points[i]);
            points.back()[d] = std::nextafter(points[i][d], 2.0);
        }
    return points;
}

/// Crossings of the ray along x, counted in floating point; even means outside.
bool crosses_oddly(const TriangleMesh& mesh, const Vec<3>& x) {
    int crossings = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec<3> u = mesh.vertices[j] - mesh.vertices[i],
                     v = mesh.vertices[k] - mesh.vertices[i];
        const Vec<3> s = x - mesh.vertices[i], ray = Vec<3>::UnitX();
        const double det = u.dot(ray.cross(v));
        const double p = s.dot(ray.cross(v)) / det, q = ray.dot(s.cross(u)) / det;
        crossings += p >= 0 && q >= 0 && p + q <= 1 && v.dot(s.cross(u)) / det > 0;
    }
    return crossings % 2 == 1;
}

template <class Contains> double misjudged(const TriangleMesh& mesh, Contains contains) {
    double wrong = 0;
    for (const Vec<3>& x : awkward_points(mesh)) wrong += contains(x) != convex_contains(mesh, x);
    return wrong;
}

/// The triangles named the other way round, at random.
TriangleMesh shuffled(TriangleMesh mesh) {
    Random random(3);
    for (auto& t : mesh.triangles)
        if (random.uniform() < 0.5) std::swap(t[0], t[1]);
    return mesh;
}
double volume_of_octahedron(const TriangleMesh& mesh) {
    return std::abs(ClosedMesh(mesh).volume() - 4.0 / 3.0);
}
/// Σ a · (b × c) / 6 with the triangles as they are named.
double volume_as_named(const TriangleMesh& mesh) {
    double volume = 0;
    for (const auto& [i, j, k] : mesh.triangles)
        volume += mesh.vertices[i].dot(mesh.vertices[j].cross(mesh.vertices[k])) / 6;
    return std::abs(volume - 4.0 / 3.0);
}

constexpr double volume_of_ball = 4.0 / 3.0 * std::numbers::pi;

/// log₂ of the ratio of the missing volumes of two spheres, the finer with edges half as long.
double order_of_sphere() {
    return std::log2((volume_of_ball - ClosedMesh(sphere(3)).volume()) /
                     (volume_of_ball - ClosedMesh(sphere(4)).volume()));
}
/// The finer one as coarse as the other, only named otherwise.
double order_without_refinement() {
    return std::log2((volume_of_ball - ClosedMesh(sphere(3)).volume()) /
                     (volume_of_ball - ClosedMesh(shuffled(sphere(3))).volume()));
}

double share_error(const ClosedMesh& mesh, double volume) {
    const Box<3> box = mesh.bounds();
    constexpr Index n = 20000;
    const auto found = static_cast<double>(inside(mesh, halton(box, n)).size());
    return std::abs(found / n * box.volume() / volume - 1);
}

double lattice_points_off_160(const TriangleMesh& mesh) {
    const ClosedMesh body(mesh);
    return std::abs(static_cast<double>(inside(body, lattice(body.bounds(), 0.2)).size()) - 160);
}

/// What comes of it if each thread appends its share as it ends, the last one first.
Points<3> as_threads_end(const Points<3>& points) {
    const auto n = static_cast<std::ptrdiff_t>(points.size()),
               threads = std::ptrdiff_t{thread_count()};
    Points<3> all;
    for (std::ptrdiff_t k = threads; k > 0; --k)
        all.insert(all.end(), points.begin() + n * (k - 1) / threads,
                   points.begin() + n * k / threads);
    return all;
}
double differs_with_threads(bool appended) {
    const ClosedMesh body(sphere(2));
    const Points<3> points = halton(body.bounds(), 5000);
    const int threads = thread_count();
    set_thread_count(1);
    const auto filled = [&] {
        return appended ? as_threads_end(inside(body, points)) : inside(body, points);
    };
    const Points<3> serial = filled();
    set_thread_count(4);
    const Points<3> parallel = filled();
    set_thread_count(threads);
    return serial == parallel && !serial.empty() && serial.size() < points.size() ? 0 : 1;
}

const Register claims_of_closed_mesh{
    Claim{.id = "closed_mesh.inside_is_exact",
          .source = {Paper::plumbline, "docstring of ClosedMesh::contains"},
          .says = "points on corners, edges and faces, and one bit beside them, are judged exactly",
          .bound = at_most(0, "against the signs of determinants in exact fractions"),
          .measure =
              [] {
                  const TriangleMesh mesh = sphere(1);
                  const ClosedMesh body(mesh);
                  return misjudged(mesh, [&](const Vec<3>& x) { return body.contains(x); });
              },
          .sabotaged =
              [] {
                  const TriangleMesh mesh = sphere(1);
                  return misjudged(mesh, [&](const Vec<3>& x) { return crosses_oddly(mesh, x); });
              }},
    Claim{.id = "closed_mesh.volume_of_the_octahedron",
          .source = {Paper::plumbline, "docstring of ClosedMesh"},
          .says = "4/3, whichever way round its triangles are named [m³]",
          .bound = at_most(1e-15, "8 terms of 1/6, each rounded once"),
          .measure = [] { return volume_of_octahedron(shuffled(octahedron())); },
          .sabotaged = [] { return volume_as_named(shuffled(octahedron())); }},
    Claim{.id = "closed_mesh.volume_of_the_sphere",
          .source = {Paper::plumbline, "docstring of ClosedMesh::volume"},
          .says = "halving the edges of an inscribed sphere quarters the missing volume",
          .bound = between(1.97, 2.03,
                           "log₂ 4; edges of a quarter circle/16 leave terms of 4th order, "
                           "(π/32)² = 1 % of it"),
          .measure = order_of_sphere,
          .sabotaged = order_without_refinement},
    Claim{.id = "closed_mesh.share_of_points",
          .source = {Paper::plumbline, "docstring of inside"},
          .says = "of a sampling of the bounding box, the share volume / box is inside",
          .bound = at_most(0.013,
                           "independent points would have √((1 − p)/(p n)) = 0.68 % with p = "
                           "0.5, n = 20000, Halton points have less; twice that"),
          .measure =
              [] {
                  const ClosedMesh body(sphere(2));
                  return share_error(body, body.volume());
              },
          .sabotaged = [] { return share_error(ClosedMesh(sphere(2)), volume_of_ball); }},
    Claim{
        .id = "closed_mesh.lattice_in_the_octahedron",
        .source = {Paper::plumbline, "docstring of inside"},
        .says =
            "of the lattice of 10³ points in [−1, 1]³, those in the octahedron are counted exactly",
        .bound = at_most(0,
                         "off 160: coordinates are odd numbers/10, three positive ones with a sum "
                         "of at most 10 are (2i+1, 2j+1, 2k+1), i + j + k ≤ 3: 20, and 8 octants"),
        .measure = [] { return lattice_points_off_160(octahedron()); },
        .sabotaged = [] { return lattice_points_off_160(sphere(2)); }},
    Claim{.id = "closed_mesh.threads",
          .source = {Paper::plumbline, "docstring of parallel_for"},
          .says = "the same points with 1 and with 4 threads, in the same order",
          .bound = at_most(0, "1 if they differ"),
          .measure = [] { return differs_with_threads(false); },
          .sabotaged = [] { return differs_with_threads(true); }},
};
}  // namespace
}  // namespace closed_mesh_claims
