#pragma once

#include "solver/neighbours/neighbour_lists.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace benchmarks {

/// A search chosen at run time. A call costs nothing beside building or querying a whole cloud.
template <int Dim> class Contestant {
public:
    using Points = std::span<const plumbline::Vec<Dim>>;

    virtual ~Contestant() = default;
    virtual std::string name() const = 0;
    virtual void build(Points points, double radius) = 0;
    virtual void query(Points queries, plumbline::NeighbourLists& lists) const = 0;
    virtual std::size_t memory() const = 0;  // bytes
};

/// The searches of the solver but brute force, then the libraries: cell_grid, hash_grid, hash_grid_r,
/// kd_tree, nanoflann, cgal_kd_tree. A new one is added to the list in contestants.cpp.
std::vector<std::string> contestant_names();

/// Throws InvalidInput, naming those there are, if there is none of that name; Dim is 2 or 3.
template <int Dim> std::unique_ptr<Contestant<Dim>> make_contestant(const std::string& name);

}  // namespace benchmarks
