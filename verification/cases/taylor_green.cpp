#include "verification/cases/taylor_green.h"

#include "verification/framework/registry.h"

namespace taylor_green_claims {
namespace {
using namespace verification;

double error_of_energy(double shifting) {
    return std::abs(simulate({.spacing = 1.0 / 16.0, .shifting = shifting}, 0.5).energy);
}

double error_when_projected(double shifting) {
    return simulate_incompressible(
               {.spacing = 1.0 / 24.0, .shifting = shifting, .support = 4.0, .courant = 0.4}, 0.5)
        .velocity;
}

const Register claims_of_taylor_green{
    Claim{.id = "taylor_green.energy",
          .source = {Paper::literature, "Taylor and Green 1937"},
          .says = "kinetic energy at Re = 100, t = 0.5 with 16² particles, relative error; without "
                  "shifting, "
                  "particles clump along streamlines",
          .bound = at_most(0.05,
                           "the target is a tenth of what a public solver keeps as its reference, "
                           "50 % with 100² particles"),
          .measure = [] { return error_of_energy(20.0); },
          .sabotaged = [] { return error_of_energy(0.0); }},
    Claim{.id = "taylor_green.projected",
          .source = {Paper::plumbline, "docstring of ZeroDivergence"},
          .says =
              "mean velocity error at Re = 100, t = 0.5 with 24² particles, by pressures of either "
              "sign that keep the "
              "divergence zero, with shifting; DFSPH, whose pressures only push, loses the flow",
          .bound = at_most(0.1, "the target: a tenth of the largest speed, with 75 steps"),
          .measure = [] { return error_when_projected(20.0); },
          .sabotaged = [] { return error_when_projected(0.0); }},
    Study{.id = "taylor_green.error_over_spacing",
          .source = {Paper::literature, "Taylor and Green 1937"},
          .says = "continuity with diffusion and shifting converges; without shifting it does not",
          .quantity =
              "mean ‖v − exact‖ / largest exact speed at t = 0.5, Re = 100, over the spacing [m]",
          .spacing = {1.0 / 12, 1.0 / 16, 1.0 / 20, 1.0 / 24, 1.0 / 32, 1.0 / 48},
          .seeds = 1,
          .series = {{"shifted", between(0.8, 2.4,
                                         "2: every sum smooths over h²; where particles lie "
                                         "irregularly, an error that depends on h/spacing "
                                         "alone takes part of it")},
                     {"not shifted", between(0.8, 2.4, "as before, were it not for the clumps"),
                      false, true}},
          .errors = [](double spacing, std::uint64_t) {
              return std::vector{simulate({.spacing = spacing, .shifting = 20.0}, 0.5).velocity,
                                 simulate({.spacing = spacing, .shifting = 0.0}, 0.5).velocity};
          }}};
}  // namespace
}  // namespace taylor_green_claims
