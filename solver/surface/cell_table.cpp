#include "solver/surface/cell_table.h"

#include <optional>
#include <vector>

namespace plumbline {

namespace {
using Corners = std::array<int, 4>;  // of a face, counter-clockwise seen from outside of the cell
using Loop = std::vector<int>;       // edges of the cell
using Triangles = std::vector<std::array<int, 3>>;

template <int Dim> int edge_between(int a, int b) {
    const int low = a < b ? a : b;
    int axis = 0;
    while ((a ^ b) != 1 << axis) ++axis;
    return Dim * low + axis;
}

struct Segment {
    int from, to;  // edges
};
/// One segment for each run of inside corners, which it has on its right as seen from outside.
template <int Dim> std::vector<Segment> segments(const Corners& face, int inside) {
    const auto is_inside = [&](int k) { return (inside >> face[k % 4] & 1) != 0; };
    std::vector<Segment> found;
    for (int first = 0; first < 4; ++first) {
        if (!is_inside(first) || is_inside(first + 3)) continue;
        int last = first;
        while (is_inside(last + 1)) ++last;
        found.push_back({edge_between<Dim>(face[(first + 3) % 4], face[first]),
                         edge_between<Dim>(face[last % 4], face[(last + 1) % 4])});
    }
    return found;
}

std::array<Corners, 6> faces_of_cube() {
    std::array<Corners, 6> faces;
    for (int axis = 0; axis < 3; ++axis) {
        const int d = 1 << axis, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        faces[2 * axis] = {0, v, u | v, u};
        faces[2 * axis + 1] = {d, d | u, d | u | v, d | v};
    }
    return faces;
}

bool on_one_face(int edge, int other) {
    for (const Corners& face : faces_of_cube()) {
        int on_face = 0;
        for (int k = 0; k < 4; ++k) {
            const int e = edge_between<3>(face[k], face[(k + 1) % 4]);
            on_face += (e == edge) + (e == other);
        }
        if (on_face == 2) return true;
    }
    return false;
}

std::vector<Loop> loops(int inside) {
    std::array<int, 24> next;
    next.fill(-1);
    for (const Corners& face : faces_of_cube())
        for (const Segment& s : segments<3>(face, inside)) next[s.from] = s.to;
    std::vector<Loop> all;
    for (int start = 0; start < 24; ++start) {
        Loop loop;
        for (int edge = start; next[edge] >= 0;) {
            loop.push_back(edge);
            const int after = next[edge];
            next[edge] = -1;
            edge = after;
        }
        if (!loop.empty()) all.push_back(loop);
    }
    return all;
}

/// Of the corners first ... last of a loop; empty if each way has a diagonal that lies in a face.
std::optional<Triangles> triangulated(const Loop& loop, std::size_t first, std::size_t last) {
    if (last - first < 2) return Triangles{};
    const auto is_bad = [&](std::size_t a, std::size_t b) {
        return b - a > 1 && on_one_face(loop[a], loop[b]);
    };
    for (std::size_t k = first + 1; k < last; ++k) {
        if (is_bad(first, k) || is_bad(k, last)) continue;
        auto triangles = triangulated(loop, first, k);
        const auto rest = triangulated(loop, k, last);
        if (!triangles || !rest) continue;
        triangles->insert(triangles->end(), rest->begin(), rest->end());
        triangles->push_back({loop[first], loop[k], loop[last]});
        return triangles;
    }
    return std::nullopt;
}

template <int Dim, class Facet> void add(CellCase<Dim>& cell, const Facet& facet) {
    auto& added = cell.facets.at(static_cast<std::size_t>(cell.count++));
    for (std::size_t k = 0; k < Dim; ++k) added[k] = static_cast<std::uint8_t>(facet[k]);
}

CellTable<2> table_of_squares() {
    CellTable<2> table;
    for (int inside = 0; inside < 16; ++inside)
        for (const Segment& s : segments<2>({0, 1, 3, 2}, inside))
            add<2>(table[inside], std::array{s.to, s.from});
    return table;
}
CellTable<3> table_of_cubes() {
    CellTable<3> table;
    for (int inside = 0; inside < 256; ++inside)
        for (const Loop& loop : loops(inside)) {
            const auto triangles = triangulated(loop, 0, loop.size() - 1);
            for (const auto& t : triangles.value()) add<3>(table[inside], t);
        }
    return table;
}
}  // namespace

template <> const CellTable<2>& cell_table<2>() {
    static const CellTable<2> table = table_of_squares();
    return table;
}
template <> const CellTable<3>& cell_table<3>() {
    static const CellTable<3> table = table_of_cubes();
    return table;
}

}  // namespace plumbline
