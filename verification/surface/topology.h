#pragma once

#include "solver/surface/isosurface.h"

#include <map>

namespace verification {

/// Corners of facets (edges in space, ends of edges in the plane) that are not shared as on a closed surface: each must occur
/// once in one direction and once in the other.
inline double open_edges(const plumbline::Isosurface<2>& s) {
    std::map<plumbline::Index, std::pair<int, int>> ends;
    for (const auto& [from, to] : s.facets) ++ends[from].first, ++ends[to].second;
    double open = 0.0;
    for (const auto& [vertex, count] : ends) open += count != std::pair{1, 1};
    return open;
}
inline double open_edges(const plumbline::Isosurface<3>& s) {
    std::map<std::pair<plumbline::Index, plumbline::Index>, int> directed;
    for (const auto& t : s.facets)
        for (int k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
    double open = 0.0;
    for (const auto& [edge, count] : directed) {
        const auto back = directed.find({edge.second, edge.first});
        open += count != 1 || back == directed.end() || back->second != 1;
    }
    return open;
}

/// Vertices around which the triangles are not one closed fan; in a closed surface without shared edges there can
/// still be two fans that touch at their tip.
inline double split_vertices(const plumbline::Isosurface<2>&) { return 0.0; }
inline double split_vertices(const plumbline::Isosurface<3>& s) {
    std::map<plumbline::Index, std::map<plumbline::Index, plumbline::Index>> around;
    for (const auto& t : s.facets)
        for (int k = 0; k < 3; ++k) around[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
    double split = 0.0;
    for (const auto& [vertex, next] : around) {
        std::size_t length = 0;
        auto at = next.begin();
        do {
            ++length;
            at = next.find(at->second);
        } while (at != next.end() && at != next.begin() && length <= next.size());
        split += at != next.begin() || length != next.size();
    }
    return split;
}

/// V − E + F; of a closed surface 2 for each sphere, 0 for each torus. In the plane V − E: 0 for closed curves.
inline double euler_number(const plumbline::Isosurface<2>& s) {
    return static_cast<double>(s.vertices.size()) - static_cast<double>(s.facets.size());
}
inline double euler_number(const plumbline::Isosurface<3>& s) {
    std::map<std::pair<plumbline::Index, plumbline::Index>, int> edges;
    for (const auto& t : s.facets)
        for (int k = 0; k < 3; ++k) ++edges[std::minmax<plumbline::Index>(t[k], t[(k + 1) % 3])];
    return static_cast<double>(s.vertices.size()) - static_cast<double>(edges.size()) +
           static_cast<double>(s.facets.size());
}

}  // namespace verification
