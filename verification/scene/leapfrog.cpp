#include "solver/scene/leapfrog.h"

#include "solver/scene/symplectic_euler.h"
#include "verification/framework/registry.h"
#include "verification/scene/oscillator.h"

namespace leapfrog_claims {
namespace {
using namespace plumbline;
using namespace verification;

auto oscillator(double d = 0.0) {
    return Scene{StartOfOscillator{}, Leapfrog{Evolve<2>{}, Spring{d}}};
}
auto by_euler() { return Scene{StartOfOscillator{}, Spring{}, SymplecticEuler<2>{}}; }

/// max |x² (1 − Δt²/4) + v² − its start| over 1000 steps of 0.1.
double change_of_invariant(auto scene) {
    const double dt = 0.1, weight = 1.0 - dt * dt / 4.0;
    double worst = 0.0;
    oscillate(scene, dt, 1000, [&](double x, double v) {
        worst = std::max(worst, std::abs(weight * x * x + v * v - weight));
    });
    return worst;
}
/// The error if forces are evaluated with v½, not with the prediction.
double without_prediction(double dt, double d) {
    double x = 1.0, v = 0.0, a = -1.0;
    for (int n = 0; n < std::lround(1.6 / dt); ++n) {
        v += 0.5 * dt * a;
        x += dt * v;
        a = -x - 2.0 * d * v;
        v += 0.5 * dt * a;
    }
    return error_of_state(x, v, d);
}
struct CountsEvaluations {
    using Reads = Quantities<Positions<2>>;
    using Writes = Quantities<Accelerations<2>>;
    int* count;
    void run(double, const Positions<2>&, Accelerations<2>&) const { ++*count; }
};
double evaluations_of_ten_steps(int restarts) {
    int count = 0;
    Scene scene{StartOfOscillator{}, Leapfrog{Evolve<2>{}, CountsEvaluations{&count}}};
    for (int n = 0; n < 10; ++n) {
        if (n < restarts) scene.get<RatesAreCurrent>().value = false;
        scene.step(0.1);
    }
    return count;
}

const Register claims_of_leapfrog{
    Claim{
        .id = "leapfrog.keeps_its_invariant",
        .source = {Paper::plumbline, "docstring of Leapfrog"},
        .says =
            "v² + (1 − Δt²/4) x² of an oscillator is constant: the energy errs by O(Δt²), for ever",
        .bound = at_most(4e-12,
                         "1000 steps of 8 roundings of numbers up to 1, in x and v: "
                         "1000 · 2 · 8 · 1.1e-16, twice for the squares"),
        .measure = [] { return change_of_invariant(oscillator()); },
        .sabotaged = [] { return change_of_invariant(by_euler()); }},
    Claim{
        .id = "leapfrog.stable_below_the_limit",
        .source = {Paper::plumbline, "docstring of Leapfrog"},
        .says = "max ‖(x, v)‖ over 10000 steps with ω Δt = 1.99; with 2.01 it grows without limit",
        .bound =
            at_most(1.1, "v² + (1 − Δt²/4) x² = 1 − Δt²/4 keeps x² ≤ 1, v² ≤ 0.01; and roundings"),
        .measure = [] { return largest_swing(oscillator(), 1.99, 10000); },
        .sabotaged = [] { return largest_swing(oscillator(), 2.01, 10000); }},
    Claim{.id = "leapfrog.one_evaluation_per_step",
          .source = {Paper::plumbline, "docstring of Leapfrog"},
          .says =
              "ten steps evaluate the forces 11 times: once at the start; more if it is told that "
              "the state was changed",
          .bound = between(11.0, 11.0, "a count"),
          .measure = [] { return evaluations_of_ten_steps(0); },
          .sabotaged = [] { return evaluations_of_ten_steps(3); }},
    Study{
        .id = "leapfrog.order",
        .source = {Paper::plumbline, "docstring of Leapfrog"},
        .says = "the scheme is of order 2 in the time step, also where forces depend on velocities",
        .quantity = "error of (x, v) of an oscillator at t = 1.6 [m], over the time step [s]",
        .spacing = {0.05, 0.025, 0.0125, 0.00625, 0.003125},
        .seeds = 1,
        .series = {{"free", between(1.9, 2.1, "symmetric in time")},
                   {"damped",
                    between(1.9, 2.1, "the prediction errs by Δt², its force enters by Δt")},
                   {"damped, forces of v½", between(1.9, 2.1, "v½ errs by Δt/2: order 1"), false,
                    true}},
        .errors = [](double dt, std::uint64_t) {
            return std::vector{error_at_end(oscillator(), dt, 0.0),
                               error_at_end(oscillator(0.2), dt, 0.2), without_prediction(dt, 0.2)};
        }}};
}  // namespace
}  // namespace leapfrog_claims
