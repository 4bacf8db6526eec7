#pragma once

#include "solver/neighbours/cell_grid.h"

#include <algorithm>

namespace verification {

template <class Real, int Dim>
std::vector<plumbline::VecOf<Real, Dim>> in_precision(const plumbline::Points<Dim>& points) {
    std::vector<plumbline::VecOf<Real, Dim>> rounded;
    for (const auto& x : points) rounded.push_back(x.template cast<Real>());
    return rounded;
}

template <class Space, class Real, int Dim>
void pack(const Space& space, const std::vector<plumbline::VecOf<Real, Dim>>& points, double radius,
          plumbline::PackedLists& lists) {
    plumbline::CellGrid<Dim, Space, Real> grid(space);
    grid.build(points, radius);
    grid.pack(lists);
}
/// Of lists that hold each pair once those that hold it from both ends, and each point itself.
inline plumbline::NeighbourLists completed(const plumbline::PackedLists& halves) {
    using plumbline::Index;
    std::vector<std::vector<Index>> rows(halves.size());
    for (Index i = 0; i < halves.size(); ++i) {
        rows[i].push_back(i);
        for (const Index j : halves.of(i)) rows[i].push_back(j), rows[j].push_back(i);
    }
    plumbline::NeighbourLists lists{{0}, {}};
    for (auto& row : rows) {
        std::ranges::sort(row);
        lists.indices.insert(lists.indices.end(), row.begin(), row.end());
        lists.offsets.push_back(lists.indices.size());
    }
    return lists;
}

}  // namespace verification
