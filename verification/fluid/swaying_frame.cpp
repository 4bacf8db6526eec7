#include "solver/fluid/swaying_frame.h"

#include "solver/scene/leapfrog.h"
#include "solver/scene/scene.h"
#include "verification/framework/registry.h"

namespace swaying_frame_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// max |x − A (ωΔt)²/(2 − 2 cos ωΔt) (1 − cos ωt)| of a free particle, for A = 1, over a period; the clock is late where it
/// comes after the forces.
double error_of_free_particle(bool late) {
    constexpr double omega = 2.0, dt = 0.01, s = omega * dt;
    constexpr int steps = 314;
    const SwayingFrame<2> frame{{0.0, 0.0}, {1.0, 0.0}, omega};
    const Leapfrog swaying{Evolve<2>{}, frame};
    const double amplitude = s * s / (2.0 - 2.0 * std::cos(s));
    const auto run = [&](auto scene) {
        scene.template get<Positions<2>>().assign(1, Vec<2>::Zero());
        scene.template get<Velocities<2>>().assign(1, Vec<2>::Zero());
        double worst = 0.0;
        scene.step(0.0);
        for (int n = 1; n <= steps; ++n) {
            scene.step(dt);
            const double x = scene.template get<Positions<2>>()[0].x();
            worst = std::max(worst, std::abs(x - amplitude * (1.0 - std::cos(s * n))));
        }
        return worst;
    };
    using Start = Given<Positions<2>, Velocities<2>>;
    return late ? run(Scene{Start{}, swaying, KeepTime{}})
                : run(Scene{Start{}, KeepTime{}, swaying});
}

const Register claims_of_swaying_frame{Claim{
    .id = "swaying_frame.free_particle",
    .source = {Paper::plumbline, "docstring of SwayingFrame"},
    .says =
        "a free particle stays where it was while the tank sways to A cos ωt: in the frame of the "
        "tank, after n steps, x = A (ωΔt)²/(2 − 2 cos ωΔt) (1 − cos nωΔt), over a period; wrong: "
        "the "
        "clock is a step late",
    .bound =
        at_most(1e-10,
                "second differences of x are Δt² a(t), which that solves; 2 · 314 roundings of "
                "v < 2 by 2.2e-16 each, carried on for a period of 3, of the time by 314 · 4e-16 "
                "· ω in the force 4: 4.5e-13 and 314 · 4e-16 · 2 · 4 · 3² / 2 = 4.5e-12; and "
                "2 − 2 cos ωΔt = 4e-4 is off by 2.2e-16/4e-4 = 6e-13 of it"),
    .measure = [] { return error_of_free_particle(false); },
    .sabotaged = [] { return error_of_free_particle(true); }}};
}  // namespace
}  // namespace swaying_frame_claims
