#pragma once

#include "benchmarks/neighbours/point_clouds.h"
#include "solver/neighbours/neighbour_lists.h"

namespace benchmarks {

/// The bytes of the lists, extrapolated from a sample of rows.
/// Throws InvalidInput if they would not fit into memory next to those of a second search; if there are no
/// points, or the radius is none.
template <int Dim> double affordable_lists(const PointCloud<Dim>& cloud);

/// Of all memory, and of that which is free or can be freed.
double memory_bytes();
double free_memory_bytes();

/// How many rows of `cloud` brute force can give within `pairs` tested pairs; at least one.
std::size_t affordable_rows(std::size_t points, double pairs);

/// Pairs that the lists have and brute force has not, or the reverse, over `rows` rows that are spread
/// evenly over all; positions and distances in the precision Real.
template <class Real = double, int Dim>
std::size_t wrong_against_brute_force(const PointCloud<Dim>& cloud,
                                      const plumbline::NeighbourLists& lists, std::size_t rows);

}  // namespace benchmarks
