#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <gsl/gsl_cdf.h>

#include <cmath>

namespace docking_bands_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;

/// The smallest k with at most k of n independent events at least as likely as `share`.
double binomial_quantile(double share, double p, double n) {
    unsigned k = 0;
    while (gsl_cdf_binomial_P(k, p, static_cast<unsigned>(n)) < share) ++k;
    return k;
}

/// P of an event in time T with a constant rate, composed of `steps` steps.
double exponential(double rate_times_time) { return -std::expm1(-rate_times_time); }
double linear_in_ten_steps(double rate_times_time) {
    return 1 - std::pow(1 - rate_times_time / 10, 10);
}

double bands(double (*probability)(double)) {
    const Reference table("poisson_docking_bands");
    const auto P = [=](const Row& r) { return probability(r("lambda_T")); };
    const auto quantile = [=](double share) {
        return [=](const Row& r) { return binomial_quantile(share, P(r), r("N")); };
    };
    return std::max(
        {worst_difference(table, "P", P),
         worst_difference(table, "expected", [=](const Row& r) { return r("N") * P(r); }),
         worst_difference(table, "q0.5_percent", quantile(0.005), 1.0),
         worst_difference(table, "q99.5_percent", quantile(0.995), 1.0)});
}

const Register claims_of_docking_bands{
    Claim{.id = "reference_data.docking_bands",
          .source = {Paper::wicke2006, "Eq. 15; Sec. 4.2"},
          .says = "P = 1 − exp(−λT), and the band that holds 99 % of the counts of N sites",
          .bound = at_most(rounding_to(10), "10 printed digits; counts are whole and equal"),
          .measure = [] { return bands(exponential); },
          .sabotaged = [] { return bands(linear_in_ten_steps); }},
};
}  // namespace
}  // namespace docking_bands_claims
