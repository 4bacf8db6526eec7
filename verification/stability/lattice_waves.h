#pragma once

#include "verification/fluid/dispersion.h"

#include <array>

namespace verification {

/// The lattice of LatticeFluid, nearest neighbours at 1: hexagonal, close packed.
template <int Dim> Lattice<Dim> packed_lattice() {
    if constexpr (Dim == 2)
        return hexagonal_lattice(1.0);
    else
        return close_packed_lattice(1.0);
}

/// Of the cells with right angles that make it up: their edges, and how many of them repeat along each axis.
template <int Dim> plumbline::Vec<Dim> cell_of_lattice() {
    if constexpr (Dim == 2)
        return {1.0, 2.0 * std::sqrt(0.75)};
    else
        return plumbline::Vec<3>::Constant(std::numbers::sqrt2);
}
template <int Dim> std::array<int, Dim> cells_that_repeat() {
    if constexpr (Dim == 2)
        return {10, 6};
    else
        return {4, 4, 4};
}

/// The box that repeats.
template <int Dim> plumbline::Vec<Dim> size_of_lattice() {
    plumbline::Vec<Dim> size = cell_of_lattice<Dim>();
    for (int d = 0; d < Dim; ++d) size[d] *= cells_that_repeat<Dim>()[static_cast<std::size_t>(d)];
    return size;
}
/// f(n) for all whole n from 0 below `count` along each axis.
template <int Dim, class F> void for_each_place(const std::array<int, Dim>& count, F f) {
    int all = 1;
    for (const int n : count) all *= n;
    for (int index = 0; index < all; ++index) {
        plumbline::Vec<Dim> place;
        int rest = index;
        for (std::size_t d = 0; d < Dim; ++d)
            place[static_cast<int>(d)] = rest % count[d], rest /= count[d];
        f(place);
    }
}
template <int Dim> plumbline::Points<Dim> points_of_lattice() {
    plumbline::Points<Dim> x;
    for_each_place<Dim>(cells_that_repeat<Dim>(), [&](const plumbline::Vec<Dim>& place) {
        const auto add = [&](const plumbline::Vec<Dim>& in_cell) {
            x.push_back((place + in_cell).cwiseProduct(cell_of_lattice<Dim>()));
        };
        const auto first = plumbline::Vec<Dim>::Constant(0.25);
        add(first);
        if constexpr (Dim == 2) {
            add(first + plumbline::Vec<2>::Constant(0.5));
        } else {
            for (int axis = 0; axis < 3; ++axis)
                add(first + 0.5 * (plumbline::Vec<3>::Ones() - plumbline::Vec<3>::Unit(axis)));
        }
    });
    return x;
}
/// f(k) for the waves that fit the box and differ on the lattice, some more than once; not for k = 0.
template <int Dim, class F> void for_each_wave_of_lattice(F f) {
    std::array<int, Dim> waves = cells_that_repeat<Dim>();
    for (int& n : waves) n *= 2;
    for_each_place<Dim>(waves, [&](const plumbline::Vec<Dim>& n) {
        if (!n.isZero())
            f(plumbline::Vec<Dim>(2.0 * std::numbers::pi *
                                  n.cwiseQuotient(size_of_lattice<Dim>())));
    });
}

}  // namespace verification
