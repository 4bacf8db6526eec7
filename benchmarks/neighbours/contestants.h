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
    /// The points of `build` have moved: by the search's own update if it has one, else by building.
    virtual void update(Points points) = 0;
    virtual bool has_update() const = 0;
    /// `radii` has one radius for each query, or is empty: that of `build` for all.
    virtual void query(Points queries, std::span<const double> radii,
                       plumbline::NeighbourLists& lists) const = 0;
};

/// The searches of the solver but brute force, then the libraries: cell_grid, hash_grid, hash_grid_r,
/// kd_tree, nanoflann, nanoflann_tuned, cgal_kd_tree. A new one is added to the list in contestants.cpp.
std::vector<std::string> contestant_names();

/// Throws InvalidInput, naming those there are, if there is none of that name; Dim is 2 or 3.
template <int Dim> std::unique_ptr<Contestant<Dim>> make_contestant(const std::string& name);

}  // namespace benchmarks
