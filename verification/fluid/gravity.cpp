#include "solver/fluid/gravity.h"

#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"
#include "verification/framework/registry.h"

namespace gravity_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// |x(n) − g Δt² n (n + 1) / 2| of a particle that falls from rest.
double error_of_fall(bool with_gravity) {
    const int steps = 100;
    const double dt = 1e-3;
    Scene scene{Given<Positions<2>, Velocities<2>>{},
                Gravity<2>{with_gravity ? Vec<2>(0.0, -9.81) : Vec<2>(0.0, 0.0)},
                SymplecticEuler<2>{}};
    scene.get<Positions<2>>().assign(1, Vec<2>::Zero());
    scene.get<Velocities<2>>().assign(1, Vec<2>::Zero());
    for (int n = 0; n < steps; ++n) scene.step(dt);
    const double expected = -9.81 * dt * dt * steps * (steps + 1) / 2;
    return std::abs(scene.get<Positions<2>>()[0].y() - expected);
}

const Register claims_of_gravity{
    Claim{.id = "gravity.free_fall",
          .source = {Paper::adams2009, "Eqs. 44, 58, 59"},
          .says = "after n steps from rest, x = g Δt² n (n + 1) / 2; Algorithm 5 leaves external "
                  "forces out",
          .bound = at_most(1e-14,
                           "200 roundings of numbers up to 1: x by 7e-18, v by 1.1e-16 "
                           "each, of which Δt enters x up to 100 times: 100 · 100 · 1e-19"),
          .measure = [] { return error_of_fall(true); },
          .sabotaged = [] { return error_of_fall(false); },
          .erratum = 31},
    Erratum{31,
            {Paper::adams2009, "Alg. 5"},
            "no external force; \"if ρᵢ < 0\" in the scan",
            "aᵢ += fₑ/ρᵢ; the test is pᵢ < 0"}};
}  // namespace
}  // namespace gravity_claims
