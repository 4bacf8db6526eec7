#include "verification/framework/expected_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace verification {

namespace {
/// Orders of polynomial methods are whole numbers: half of one tells them apart.
constexpr double half = 0.5;
/// Orders of SPH with growing support differ by at least 1/2.
constexpr double quarter = 0.25;

/// Up to which degree a method reproduces polynomials, at its samples; −1: not even constants. That
/// of a derivative which is only ever used as one counts from the derivative's own degree: an
/// operator that annihilates constants is of degree 0.
int reproduced_degree(const Approximation& a) {
    static const std::map<std::string_view, int> degrees{
        {"SPH Eq. 3", -1}, {"SPH Eq. 9", -1}, {"SPH Eq. 11", -1}, {"SPH Eq. 19", -1},
        {"SPH Eq. 13", 0}, {"SPH Eq. 17", 0}, {"SPH Eq. 15", 0},  {"Brookshaw", 0},
        {"Shepard", 0},    {"MLS 0", 0},      {"Mueller", 1},     {"MLS 1", 1},
        {"MLS 2", 2},      {"MLSPH", 2},      {"MLS 3", 3}};
    const auto known = degrees.find(a.method);
    if (known == degrees.end())
        throw std::logic_error("no expected order for " + std::string(a.method));
    return known->second;
}

int derivative_of(const Approximation& a) { return static_cast<int>(a.quantity); }

std::string text(double order) {
    const std::string digits = std::to_string(order);
    return digits.substr(0, digits.find('.') + 3);
}

/// The first degree whose moment is wrong: the next one after `reproduced`, or on symmetric samples
/// the next one that symmetry does not cancel, which is of the parity of the derivative.
int first_wrong_degree(int reproduced, int derivative, bool symmetric) {
    const int next = reproduced + 1;
    return symmetric && (next - derivative) % 2 != 0 ? next + 1 : next;
}

Study::Series consistent(const Approximation& a, bool lattice_interior) {
    const int n = reproduced_degree(a), k = derivative_of(a);
    const int rough = first_wrong_degree(n, k, false) - k,
              even = first_wrong_degree(n, k, true) - k;
    const std::string reproduces =
        "reproduces degree " + std::to_string(n) + ", so derivative " + std::to_string(k) + " is ";
    if (lattice_interior)
        return {std::string(a.method),
                between(even - half, even + half,
                        reproduces + "of order " + std::to_string(rough) +
                            ", by symmetry of the lattice " + std::to_string(even) +
                            "; half an order tells whole ones apart")};
    const std::string range = rough == even ? "of order " + std::to_string(rough)
                                            : "of order " + std::to_string(rough) + ", up to " +
                                                  std::to_string(even) +
                                                  " as far as samples are nearly symmetric";
    return {std::string(a.method),
            between(rough - half, even + half,
                    reproduces + range + "; half an order tells whole ones apart")};
}

/// A method without enough consistency, h / spacing fixed: its first wrong moment never shrinks.
Study::Series inconsistent(const Approximation& a, bool lattice_interior) {
    const int k = derivative_of(a);
    const int wrong = first_wrong_degree(reproduced_degree(a), k, lattice_interior);
    const int order = wrong - k;
    const std::string why = "the moment of degree " + std::to_string(wrong) +
                            " is wrong by a share that depends on h/spacing alone";
    if (order == 0)
        return {std::string(a.method), between(-quarter, 2.0 + half, why + ": a floor"), true};
    return {std::string(a.method),
            between(order - half, order + half,
                    why + ", and derivative " + std::to_string(k) +
                        " divides it by h to the power " + std::to_string(-order))};
}

Study::Series growing(const Approximation& a, const Conditions& c) {
    const double alpha = c.support_exponent;
    const int k = derivative_of(a), wrong = reproduced_degree(a) + 1;
    const double noise = (1.0 - alpha) * (0.5 * c.dim + 1.0) + alpha * (wrong - k);
    const double smoothing = 2.0 * alpha;
    return {std::string(a.method),
            between(std::min(noise, smoothing) - quarter, std::max(noise, smoothing) + quarter,
                    "disorder leaves (spacing/h)^" + text(0.5 * c.dim + 1.0) + " h^" +
                        std::to_string(wrong - k) + ", order " + text(noise) +
                        ", smoothing h², order " + text(smoothing) +
                        "; the sum of both is in between, and a quarter tells halves apart")};
}

/// Whether the zeroth moment is right on a lattice: the volumes m/ρ normalise Eq. 3 where all are
/// equal. The value then errs by the second moment, which is smoothing, not a wrong sum.
bool is_normalised_by_volumes(const Approximation& a, bool lattice_interior) {
    return lattice_interior && a.method == "SPH Eq. 3";
}
}  // namespace

Study::Series expected_order(const Approximation& a, const Conditions& c) {
    if (c.support_exponent != 1.0) return growing(a, c);
    const bool lattice_interior = c.sampling == Sampling::lattice && c.region == Region::interior;
    if (is_normalised_by_volumes(a, lattice_interior))
        return {std::string(a.method),
                between(2 - half, 2 + half,
                        "equal volumes m/ρ normalise the sum and odd moments vanish: the second "
                        "moment h² is left; half an order tells whole ones apart")};
    const bool reproduces_enough = reproduced_degree(a) >= derivative_of(a);
    return reproduces_enough ? consistent(a, lattice_interior) : inconsistent(a, lattice_interior);
}

}  // namespace verification
