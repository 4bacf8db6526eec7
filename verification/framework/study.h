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
        Bound order;             // of error ~ spacing^order
        bool saturates = false;  // the claim is that the error stops at a floor
    };
    std::vector<Series> series;
    /// The error of each series, in their order; NaN where the method gives no answer.
    /// A function of its arguments alone: two calls with the same ones give the same numbers.
    std::function<std::vector<double>(double spacing, std::uint64_t seed)> errors;
    std::vector<std::string> tags = {};
};

struct SeriesResult {
    std::string name;
    Bound expected_order;
    bool expected_saturation;
    std::vector<std::vector<double>> errors;  // [level][seed]
    PowerLaw fit;
    Verdict verdict;
};

struct StudyResult {
    Study study;
    std::vector<double> spacing;  // the levels that were run
    int seeds;
    std::vector<SeriesResult> series;
    double seconds;
    std::string error;  // what `errors` threw, if it did; then `series` is empty
};

/// Runs every level and seed, and fits the order of each series. Never throws.
StudyResult run(const Study& study, Effort effort);

}  // namespace verification
