#include "verification/framework/expected_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace verification {

namespace {
/// How far a fitted order may be from the asymptotic one, for a reason.
struct Slack {
    double down, up;
    std::string why;
};

// A share s of another order in the error of the coarsest level, gone at the finest, a factor 3 below
// or more, moves the fit by s / log 3 at most. k h < 2 at the coarsest level of all studies, k the wave
// number of the test function (25/m in the plane); the even moments of poly6 let Taylor's next term be
// (k h)² / 48 of the one before. With one-sided odd moments it is about k h / 6.
constexpr double next_even_term = 0.2, next_odd_term = 0.3;
// As large as the first one: log 2 / log 3; where both add in squares, half of that.
constexpr double next_as_large = 0.65, next_as_large_in_squares = 0.35;

/// How far the last step may be off by the choice of places. 2000 squared errors (in space 1000) that
/// vary by twice their mean give a level's error to 2.2 % (3.2 %), the step of a factor 1.5 (1.27)
/// between two levels to 0.08 (0.19). The largest of 400 errors scatters by some 10 %: 0.3.
double scatter(const Conditions& c) {
    if (c.norm == Norm::max) return 0.3;
    return c.dim == 3 ? 0.2 : 0.1;
}

std::string text(double order) {
    std::string digits = std::to_string(order);
    digits.resize(digits.find('.') + 3);
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
    return digits == "-0" ? "0" : digits;
}

std::string and_scatter(const Conditions& c) {
    return text(scatter(c)) + " for the scatter of a step";
}

Slack inside(const Conditions& c) {
    const double slack = next_even_term + scatter(c);
    return {slack, slack,
            "the next term is under a fifth of the error at the coarsest level, " +
                text(next_even_term) + ", and " + and_scatter(c)};
}

Slack one_sided(const Conditions& c) {
    const double slack = next_odd_term + scatter(c);
    return {
        slack, slack,
        "samples on one side let the next term, one order of h smaller, be a third of the error "
        "at the coarsest level, " +
            text(next_odd_term) + ", and " + and_scatter(c)};
}

Slack from_above(const Conditions& c) {
    return {next_even_term + scatter(c), next_as_large + scatter(c),
            "the next moment is one order of h better, and as large at the coarsest level: " +
                text(next_as_large) + " upwards, " + text(next_even_term) + " downwards, and " +
                and_scatter(c)};
}

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

Study::Series series(const Approximation& a, double low, double high, const Slack& slack,
                     const std::string& why) {
    return {std::string(a.method),
            between(low - slack.down, high + slack.up, why + "; " + slack.why)};
}

/// An error that does not fall. The bound is what a sabotaged series in its place must break: any order.
Study::Series at_rest(const Approximation& a, const std::string& why) {
    constexpr double highest = 2.5;
    return {std::string(a.method), between(-flat_order, highest, why + ": a floor"), true};
}

/// The first degree whose moment is wrong: the next one after `reproduced`, or on symmetric samples
/// the next one that symmetry does not cancel, which is of the parity of the derivative.
int first_wrong_degree(int reproduced, int derivative, bool symmetric) {
    const int next = reproduced + 1;
    return symmetric && (next - derivative) % 2 != 0 ? next + 1 : next;
}

/// Whether samples lie symmetrically around the places where errors are measured.
bool is_symmetric(const Conditions& c) {
    return c.sampling == Sampling::lattice && c.region == Region::interior &&
           c.measured_at == MeasuredAt::samples;
}

/// At a boundary: how many orders the places that feel both sides are better.
double better_inside(const Conditions& c, int rough, int even) {
    if (c.region == Region::interior || rough == even) return 0.0;
    // In space the rim of one support is nearly all of the box, at the coarsest level.
    return c.dim == 3 ? 1.0 : 0.5;
}

Study::Series consistent(const Approximation& a, const Conditions& c) {
    const int n = reproduced_degree(a), k = derivative_of(a);
    const int rough = first_wrong_degree(n, k, false) - k,
              even = first_wrong_degree(n, k, true) - k;
    const std::string why = "reproduces degree " + std::to_string(n) + ", so derivative " +
                            std::to_string(k) + " is of order " + std::to_string(rough);
    if (is_symmetric(c))
        return series(a, even, even, inside(c),
                      why + ", by symmetry of the lattice " + std::to_string(even));
    if (c.region == Region::boundary) {
        const double better = better_inside(c, rough, even);
        return series(a, rough, rough + better, one_sided(c),
                      better == 0.0 ? why
                                    : why + ", up to " + text(better) +
                                          " better by places that feel both sides");
    }
    if (rough == even) return series(a, rough, rough, inside(c), why);
    return series(a, rough, even, inside(c),
                  why + " by odd moments, which are small, and of order " + std::to_string(even) +
                      " by even ones: the order of the sum is in between");
}

/// A method without enough consistency, h / spacing fixed: its first wrong moment never shrinks.
Study::Series inconsistent(const Approximation& a, const Conditions& c) {
    const int k = derivative_of(a);
    const int wrong = first_wrong_degree(reproduced_degree(a), k, is_symmetric(c));
    const std::string why = "the moment of degree " + std::to_string(wrong) +
                            " is wrong by a share that depends on h/spacing alone";
    if (wrong == k) return at_rest(a, why);
    return series(a, wrong - k, wrong - k, from_above(c),
                  why + ", and derivative " + std::to_string(k) + " divides it by h to the power " +
                      std::to_string(k - wrong));
}

/// At a boundary the moments are wrong however many samples there are.
Study::Series growing_at_boundary(const Approximation& a, const Conditions& c) {
    const int k = derivative_of(a), wrong = reproduced_degree(a) + 1;
    const std::string why = "on one side the moment of degree " + std::to_string(wrong) +
                            " is wrong however many samples there are: h^" +
                            std::to_string(wrong - k);
    if (wrong == k) return at_rest(a, why);
    const double order = c.support_exponent * (wrong - k);
    const double odd = c.support_exponent * next_odd_term;
    const Slack slack{odd + scatter(c), odd + next_as_large_in_squares + scatter(c),
                      "the next term is one order of h below and up to a third of the error at the "
                      "coarsest level, " +
                          text(odd) +
                          "; disorder falls faster, adds in squares and may be as large "
                          "there, " +
                          text(next_as_large_in_squares) + " upwards; and " + and_scatter(c)};
    return series(a, order, order, slack, why + ", order " + text(order));
}

/// The power of h in the error of infinitely many samples: then a method is a convolution, which
/// commutes with derivatives, and its odd moments vanish; that of SPH is normalised then.
int smoothing_power(int reproduced) { return std::max(2, (reproduced + 2) / 2 * 2); }

/// What disorder leaves of the sums, and what smoothing leaves.
Study::Series growing(const Approximation& a, const Conditions& c) {
    const double alpha = c.support_exponent;
    const int n = reproduced_degree(a), k = derivative_of(a), power = smoothing_power(n);
    const double smoothing = alpha * power;
    const std::string smooths =
        "smoothing h^" + std::to_string(power) + ", order " + text(smoothing);
    const bool lattice = c.sampling == Sampling::lattice;
    if (lattice && k > 0)
        throw std::logic_error("no order of derivatives on a lattice with a growing support");
    if (lattice || n + 1 - k == power) return series(a, smoothing, smoothing, inside(c), smooths);
    const double averaging = 0.5 * c.dim + 1.0;
    const double noise = (1.0 - alpha) * averaging + alpha * (n + 1 - k);
    return series(a, std::min(noise, smoothing), std::max(noise, smoothing), inside(c),
                  "disorder leaves (spacing/h)^" + text(averaging) + " h^" +
                      std::to_string(n + 1 - k) + ", order " + text(noise) + ", " + smooths +
                      ": the sum of both is in between");
}

/// The zeroth moment is right on a lattice: the volumes m/ρ normalise Eq. 3 where all are equal. The
/// value then errs by the second moment, which is smoothing, not a wrong sum.
bool is_normalised_by_volumes(const Approximation& a, const Conditions& c) {
    return is_symmetric(c) && a.method == "SPH Eq. 3";
}
}  // namespace

Study::Series expected_order(const Approximation& a, const Conditions& c) {
    if (c.support_exponent != 1.0)
        return c.region == Region::boundary ? growing_at_boundary(a, c) : growing(a, c);
    if (is_normalised_by_volumes(a, c))
        return series(a, 2, 2, inside(c),
                      "equal volumes m/ρ normalise the sum and odd moments vanish: the second "
                      "moment h² is left");
    const bool reproduces_enough = reproduced_degree(a) >= derivative_of(a);
    return reproduces_enough ? consistent(a, c) : inconsistent(a, c);
}

}  // namespace verification
