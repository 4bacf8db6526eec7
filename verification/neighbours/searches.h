#pragma once

#include "solver/neighbours/brute_force.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/neighbours/hash_grid.h"
#include "solver/neighbours/kd_tree.h"
#include "solver/neighbours/leaf_tree.h"
#include "solver/neighbours/level_grid.h"
#include "verification/neighbours/under_test.h"

#include <algorithm>

namespace verification {

/// Calls visit(search) with each search of the solver but brute force, their oracle. A new search is
/// added here, and is then held to every claim about searches.
template <int Dim, class Space, class Visit> void for_each_search(const Space& space, Visit visit) {
    using namespace plumbline;
    visit(KdTree<Dim, Space>(space));
    visit(HashGrid<Dim, HashSpacing::diameter, Space>(space));
    visit(HashGrid<Dim, HashSpacing::radius, Space>(space));
    visit(CellGrid<Dim, Space>(space));
    visit(LeafTree<Dim, Space>(space));
    visit(LevelGrid<Dim, Space>(space));
}
/// The same in open space, the searches of adams2009 by way of their seams.
template <int Dim, class Visit> void for_each_search(Visit visit) {
    using namespace plumbline;
    visit(KdTreeUnderTest<Dim>());
    visit(HashGridUnderTest<Dim>());
    visit(HashGrid<Dim, HashSpacing::radius>());
    visit(CellGrid<Dim>());
    visit(LeafTree<Dim>());
    visit(LevelGrid<Dim>());
}

/// Pairs that one of two lists has and the other has not, and pairs listed twice.
inline std::size_t wrong_pairs(const plumbline::NeighbourLists& found,
                               const plumbline::NeighbourLists& expected) {
    if (found == expected) return 0;
    if (found.size() != expected.size())
        return std::max<std::size_t>(1, found.indices.size() + expected.indices.size());
    std::size_t wrong = 0;
    for (plumbline::Index i = 0; i < found.size(); ++i) {
        std::vector<plumbline::Index> row(found.of(i).begin(), found.of(i).end()), difference;
        std::ranges::sort(row);
        std::ranges::set_symmetric_difference(row, expected.of(i), std::back_inserter(difference));
        wrong += difference.size();
    }
    return std::max<std::size_t>(1, wrong);  // at least the order is not the agreed one
}

}  // namespace verification
