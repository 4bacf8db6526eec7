#pragma once

#include "benchmarks/framework/timing.h"
#include "verification/framework/approximation_errors.h"
#include "verification/framework/study.h"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace benchmarks {

/// How the error of one method, kernel and h/spacing changes with the spacing.
enum class Trend { falls, saturated, grows, unclear };
std::string_view name_of(Trend trend);

/// One method with one kernel, one h/spacing and one number of samples: what it costs, what it gives.
/// All times on one thread.
struct Candidate {
    std::string method, kernel;
    int dim;
    double support_in_spacings;
    int samples_per_metre;
    double mean_neighbours;
    double error;          // root mean square over the places, in the unit of the quantity
    double largest_error;  // of the same; NaN where an answer is missing
    std::size_t failures;  // places without an answer, or with a singular moment matrix; of ...
    std::size_t places;
    Trend trend;
    double search_s, volumes_s;  // per sample: neighbours; densities, if the method reads them
    Timing evaluation;           // per place
    std::optional<Timing> precomputation, application;  // per place
    bool on_front = false;  // no other candidate is as cheap per field and as accurate

    bool failed() const { return failures > 0 || !(error < HUGE_VAL); }
    /// Search, densities and evaluation, per place [s].
    double per_place_s() const { return search_s + volumes_s + evaluation.median_s; }
    /// The same for all samples of the unit square, or cube [s].
    double per_field_s() const { return per_place_s() * std::pow(samples_per_metre, dim); }
};

/// Over kernels, h/spacing and numbers of samples.
struct RatioRange {
    double median, lowest, highest;
};

/// adams2009 Sec. 3, 3.1: with shape functions computed once, MLS is "as efficient as" SPH. All times are
/// per place, of methods that were timed in turns on the same neighbours.
struct PrecomputedRatio {
    std::string method;
    RatioRange over_precomputed_sph;  // both as dot products: like with like
    RatioRange over_sph_sum;          // the dot products over the SPH sum evaluated anew
    double precomputation_in_sums;    // what the shape functions cost, in SPH sums; a median
    /// After so many evaluations the shape functions are paid back, against the same method evaluated anew,
    /// and against the SPH sum: their time over the time that each evaluation saves. Medians; infinite
    /// where nothing is saved.
    double pays_over_itself, pays_over_sph;
    /// On the first ratio: "holds" up to the noise, "does not hold", or, of SPH, "measure of the others".
    std::string verdict;
};

struct Frontier {
    verification::Quantity quantity;
    int dim;
    std::vector<Candidate> candidates;
    double noise;  // relative: 95 % of the A/A comparisons differ by less
    std::vector<PrecomputedRatio> precomputed;
    std::string finding;  // one sentence, from the numbers
};

/// The methods that measure_frontier compares, by their names.
std::vector<std::string> methods_compared(verification::Quantity quantity, int dim);

/// Measures all methods for one quantity: the test function of `dim`, 2 or 3, on jittered samples.
/// Errors do not depend on the number of threads, nor on the run. `between_steps`, called with a share
/// in [0, 1], may throw to end it.
Frontier measure_frontier(verification::Quantity quantity, int dim, verification::Effort effort,
                          const std::function<void(double)>& between_steps = {});

/// Of those that did not fail: neither cost(c) nor the error can be had lower without raising the
/// other. By ascending cost.
std::vector<std::size_t> pareto_front(const std::vector<Candidate>& candidates,
                                      const std::function<double(const Candidate&)>& cost);

/// Of every method that can be precomputed, over the SPH sum that was timed in turns with it.
std::vector<PrecomputedRatio> precomputed_ratios(const std::vector<Candidate>& candidates,
                                                 double noise);

/// "at 1e-02 MLS 2 is 40x cheaper than SPH Eq. 3": per field, at the smallest error of the series 1, 2, 5, 10
/// that SPH attains, and at ten times that, where most methods do; below `noise`, "cannot tell". Up to which
/// h/spacing and number of samples that was looked for, and what the others attain.
std::string finding_of(const std::vector<Candidate>& candidates, double noise);

}  // namespace benchmarks
