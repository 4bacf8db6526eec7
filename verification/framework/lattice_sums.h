#pragma once

#include "verification/framework/oracle.h"
#include "verification/framework/patch.h"

#include <functional>
#include <string>
#include <vector>

namespace verification {

/// All points of a lattice at one distance from one of its points.
struct Shell {
    Real50 distance_squared;  // in units of the distance of nearest neighbours
    int n_points;
};

/// A lattice known in two ways that share nothing: by its basis, from which patches are made, and by
/// the number of its points at each distance, from theorems of number theory.
template <int Dim> struct KnownLattice {
    std::string name;
    Lattice<Dim> lattice;  // nearest neighbours at distance 1
    Real50 cell_volume;
    /// The shells closer than `limit`, the point itself included.
    std::function<std::vector<Shell>(double limit)> shells;
};

/// the line: two points at each whole distance.
const std::vector<KnownLattice<1>>& line_lattices();
/// square (Jacobi: 4 Σ over odd divisors of n of ±1), hexagonal (6 Σ over divisors of ±1, mod 3).
const std::vector<KnownLattice<2>>& plane_lattices();
/// simple cubic (sums of three squares), body-centred and face-centred cubic (its subsets).
const std::vector<KnownLattice<3>>& space_lattices();

/// ω(r), ω′(r) / r and Δω(r) of poly6 with support `h`, to 50 digits: polynomials of r².
struct Poly6To50Digits {
    Real50 value, slope_over_r, laplacian;
};
Poly6To50Digits poly6_to_50_digits(int dim, const Real50& h, const Real50& r_squared);

/// What the operators give at a point of the lattice with poly6 of support `h` [spacings] and the cell
/// as volume: 1 if they were exact.
struct LatticeSums {
    Real50 density;            // Σ ω V
    Real50 gradient;           // ∂f/∂x of f = x by Eqs. 9, 13
    Real50 laplacian;          // Δf / 2 of f = y² by Eqs. 11, 15
    Real50 printed_laplacian;  // the same with ω″ for Δω, as Eq. 15 is printed
};
template <int Dim> LatticeSums lattice_sums(const KnownLattice<Dim>& lattice, double h);

}  // namespace verification
