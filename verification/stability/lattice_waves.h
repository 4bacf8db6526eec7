#pragma once

#include "verification/fluid/dispersion.h"

namespace verification {

/// The lattice of LatticeFluid, and the box that repeats.
inline const Lattice<2> hexagonal = hexagonal_lattice(1.0);
constexpr int columns_of_lattice = 10, rows_of_lattice = 12;

inline plumbline::Vec<2> size_of_lattice() {
    return {columns_of_lattice, rows_of_lattice * std::sqrt(0.75)};
}
inline plumbline::Points<2> points_of_lattice() {
    plumbline::Points<2> x;
    for (int row = 0; row < rows_of_lattice; ++row)
        for (int column = 0; column < columns_of_lattice; ++column)
            x.emplace_back(column + 0.25 + 0.5 * (row % 2), (row + 0.5) * std::sqrt(0.75));
    return x;
}
/// f(k) for the waves that fit the box.
template <class F> void for_each_wave_of_lattice(F f) {
    for (int n = 1; n < columns_of_lattice * rows_of_lattice; ++n)
        f(plumbline::Vec<2>(2.0 * std::numbers::pi *
                            plumbline::Vec<2>(n % columns_of_lattice, n / columns_of_lattice)
                                .cwiseQuotient(size_of_lattice())));
}

}  // namespace verification
