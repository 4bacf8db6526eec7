#include "verification/cases/channel.h"
#include "verification/framework/registry.h"

#include <cmath>
#include <numbers>

namespace startup_flow_claims {
namespace {
using namespace verification;
using plumbline::Vec;

constexpr double tau = 0.1;  // ν t / L²

/// u / U₀ between plates at rest, τ after a force set in: 4 y (1 − y) less what still decays.
double poiseuille(double y) {
    double u = 4.0 * y * (1.0 - y);
    for (int n = 0; n < 30; ++n) {
        const double k = (2 * n + 1) * std::numbers::pi;
        u -= 32.0 / (k * k * k) * std::sin(k * y) * std::exp(-k * k * tau);
    }
    return u;
}
/// u / U₀, τ after the plate at y = 1 began to move: its images in both plates.
double couette(double y) {
    const double root = 2.0 * std::sqrt(tau);
    double u = 0.0;
    for (int n = 0; n < 12; ++n)
        u += std::erfc((2 * n + 1 - y) / root) - std::erfc((2 * n + 1 + y) / root);
    return u;
}
/// max |u − exact| / U₀ over all particles.
double largest_error(const Channel& channel, double (*exact)(double)) {
    const ChannelState end = simulate(channel, tau / channel.viscosity);
    double worst = 0.0;
    for (std::size_t i = 0; i < end.x.size(); ++i)
        worst = std::max(worst, std::abs(end.v[i][0] - exact(end.x[i][1])));
    return worst;
}
Channel driven(double spacing) {
    return {.spacing = spacing, .gravity = {8.0 * 0.1, 0.0}, .viscosity = 0.1};
}

const Register claims_of_startup{Study{
    .id = "startup_flow.error_over_spacing",
    .source = {Paper::adams2009, "Eqs. 48, 56; Sec. 6.3"},
    .says = "ghosts that have the velocity of the wall make the fluid stick to it, to first order: "
            "their "
            "velocity is that of the surface all through the wall",
    .quantity = "max |u − exact| / U₀ at ν t/L² = 0.1, over the spacing [m]",
    .spacing = {1.0 / 10, 1.0 / 15, 1.0 / 20, 1.0 / 30, 1.0 / 40},
    .seeds = 1,
    .series = {{"Poiseuille", between(0.75, 1.25,
                                      "the fluid meets the velocity of the wall up to a "
                                      "spacing beside its surface")},
               {"Couette", between(0.75, 1.25,
                                   "the fluid meets the velocity of the wall up to a "
                                   "spacing beside its surface")},
               {"Poiseuille, ghosts left out",
                between(0.75, 1.25, "the fluid slips: no convergence"), false, true}},
    .errors = [](double spacing, std::uint64_t) {
        Channel slipping = driven(spacing);
        slipping.slip = true;
        return std::vector{
            largest_error(driven(spacing), poiseuille),
            largest_error({.spacing = spacing, .viscosity = 0.1, .speed_of_lid = 1.0}, couette),
            largest_error(slipping, poiseuille)};
    }}};
}  // namespace
}  // namespace startup_flow_claims
