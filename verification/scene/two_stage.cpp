#include "solver/scene/two_stage.h"

#include "solver/scene/symplectic_euler.h"
#include "verification/framework/registry.h"
#include "verification/scene/oscillator.h"

namespace two_stage_claims {
namespace {
using namespace plumbline;
using namespace verification;

auto oscillator(double d = 0.0) {
    return Scene{StartOfOscillator{}, TwoStage{Evolve<2>{}, Spring{d}}};
}
auto by_euler(double d = 0.0) {
    return Scene{StartOfOscillator{}, Spring{d}, SymplecticEuler<2>{}};
}
/// |energy after 100 steps of 0.1 / (1 + Δt⁴/4)¹⁰⁰ − 1|
double error_of_growth(auto scene) {
    const double dt = 0.1;
    double energy = 0.0;
    oscillate(scene, dt, 100, [&](double x, double v) { energy = x * x + v * v; });
    return std::abs(energy / std::pow(1.0 + std::pow(dt, 4) / 4.0, 100) - 1.0);
}
struct Decay {
    using Reads = Quantities<Density>;
    using Writes = Quantities<Rate<Density>>;
    void run(double, const Density& q, Rate<Density>& rate) const { rate[0] -= q[0]; }
};
/// dq/dt = −q: each step multiplies by 1 − Δt + Δt²/2.
double error_of_decay(double second_order_term) {
    Scene scene{Given<Positions<2>, Velocities<2>, Density>{},
                TwoStage{Evolve<2, Density>{}, Decay{}}};
    scene.get<Positions<2>>().assign(1, Vec<2>::Zero());
    scene.get<Velocities<2>>().assign(1, Vec<2>::Zero());
    scene.get<Density>().assign(1, 1.0);
    const double dt = 0.25;
    for (int n = 0; n < 10; ++n) scene.step(dt);
    const double factor = 1.0 - dt + second_order_term * dt * dt;
    return std::abs(scene.get<Density>()[0] / std::pow(factor, 10) - 1.0);
}

const Register claims_of_two_stage{
    Claim{.id = "two_stage.growth_of_an_oscillator",
          .source = {Paper::plumbline, "docstring of TwoStage"},
          .says =
              "the energy of an oscillator grows by (1 − z²/2)² + z² = 1 + z⁴/4 per step, z = ω Δt",
          .bound = at_most(4e-13,
                           "100 steps of 8 roundings in x and v, twice for the squares: "
                           "100 · 2 · 8 · 2 · 1.1e-16"),
          .measure = [] { return error_of_growth(oscillator()); },
          .sabotaged = [] { return error_of_growth(by_euler()); }},
    Claim{.id = "two_stage.advances_other_quantities",
          .source = {Paper::plumbline, "docstring of TwoStage"},
          .says = "with dq/dt = −q each step multiplies by 1 − Δt + Δt²/2",
          .bound = at_most(1e-14, "10 steps of 4 roundings each, twice: 10 · 8 · 1.1e-16, and pow"),
          .measure = [] { return error_of_decay(0.5); },
          .sabotaged = [] { return error_of_decay(0.0); }},
    Study{
        .id = "two_stage.order",
        .source = {Paper::plumbline, "docstring of TwoStage"},
        .says = "the scheme is of order 2 in the time step, also where forces depend on velocities",
        .quantity = "error of (x, v) of an oscillator at t = 1.6 [m], over the time step [s]",
        .spacing = {0.05, 0.025, 0.0125, 0.00625, 0.003125},
        .seeds = 1,
        .series = {{"free", between(1.9, 2.1, "the midpoint rule")},
                   {"damped", between(1.9, 2.1, "the midpoint rule")},
                   {"symplectic Euler", between(1.9, 2.1, "of order 1"), false, true}},
        .errors = [](double dt, std::uint64_t) {
            return std::vector{error_at_end(oscillator(), dt, 0.0),
                               error_at_end(oscillator(0.2), dt, 0.2),
                               error_at_end(by_euler(0.2), dt, 0.2)};
        }}};
}  // namespace
}  // namespace two_stage_claims
