#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace publications_claims {
namespace {
using namespace verification;

/// ∫₀¹ of a cubic spline through the points, whose places fall from 1 to 0.
double integral(std::vector<double> place, std::vector<double> value) {
    std::ranges::reverse(place);
    std::ranges::reverse(value);
    const std::unique_ptr<gsl_spline, void (*)(gsl_spline*)> spline(
        gsl_spline_alloc(gsl_interp_cspline, place.size()), gsl_spline_free);
    gsl_spline_init(spline.get(), place.data(), value.data(), place.size());
    return gsl_spline_eval_integ(spline.get(), 0, 1, nullptr);
}

/// The largest flow through the vertical centre line of the closed cavity, in lid speeds, over all
/// columns of Table I.
double net_flow_of_u(double corrected) {
    const Reference table("ghia_1982_u_centreline");
    double worst = 0;
    for (const char* column : {"Re100", "Re400", "Re1000", "Re3200", "Re5000"}) {
        std::vector<double> velocity = table[column];
        std::ranges::replace(velocity, -0.86636, corrected);
        worst = std::max(worst, std::abs(integral(table["y"], velocity)));
    }
    return worst;
}
/// The flow through the horizontal one at Re 400, of the printed numbers of Table II less that of the
/// recomputed ones, so that what the spline adds is the same and cancels.
double flow_of_errors_of_v(double corrected) {
    const Reference audit("ghia_audit");
    std::vector<double> place, printed, recomputed;
    for (std::size_t i = 0; i < audit.rows(); ++i) {
        if (audit["Re"][i] != 400 || audit.text("component")[i] != "v") continue;
        place.push_back(audit["position"][i]);
        printed.push_back(audit["ghia_1982"][i]);
        recomputed.push_back(audit["recomputed"][i]);
    }
    std::ranges::replace(printed, -0.23827, corrected);
    return std::abs(integral(place, printed) - integral(place, recomputed));
}

/// Places where the quantiles are not in order.
double quantiles_out_of_order(const char* low, const char* high) {
    double wrong = 0;
    for (const char* sensor : {"p1", "p2", "p3", "p4"}) {
        const Reference table("lobovsky_2014_" + std::string(sensor) + "_H300");
        for (std::size_t i = 0; i < table.rows(); ++i)
            wrong +=
                !(table[low][i] <= table["p_median"][i] && table["p_median"][i] <= table[high][i]);
    }
    return wrong;
}

/// The largest dZ/dT between neighbouring points, with `unit` times the unit of time of the file.
double fastest_front(double unit) {
    double fastest = 0;
    const Reference table("martin_moyce_1952_n2_2_front");
    for (std::size_t i = 1; i < table.rows(); ++i)
        fastest = std::max(fastest, (table["Z"][i] - table["Z"][i - 1]) /
                                        (table["T"][i] - table["T"][i - 1]) * unit);
    return fastest;
}

double sloshing_frequency_error(double depth) {
    const double k = std::numbers::pi / 0.5;
    const double omega = std::sqrt(9.81 * k * std::tanh(k * depth));
    const Reference table("bauerlein_avila_2021_sloshing_decay");
    const auto row = std::ranges::find(table.text("quantity"), "omega1_potential_theory_here") -
                     table.text("quantity").begin();
    return std::abs(table["value"][static_cast<std::size_t>(row)] - omega);
}

const Register claims_of_publications{
    Erratum{43,
            {Paper::literature, "Ghia, Ghia and Shin 1982, Table I"},
            "u(y = 0.4531) = −0.86636 at Re 3200",
            "−0.086636: a digit is lost, and the closed cavity would lose 11 % of the lid's flow"},
    Erratum{44,
            {Paper::literature, "Ghia, Ghia and Shin 1982, Table II"},
            "v(x = 0.9063) = −0.23827 at Re 400",
            "−0.3899: the neighbours are −0.22847 and −0.44993, and the cavity is closed"},
    Claim{.id = "reference_data.ghia_u_conserves_mass",
          .source = {Paper::literature, "Ghia, Ghia and Shin 1982, Table I"},
          .says = "no net flow through the closed cavity, once a misprint is put right: "
                  "u(0.4531) at Re 3200 is −0.086636, not −0.86636",
          .bound = at_most(0.0074,
                           "the spline's integral of the recomputed values of ghia_audit is off by "
                           "0.0009 at most, and of the printed u none is by more than 0.0065"),
          .measure = [] { return net_flow_of_u(-0.086636); },
          .sabotaged = [] { return net_flow_of_u(-0.86636); },
          .erratum = 43},
    Claim{.id = "reference_data.ghia_v_conserves_mass",
          .source = {Paper::literature, "Ghia, Ghia and Shin 1982, Table II"},
          .says = "the printed numbers carry no more flow than recomputed ones, once a misprint is "
                  "put right: v(0.9063) at Re 400 is −0.3899, not −0.23827",
          .bound = at_most(0.0062,
                           "no other number at Re 400 is off by more than 0.0062, and the weights "
                           "of the spline add up to 1"),
          .measure = [] { return flow_of_errors_of_v(-0.3899); },
          .sabotaged = [] { return flow_of_errors_of_v(-0.23827); },
          .erratum = 44},
    Claim{.id = "reference_data.lobovsky_quantiles",
          .source = {Paper::literature, "Lobovsky et al. 2014"},
          .says = "2.5 % ≤ median ≤ 97.5 % at every instant of the four sensors",
          .bound = at_most(0, "a count of instants"),
          .measure = [] { return quantiles_out_of_order("p_2.5pct", "p_97.5pct"); },
          .sabotaged = [] { return quantiles_out_of_order("p_97.5pct", "p_2.5pct"); }},
    Claim{.id = "reference_data.martin_moyce_below_ritter",
          .source = {Paper::literature, "Martin and Moyce 1952; Ritter 1892"},
          .says = "the front is never faster than 2√(gH), in the units of the file dZ/dT = 2",
          .bound = at_most(2, "Ritter's front without friction and vertical acceleration"),
          .measure = [] { return fastest_front(1); },
          .sabotaged = [] { return fastest_front(std::sqrt(2.0)); }},
    Claim{.id = "reference_data.sloshing_frequency",
          .source = {Paper::literature, "Bauerlein and Avila 2021"},
          .says = "ω = √(g k tanh kh) with k = π/0.5 m, h = 0.4 m",
          .bound = at_most(5.1e-6, "six printed digits"),
          .measure = [] { return sloshing_frequency_error(0.4); },
          .sabotaged = [] { return sloshing_frequency_error(HUGE_VAL); }},
};
}  // namespace
}  // namespace publications_claims
