#include "verification/cases/manufactured_flow.h"
#include "verification/framework/registry.h"
#include "verification/reference_data/reference.h"

#include <cmath>

namespace manufactured_flow_claims {
namespace {
using namespace verification;

constexpr double support = 5.0;  // of one evaluation, in spacings
constexpr Source source{Paper::literature, "Negi and Ramachandran 2021"};

/// max |printed − ours| of the fields and of the force.
double error_of_fields(double sign) {
    using F = ManufacturedFlow;
    const Reference table("mms_fluid_periodic");
    double worst = 0.0;
    for (std::size_t k = 0; k < table.rows(); ++k) {
        const plumbline::Vec<2> x(table["x"][k], table["y"][k]);
        const double t = table["t"][k];
        const plumbline::Vec<2> v(table["u"][k], table["v"][k]),
            S(table["S_x"][k], table["S_y"][k]);
        worst = std::max({worst, (F::velocity(x, t) - v).norm(), (F::force(x, t) - sign * S).norm(),
                          std::abs(F::pressure(x, t) - table["p"][k])});
    }
    return worst;
}
double mean_error(double spacing, Term term) {
    return errors_of_term({.spacing = spacing, .support = support}, term).mean;
}
double moved_error(double spacing, std::uint64_t seed, Term term) {
    return errors_of_term({.spacing = spacing, .support = support, .jitter = 0.2, .seed = seed},
                          term)
        .mean;
}

constexpr auto smooths =
    "2: every sum smooths over h². ρ and the second moment of the sums miss 1 by 0.0004 each for 5 "
    "spacings, a tenth of the finest error, which takes as much of the last order; where h is a "
    "fifth of the box, terms of h⁴ take some of the first";

const Register claims_of_manufactured_flow{
    Claim{.id = "manufactured_flow.fields",
          .source = source,
          .says = "velocity, pressure and force of the manufactured flow, against the table",
          .bound = at_most(1e-12, "14 printed digits of numbers up to 10: 5e-13, and its rounding"),
          .measure = [] { return error_of_fields(1.0); },
          .sabotaged = [] { return error_of_fields(-1.0); }},
    Claim{.id = "manufactured_flow.averaged_pressure",
          .source = {Paper::adams2009, "Sec. 6.1"},
          .says = "one evaluation of the averaged pressure force over that of Eq. 51 on a lattice, "
                  "mean errors; with the 1/2 of the text half of the force is missing",
          .bound = between(1.0 - 1e-6, 1.0 + 1e-6,
                           "on a lattice all densities are one but for rounding, 1e-15: both "
                           "formulas are the same"),
          .measure =
              [] {
                  return mean_error(1.0 / 24, Term::averaged_pressure) /
                         mean_error(1.0 / 24, Term::pressure);
              },
          .sabotaged =
              [] {
                  return mean_error(1.0 / 24, Term::printed_averaged_pressure) /
                         mean_error(1.0 / 24, Term::pressure);
              },
          .erratum = 61},
    Study{
        .id = "manufactured_flow.one_evaluation_on_a_lattice",
        .source = source,
        .says = "what forces are off by on a lattice, given the exact fields; with half of the "
                "averaged pressure force, as printed, they do not converge",
        .quantity = "‖a − exact‖ [m/s²], ν = 1, over the spacing [m]",
        .spacing = {1.0 / 24, 1.0 / 32, 1.0 / 40, 1.0 / 48, 1.0 / 64},
        .seeds = 1,
        .series = {{"pressure, Eq. 51, mean", between(1.6, 2.2, smooths)},
                   {"pressure, largest", between(1.6, 2.2, smooths)},
                   {"viscosity of Brookshaw, mean", between(1.6, 2.2, smooths)},
                   {"viscosity of Brookshaw, largest", between(1.6, 2.2, smooths)},
                   {"averaged pressure as printed, mean", between(1.6, 2.2, smooths), false, true}},
        .errors =
            [](double d, std::uint64_t) {
                const ManufacturedSamples lattice{.spacing = d, .support = support};
                const TermErrors p = errors_of_term(lattice, Term::pressure),
                                 v = errors_of_term(lattice, Term::brookshaw);
                return std::vector{p.mean, p.largest, v.mean, v.largest,
                                   mean_error(d, Term::printed_averaged_pressure)};
            }},
    Study{
        .id = "manufactured_flow.one_evaluation_of_perturbed_points",
        .source = source,
        .says = "where particles are moved by up to 0.2 spacings, one evaluation is no better for "
                "finer spacings: the divergence is off by a share of itself, viscosity by more and "
                "more",
        .quantity = "mean |error| [1/s], [m/s²], over the spacing [m]",
        .spacing = {1.0 / 24, 1.0 / 32, 1.0 / 40, 1.0 / 48, 1.0 / 64},
        .seeds = 3,
        .series =
            {{"continuity",
              between(-0.25, 0.25,
                      "0: its sums are lopsided by what h/spacing decides, of first derivatives"),
              true},
             {"viscosity of Monaghan",
              between(
                  -1.3, -0.7,
                  "−1: first derivatives, times sums that are lopsided as 1/h and should cancel")},
             {"continuity without vᵢ",
              between(-0.25, 0.25, "a velocity, times sums that are lopsided as 1/h: −1"), true,
              true}},
        .errors =
            [](double d, std::uint64_t seed) {
                return std::vector{moved_error(d, seed, Term::continuity),
                                   moved_error(d, seed, Term::monaghan),
                                   moved_error(d, seed, Term::divergence_alone)};
            }},
    Study{.id = "manufactured_flow.error_over_spacing",
          .source = source,
          .says = "a flow that its force drives to the exact one converges, from a lattice and "
                  "from perturbed points, since particles move to where sums are less lopsided; "
                  "without the force not",
          .quantity = "mean ‖v − exact‖ / e^(−1/2), over the spacing [m]",
          .spacing = {1.0 / 12, 1.0 / 16, 1.0 / 20, 1.0 / 24, 1.0 / 32, 1.0 / 48},
          .seeds = 1,
          .series =
              {{"from a lattice",
                between(
                    0.8, 2.4,
                    "2: every sum smooths over h²; where particles lie irregularly, an error that "
                    "depends on h/spacing alone takes part of it, the more the finer the spacing")},
               {"moved by 0.2 spacings", between(0.8, 2.4, "as before")},
               {"without the force", between(0.8, 2.4, "another flow"), false, true}},
          .errors = [](double d, std::uint64_t) {
              return std::vector{errors_of_run({.spacing = d}).mean,
                                 errors_of_run({.spacing = d, .jitter = 0.2}).mean,
                                 errors_of_run({.spacing = d}, 0.0).mean};
          }}};
}  // namespace
}  // namespace manufactured_flow_claims
