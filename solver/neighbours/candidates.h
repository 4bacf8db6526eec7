#pragma once

#include "solver/neighbours/space.h"

#include <array>
#include <vector>

namespace plumbline {

/// Points that may be neighbours of the queries in one cell, one array per coordinate.
template <int Dim> struct Candidates {
    std::array<std::vector<double>, Dim> x;
    std::vector<Index> id;
    std::vector<Index> within;  // those that collect_within found
    std::size_t size = 0;

    /// Makes room for n; the arrays only grow.
    void reserve(std::size_t n) {
        if (n <= id.size()) return;
        for (auto& coordinate : x) coordinate.resize(2 * n);
        id.resize(2 * n);
        within.resize(2 * n);
    }
};

/// ‖q − candidate k‖², by the expression of squared_distance.
template <class Space, int Dim>
double squared_distance(const Space& space, const Vec<Dim>& q, const Candidates<Dim>& c,
                        std::size_t k) {
    const double first = space.difference(q[0], c.x[0][k], 0);
    double total = first * first;
    for (int axis = 1; axis < Dim; ++axis) {
        const double d = space.difference(q[axis], c.x[axis][k], axis);
        total += d * d;
    }
    return total;
}

template <class Space, int Dim>
std::size_t count_within(const Space& space, const Vec<Dim>& q, double squared_radius,
                         const Candidates<Dim>& c) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < c.size; ++k)
        found += squared_distance(space, q, c, k) < squared_radius ? 1 : 0;
    return found;
}

/// Writes the ids of the candidates within the radius to `c.within`, in their order; returns how many
/// there are.
template <class Space, int Dim>
std::size_t collect_within(const Space& space, const Vec<Dim>& q, double squared_radius,
                           Candidates<Dim>& c) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < c.size; ++k) {
        c.within[found] = c.id[k];
        found += squared_distance(space, q, c, k) < squared_radius ? 1 : 0;
    }
    return found;
}

}  // namespace plumbline
