#include "verification/framework/lattice_sums.h"

#include <boost/math/constants/constants.hpp>

namespace verification {
namespace {
int sum_over_divisors(int n, int (*sign)(int)) {
    int sum = 0;
    for (int d = 1; d <= n; ++d)
        if (n % d == 0) sum += sign(d);
    return sum;
}

int one_square(int n) {
    for (int a = 1; a * a <= n; ++a)
        if (a * a == n) return 2;
    return n == 0 ? 1 : 0;
}
/// In how many ways is n = a² + b²? Jacobi 1829.
int two_squares(int n) {
    const auto sign = [](int d) { return d % 4 == 1 ? 1 : d % 4 == 3 ? -1 : 0; };
    return n == 0 ? 1 : 4 * sum_over_divisors(n, sign);
}
/// In how many ways is n = a² + a b + b²?
int hexagonal_form(int n) {
    const auto sign = [](int d) { return d % 3 == 1 ? 1 : d % 3 == 2 ? -1 : 0; };
    return n == 0 ? 1 : 6 * sum_over_divisors(n, sign);
}
int three_squares(int n) {
    int ways = two_squares(n);
    for (int c = 1; c * c <= n; ++c) ways += 2 * two_squares(n - c * c);
    return ways;
}
/// Twice the lattice: whole coordinates, all even (sum of squares 0 mod 4) or all odd (3 mod 8); no
/// other whole coordinates have these sums.
int body_centred(int n) { return n % 4 == 0 || n % 8 == 3 ? three_squares(n) : 0; }
/// √2 times the lattice: whole coordinates whose sum is even, and so the sum of their squares.
int face_centred(int n) { return n % 2 == 0 ? three_squares(n) : 0; }

/// Shells of a lattice whose distances² are n / nearest, `ways(n)` points at each.
auto shells(int (*ways)(int), int nearest) {
    return [=](double limit) {
        std::vector<Shell> all;
        for (int n = 0; n < limit * limit * nearest; ++n)
            if (const int n_points = ways(n); n_points > 0)
                all.push_back({Real50(n) / nearest, n_points});
        return all;
    };
}
}  // namespace

const std::vector<KnownLattice<1>>& line_lattices() {
    static const std::vector<KnownLattice<1>> all{
        {"line", cubic_lattice<1>(1.0), 1, shells(one_square, 1)}};
    return all;
}
const std::vector<KnownLattice<2>>& plane_lattices() {
    static const std::vector<KnownLattice<2>> all{
        {"square", cubic_lattice<2>(1.0), 1, shells(two_squares, 1)},
        {"hexagonal", hexagonal_lattice(1.0), sqrt(Real50(3)) / 2, shells(hexagonal_form, 1)}};
    return all;
}
const std::vector<KnownLattice<3>>& space_lattices() {
    static const std::vector<KnownLattice<3>> all{
        {"simple_cubic", cubic_lattice<3>(1.0), 1, shells(three_squares, 1)},
        {"body_centred", body_centred_lattice(1.0), 4 / sqrt(Real50(27)), shells(body_centred, 3)},
        {"face_centred", close_packed_lattice(1.0), 1 / sqrt(Real50(2)), shells(face_centred, 2)}};
    return all;
}

Poly6To50Digits poly6_to_50_digits(int dim, const Real50& h, const Real50& r_squared) {
    const Real50 q2 = r_squared / (h * h);
    if (q2 >= 1) return {0, 0, 0};
    const Real50 pi = boost::math::constants::pi<Real50>(), s = 1 - q2;
    const Real50 sigma = dim == 1   ? Real50(35) / (32 * h)
                         : dim == 2 ? 4 / (pi * h * h)
                                    : Real50(315) / (64 * pi * h * h * h);
    // With u = r²: ω = σ (1 − u/h²)³, ω′/r = 2 dω/du, Δω = 4 u d²ω/du² + 2 dim dω/du
    const Real50 first = -3 * sigma / (h * h) * s * s, second = 6 * sigma / (h * h * h * h) * s;
    return {sigma * s * s * s, 2 * first, 4 * r_squared * second + 2 * dim * first};
}

template <int Dim> LatticeSums lattice_sums(const KnownLattice<Dim>& lattice, double h) {
    LatticeSums sums{0, 0, 0, 0};
    for (const Shell& shell : lattice.shells(h)) {
        const auto w = poly6_to_50_digits(Dim, h, shell.distance_squared);
        const Real50 V = lattice.cell_volume * shell.n_points, r2 = shell.distance_squared;
        // The mean of x² over a shell is r²/dim: the lattices have cubic or hexagonal symmetry.
        sums.density += V * w.value;
        sums.gradient -= V * r2 / Dim * w.slope_over_r;
        sums.laplacian += V * r2 / (2 * Dim) * w.laplacian;
        sums.printed_laplacian += V * r2 / (2 * Dim) * (w.laplacian - (Dim - 1) * w.slope_over_r);
    }
    return sums;
}
template LatticeSums lattice_sums(const KnownLattice<1>&, double);
template LatticeSums lattice_sums(const KnownLattice<2>&, double);
template LatticeSums lattice_sums(const KnownLattice<3>&, double);

}  // namespace verification
