#pragma once

#include "solver/neighbours/brute_force.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/neighbours/hash_grid.h"
#include "solver/neighbours/kd_tree.h"

namespace verification {

/// Calls visit(search) with each search of the solver but brute force, their oracle. A new search is
/// added here, and is then held to every claim about searches.
template <int Dim, class Space, class Visit> void for_each_search(const Space& space, Visit visit) {
    using namespace plumbline;
    visit(KdTree<Dim, Space>(space));
    visit(HashGrid<Dim, HashSpacing::diameter, Space>(space));
    visit(HashGrid<Dim, HashSpacing::radius, Space>(space));
    visit(CellGrid<Dim, Space>(space));
}
template <int Dim, class Visit> void for_each_search(Visit visit) {
    for_each_search<Dim>(plumbline::OpenSpace<Dim>{}, visit);
}

}  // namespace verification
