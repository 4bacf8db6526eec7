#include "solver/approximation/density.h"
#include "solver/io/csv.h"
#include "solver/kernels/poly6.h"
#include "solver/neighbours/brute_force.h"

#include <cmath>
#include <cstdio>
#include <numbers>

// A cross of five particles of mass 1, arms h/2 long. By hand, with q = 1/2 for the four arms:
// ρ = ω(0) + 4 ω(h/2) = 4/(π h²) (1 + 4 (1 − 1/4)³) = 43 / (4 π h²).
int main() {
    using namespace plumbline;
    const double h = 2.0;
    const Poly6<2> w(h);
    const Points<2> x{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const std::vector<double> m(x.size(), 1.0);

    BruteForce<2> search;
    search.build(x, w.support());
    const NeighbourLists neighbours = search.query(x);
    const double rho = density<Poly6<2>>(w, x, m, {x[0], neighbours.of(0)});

    const double expected = 43.0 / (4.0 * std::numbers::pi * h * h);
    const double bound = 12 * 0x1p-53;  // relative: 8 roundings in each ω, 4 in the sum
    std::printf("%s, expected %s\n", digits17(rho).c_str(), digits17(expected).c_str());
    return std::abs(rho - expected) <= bound * expected ? 0 : 1;
}
