#include "solver/fluid/particle_shifting.h"

#include "verification/fluid/drop.h"
#include "verification/framework/registry.h"

namespace particle_shifting_claims {
namespace {
using namespace plumbline;
using namespace verification;

using Box = PeriodicBox<2>;
using Search = BruteForce<2, Box>;

/// A jittered lattice without end; `steps` of shifts with unit speed, Δt = 0.1 spacings over it. The
/// spread (max − min) / mean of Σ m ω, over what it was at first.
double spread_of_density(int steps, double strength) {
    const double length = 10.0, h = 3.0;
    const Box box(Vec<2>::Zero(), Vec<2>::Constant(length));
    Scene scene{Given<Positions<2>, Velocities<2>, Masses>{}, WrapIntoBox<2>{box},
                FindNeighbours<2, Search>{h, Search(box)},
                SphDensity<WendlandC2<2>, Box>{WendlandC2<2>(h)},
                ShiftParticles<WendlandC2<2>, Box>{WendlandC2<2>(h), strength}};
    const auto points = jittered<2>({box.low(), box.high()}, 1.0, 0.3, 1);
    scene.get<Positions<2>>().assign(points.begin(), points.end());
    scene.get<Velocities<2>>().assign(points.size(), Vec<2>::UnitX());
    scene.get<Masses>().assign(points.size(), 1.0);
    const auto spread = [&] {
        const auto [low, high] = std::ranges::minmax(scene.get<Density>());
        return high - low;
    };
    scene.step(0.0);
    const double before = spread();
    for (int n = 0; n < steps; ++n) scene.step(0.1);
    return spread() / before;
}
/// The longest shift of the drop in one long step, over a fifth of half of the support.
double longest_shift(double longer) {
    auto scene = scene_of(Drop<2>{}, ShiftParticles<WendlandC2<2>>{WendlandC2<2>(2.6), 2.0});
    scene.step(100.0);
    double longest = 0.0;
    for (const Vec<2>& shift : scene.get<Shift<2>>()) longest = std::max(longest, shift.norm());
    return longer * longest / (0.2 * 0.5 * 2.6);
}
/// Where the shift counts as motion, it is part of the velocity, too.
double change_of_velocities(bool shift_is_motion) {
    auto scene = scene_of(Drop<2>{}, ShiftParticles<WendlandC2<2>>{WendlandC2<2>(2.6), 2.0});
    const double dt = 0.1;
    scene.step(dt);
    std::vector<Vec<2>> v(scene.get<Velocities<2>>().begin(), scene.get<Velocities<2>>().end());
    if (shift_is_motion)
        for (std::size_t i = 0; i < v.size(); ++i) v[i] += scene.get<Shift<2>>()[i] / dt;
    return largest_difference<2>(v, Drop<2>{}.v);
}

const Register claims_of_shifting{
    Claim{
        .id = "particle_shifting.evens_out",
        .source = {Paper::literature, "Lind et al. 2012"},
        .says = "the spread of densities on a jittered lattice, after 50 steps, over the first one",
        .bound = at_most(0.5, "towards where there are fewer: less than half is what calls for it"),
        .measure = [] { return spread_of_density(50, 2.0); },
        .sabotaged = [] { return spread_of_density(50, -2.0); }},
    Claim{.id = "particle_shifting.is_limited",
          .source = {Paper::plumbline, "docstring of ShiftParticles"},
          .says = "no shift is longer than h/5, however long the step",
          .bound = between(1.0 - 1e-15, 1.0 + 1e-15, "a vector scaled to a length: 3 roundings"),
          .measure = [] { return longest_shift(1.0); },
          .sabotaged = [] { return longest_shift(1.01); }},
    Claim{.id = "particle_shifting.leaves_velocities_alone",
          .source = {Paper::plumbline, "docstring of ShiftParticles"},
          .says = "max change of velocities by a shift",
          .bound = at_most(0.0, "nothing but positions is written"),
          .measure = [] { return change_of_velocities(false); },
          .sabotaged = [] { return change_of_velocities(true); }}};
}  // namespace
}  // namespace particle_shifting_claims
