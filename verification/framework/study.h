#pragma once

#include "verification/framework/claim.h"
#include "verification/framework/statistics.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace verification {

/// How fine and how often a study is sampled; `quick` is what continuous integration affords.
enum class Effort { quick, full };

/// A claim about a trend: error against spacing, drawn and tabulated in the convergence report.
struct Study {
    std::string id;
    Source source;
    std::string says;
    std::string quantity;         // what the error is of, with its unit: "gradient error, L2 [1/m]"
    std::vector<double> spacing;  // [m], coarse to fine; at least 4
    int quick_levels = 4;         // how many of them, from the coarse end, a quick run takes
    int seeds = 5;                // of the disordered samples; 1 where nothing is random

    struct Series {
        std::string name;
        Bound order;             // of error ~ spacing^order; its middle is the formal order
        bool saturates = false;  // the claim is instead that the error stops at a floor
        bool sabotaged = false;  // wrong on purpose: it must break its bound
    };
    std::vector<Series> series;
    /// The error of each series, in their order; NaN where the method gives no answer.
    /// A function of its arguments alone: two calls with the same ones give the same numbers.
    std::function<std::vector<double>(double spacing, std::uint64_t seed)> errors;
    std::vector<std::string> tags = {};
};

/// The verdict on a series whose errors follow `fit`.
/// - saturated: a floor, told from zero by its interval, makes up more than half of the finest error,
///   and the last step falls at less than half of the steepest rate; or the order is between -1/4
///   and 1/4, by its whole interval;
/// - verified, failed: the whole interval of the order is inside the bound, outside of it;
/// - not in asymptotic range: it straddles the bound, and the levels do not lie on a line; or it is
///   inside, but the last step leaves the bound. Finer levels are needed, more seeds would not help;
/// - inconclusive: it straddles the bound by the scatter of the seeds, or there are fewer than four
///   levels.
/// For a series that is to saturate, saturated becomes verified. For a sabotaged one, any breach of
/// the bound becomes verified, and holding it toothless.
Verdict judge(const Study::Series& series, const PowerLaw& fit);

struct SeriesResult {
    std::string name;
    Bound expected_order;
    bool expected_saturation;
    std::vector<std::vector<double>> errors;  // [level][seed]
    PowerLaw fit;
    Verdict verdict;
    bool sabotaged = false;
    int failures = 0;  // how many of the errors are not finite: the method gave no answer
};

/// The floor at which all series rest, if there are at least two and their floors agree within 10 %:
/// different methods do not err alike, so it is what they are compared with that is too coarse.
std::optional<double> common_floor(const std::vector<SeriesResult>& series);

struct StudyResult {
    Study study;
    std::vector<double> spacing;  // the levels that were run
    int seeds;
    std::vector<SeriesResult> series;
    double seconds;
    std::string error;    // what `errors` threw, if it did; then `series` is empty
    std::string warning;  // set if the reference is too coarse; then every verdict is inconclusive
};

/// Runs every level and seed, and fits the order of each series. Never throws.
StudyResult run(const Study& study, Effort effort);

}  // namespace verification
