#include "solver/scene/symplectic_euler.h"

#include "verification/framework/registry.h"
#include "verification/scene/oscillator.h"

namespace symplectic_euler_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Position first, with the old velocity: explicit Euler, as the text calls Eqs. 58, 59.
struct ExplicitEuler {
    using Reads = Quantities<>;
    using Writes = Quantities<Positions<2>, Velocities<2>, Accelerations<2>>;
    void run(double dt, Positions<2>& x, Velocities<2>& v, Accelerations<2>& a) const {
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += dt * v[i];
            v[i] += dt * a[i];
            a[i].setZero();
        }
    }
};
template <class Integrator = SymplecticEuler<2>> auto oscillator(double d = 0.0) {
    return Scene{StartOfOscillator{}, Spring{d}, Integrator{}};
}

/// max |x² + v² − Δt x v − 1| over 1000 steps of 0.1.
template <class Integrator> double change_of_invariant() {
    const double dt = 0.1;
    double worst = 0.0;
    oscillate(oscillator<Integrator>(), dt, 1000, [&](double x, double v) {
        worst = std::max(worst, std::abs(x * x + v * v - dt * x * v - 1.0));
    });
    return worst;
}
/// The quantity that decays by its own rate, dq/dt = −q.
struct Decay {
    using Reads = Quantities<Density>;
    using Writes = Quantities<Rate<Density>>;
    void run(double, const Density& q, Rate<Density>& rate) const { rate[0] -= q[0]; }
};
double decayed(double rate) {
    Scene scene{Given<Positions<2>, Velocities<2>, Density>{}, Decay{},
                SymplecticEuler<2, Density>{}};
    scene.get<Positions<2>>().assign(1, Vec<2>::Zero());
    scene.get<Velocities<2>>().assign(1, Vec<2>::Zero());
    scene.get<Density>().assign(1, 1.0);
    for (int n = 0; n < 10; ++n) scene.step(0.25);
    return std::abs(scene.get<Density>()[0] / std::pow(1.0 - rate * 0.25, 10) - 1.0);
}

const Register claims_of_symplectic_euler{
    Claim{
        .id = "symplectic_euler.keeps_its_invariant",
        .source = {Paper::adams2009, "Eqs. 58, 59; Sec. 6.4"},
        .says =
            "x² + v² − Δt x v of an oscillator is constant: the energy errs by O(Δt), for ever; by "
            "explicit Euler, as the text calls it, the oscillator gains energy",
        .bound = at_most(2e-12,
                         "1000 steps of 4 roundings of numbers up to 1, in x and v: "
                         "1000 · 2 · 4 · 1.1e-16, twice for the squares"),
        .measure = change_of_invariant<SymplecticEuler<2>>,
        .sabotaged = change_of_invariant<ExplicitEuler>,
        .erratum = 37},
    Claim{
        .id = "symplectic_euler.stable_below_the_limit",
        .source = {Paper::plumbline, "docstring of SymplecticEuler"},
        .says = "max ‖(x, v)‖ over 10000 steps with ω Δt = 1.99; with 2.01 it grows without limit",
        .bound = at_most(15.0,
                         "the invariant is (x − v)² at its weakest, times 1 − Δt/2 = 0.005: "
                         "‖(x, v)‖² ≤ 1 / 0.005"),
        .measure = [] { return largest_swing(oscillator(), 1.99, 10000); },
        .sabotaged = [] { return largest_swing(oscillator(), 2.01, 10000); }},
    Claim{.id = "symplectic_euler.advances_other_quantities",
          .source = {Paper::plumbline, "docstring of SymplecticEuler"},
          .says = "q(t + Δt) = q + Δt dq/dt: with dq/dt = −q, ten steps give (1 − Δt)¹⁰",
          .bound = at_most(2e-15, "10 steps of one rounding each, and pow"),
          .measure = [] { return decayed(1.0); },
          .sabotaged = [] { return decayed(1.01); }},
    Study{.id = "symplectic_euler.order",
          .source = {Paper::adams2009, "Eqs. 58, 59; Sec. 6.4"},
          .says = "the scheme is of order 1 in the time step",
          .quantity = "error of (x, v) of an oscillator at t = 1.6 [m], over the time step [s]",
          .spacing = {0.05, 0.025, 0.0125, 0.00625, 0.003125},
          .seeds = 1,
          .series = {{"free", between(0.9, 1.1, "one rate per step, of its beginning")},
                     {"damped", between(0.9, 1.1, "one rate per step, of its beginning")},
                     {"invariant x² + v² − Δt x v − 1",
                      between(0.9, 1.1, "it has no error of any order"), false, true}},
          .errors =
              [](double dt, std::uint64_t) {
                  return std::vector{error_at_end(oscillator(), dt, 0.0),
                                     error_at_end(oscillator(0.2), dt, 0.2),
                                     change_of_invariant<SymplecticEuler<2>>()};
              }},
    Erratum{37,
            {Paper::adams2009, "Eqs. 58, 59; Sec. 6.4"},
            "\"a simple explicit integration scheme\"",
            "symplectic (semi-implicit) Euler: x moves with the new velocity; order 1"}};
}  // namespace
}  // namespace symplectic_euler_claims
