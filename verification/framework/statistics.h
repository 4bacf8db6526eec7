#pragma once

#include <span>
#include <vector>

namespace verification {

struct Interval {
    double low, high;
    bool contains(double x) const { return low <= x && x <= high; }
};

double median(std::vector<double> values);

/// The error law e = C h^order fitted to all (level, seed) samples, by least squares in log-log;
/// `confidence` is the 95 % interval of the order: Student's t on the residuals with one
/// replicate per seed.
/// `floor` is e∞ of the law e = C hᵖ + e∞ fitted to the medians of the levels (0 if none is found).
struct PowerLaw {
    double order;
    Interval confidence;
    double floor;
    std::vector<double> local_orders;  // between successive levels, from the medians
    double grid_convergence_index;     // of the finest level, relative (Roache); NaN where undefined
};

/// `spacing`: n ≥ 2 levels, coarse to fine. `errors[level][seed]`: at least one per level; values
/// that are not finite are left out. Throws InvalidInput if fewer than two levels have a sample.
PowerLaw fit_power_law(std::span<const double> spacing,
                       const std::vector<std::vector<double>>& errors);

}  // namespace verification
