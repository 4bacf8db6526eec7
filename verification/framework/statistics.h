#pragma once

#include <optional>
#include <span>
#include <vector>

namespace verification {

struct Interval {
    double low, high;
    bool contains(double x) const { return low <= x && x <= high; }
};

/// Of the finite values; NaN if there are none.
double median(std::vector<double> values);

/// The error law e = C h^order, by least squares of log e over log h. Every level counts once, with
/// the mean of log e over its seeds.
///
/// `confidence`, the 95 % interval of the order, is the wider one of two Student intervals.
/// 1. `misfit`: from the residuals of the levels, with n − 2 degrees of freedom. All seeds of a level
///    share its distance from the line (the law bends, a floor comes near), so to count each seed as
///    a replicate of its own would promise a certainty that more seeds cannot give.
/// 2. `scatter`: from the spread of the seeds within each level (Welch, Satterthwaite). A lucky set
///    of residuals must not hide it. Zero where nothing is random: one seed per level.
/// Resampling would be no better: five seeds and four levels are too few for a bootstrap to cover
/// what it promises.
///
/// `floor` is e∞ of the law e = C hᵖ + e∞, C ≥ 0, 1/4 ≤ p ≤ 6, fitted to the levels in relative
/// error, 0 if none is found or the error grows; `floor_confidence` its 95 % interval, by deleting
/// one seed after the other (jackknife).
struct PowerLaw {
    double order;
    Interval confidence, misfit, scatter;
    bool lack_of_fit;  // the levels are further off the line than their seeds explain (F test, 5 %)
    double floor;
    Interval floor_confidence;
    std::vector<double> spacing;       // the levels that gave an error, coarse to fine ...
    std::vector<double> error;         // ... and the geometric mean of their errors
    std::vector<double> local_orders;  // between successive levels ...
    Interval last_step;                // ... and the 95 % interval of the last, by the seeds
    /// How far the finest error may be from its limit, in the unit of the error: Roache's
    /// Fs |e₁ − e₂| / (rᵖ − 1). If the error does not fall throughout, half of the spread of all
    /// levels times Fs = 3 (Stern et al. 2001; Logan & Nitta 2005). NaN below three levels.
    double grid_convergence_index;
    double safety_factor;  // Fs: 1.25, or 3 where the last local order is outside [1/2, 2 formal]
};

/// An error that falls more slowly does not fall; one that grows faster does not rest on a floor.
inline constexpr double flat_order = 0.25;

/// `spacing`: n ≥ 2 levels, coarse to fine. `errors[level][seed]`: values that are not positive and
/// finite are left out. `formal_order`: what theory expects; the fitted order where it is not given.
/// Throws InvalidInput if fewer than two levels have a sample, if the lengths differ, or if the
/// spacing does not fall.
PowerLaw fit_power_law(std::span<const double> spacing,
                       const std::vector<std::vector<double>>& errors,
                       std::optional<double> formal_order = {});

}  // namespace verification
