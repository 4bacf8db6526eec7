#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <algorithm>
#include <cmath>

namespace other_programs_claims {
namespace {
using namespace verification;
using Row = ReferenceRow;

/// How many rows of the audit name a number that Ghia's table does not have at that place.
double audit_rows_without_source(double shift) {
    const Reference audit("ghia_audit"), u("ghia_1982_u_centreline"), v("ghia_1982_v_centreline");
    double missing = 0;
    for (std::size_t i = 0; i < audit.rows(); ++i) {
        const bool is_u = audit.text("component")[i] == "u";
        const Reference& table = is_u ? u : v;
        const auto& place = table[is_u ? "y" : "x"];
        const auto& value = table["Re" + audit.text("Re")[i]];
        bool found = false;
        for (std::size_t k = 0; k < place.size(); ++k)  // k/128, printed with four digits
            found = found || (std::abs(place[k] + shift - audit["position"][i]) < 1e-4 &&
                              value[k] == audit["ghia_1982"][i]);
        missing += !found;
    }
    return missing;
}
double audit_difference(double sign) {
    return worst_difference(
        Reference("ghia_audit"), "difference",
        [=](const Row& r) { return sign * (r("ghia_1982") - r("recomputed")); }, 1.0);
}

/// The root mean square of printed − recomputed v at Re 1000.
double scatter_of_v() {
    const Reference audit("ghia_audit");
    double squares = 0, n = 0;
    for (std::size_t i = 0; i < audit.rows(); ++i) {
        if (audit["Re"][i] != 1000 || audit.text("component")[i] != "v") continue;
        squares += std::pow(audit["ghia_1982"][i] - audit["recomputed"][i], 2);
        ++n;
    }
    return std::sqrt(squares / n);
}

double peer_ratios(double offset) {
    const Reference plate("peer_trixi_hydrostatic_plate"), beam("peer_trixi_csm3");
    const double of_plate = worst_difference(
        plate, "rel_error",
        [=](const Row& r) { return r("mean_deflection") / r("analytic") - offset; }, 1.0);
    double of_orders = 0;
    for (std::size_t i = 1; i < beam.rows(); ++i) {
        const auto& error = beam["frequency_rel_error"];
        const double order = std::log2(std::abs(error[i - 1] / error[i]));
        of_orders = std::max(of_orders, std::abs(order - beam["order_of_frequency_error"][i]));
    }
    return std::max(of_plate, of_orders);
}

/// Steps of refinement on which the period does not grow.
double periods_that_shrink(bool backwards) {
    const Reference table("oscillating_plate_period_fem");
    double wrong = 0;
    for (const char* column : {"T1", "T2"})
        for (std::size_t i = 1; i < table.rows(); ++i) {
            if (table["H"][i] != table["H"][i - 1]) continue;
            const double growth = table[column][i] - table[column][i - 1];
            wrong += (backwards ? -growth : growth) <= 0;
        }
    return wrong;
}

const Register claims_of_other_programs{
    Erratum{45,
            {Paper::plumbline, "catalogue of cases, lid-driven cavity"},
            "Ghia's v at Re 1000 is off by an rms of 0.002 to 0.004",
            "by 0.0093; 0.002 to 0.004 holds for the other centre lines but one"},
    Claim{.id = "reference_data.ghia_audit_scatter_of_v",
          .source = {Paper::literature, "Ghia, Ghia and Shin 1982, Table II"},
          .says = "the printed v at Re 1000 are off the recomputed ones by an rms of 0.0093",
          .bound = between(0.00925, 0.00935,
                           "0.0093 to its two digits; the numbers of the table have five"),
          .measure = scatter_of_v,
          .sabotaged = [] { return 0.004; },
          .erratum = 45},
    Claim{.id = "reference_data.ghia_audit_quotes_ghia",
          .source = {Paper::literature, "Ghia, Ghia and Shin 1982"},
          .says = "each printed number that the audit names stands in the table, at that place",
          .bound = at_most(0, "a count of rows"),
          .measure = [] { return audit_rows_without_source(0); },
          .sabotaged = [] { return audit_rows_without_source(0.01); }},
    Claim{
        .id = "reference_data.ghia_audit_difference",
        .source = {Paper::literature, "Ghia, Ghia and Shin 1982"},
        .says = "difference = printed − recomputed",
        .bound = at_most(1.1e-6, "six decimals in the recomputed column, six digits in the other"),
        .measure = [] { return audit_difference(1); },
        .sabotaged = [] { return audit_difference(-1); }},
    Claim{.id = "reference_data.peer_ratios",
          .source = {Paper::literature, "TrixiParticles.jl"},
          .says = "relative errors and observed orders follow from the columns beside them",
          .bound = at_most(1e-4,
                           "deflections with 5 digits: 2 · 5e-6; frequencies with 5 digits: "
                           "2 · 5e-5/1.4 / ln 2"),
          .measure = [] { return peer_ratios(1); },
          .sabotaged = [] { return peer_ratios(0); }},
    Claim{
        .id = "reference_data.fem_period_from_below",
        .source = {Paper::literature, "Rayleigh's principle"},
        .says = "nested finite elements are too stiff: every refinement lengthens the period",
        .bound = at_most(0, "a count of refinements; a larger space lowers the Rayleigh quotient"),
        .measure = [] { return periods_that_shrink(false); },
        .sabotaged = [] { return periods_that_shrink(true); }},
};
}  // namespace
}  // namespace other_programs_claims
