#include "verification/cases/incompressible_tank.h"

#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace incompressible_tank_claims {
namespace {
using namespace verification;
using namespace plumbline;

constexpr int layers = 20;

/// A column of 1 m in a narrow tank, with g = 1 m/s².
template <int Dim> IncompressibleTank<Dim> narrow_tank(double d, double support, bool walls) {
    Vec<Dim> water = Vec<Dim>::Constant(4.0 * d), tank = water;
    water[Dim - 1] = 1.0, tank[Dim - 1] = 1.2;
    return {.tank = tank,
            .water = water,
            .spacing = d,
            .support = support,
            .walls = walls,
            .gravity = 1.0,
            .rest_density = 1.0};
}

/// |mean of p/(ρ₀ g (H − y)) − 1| over the lower half of a column of 20 layers, from 0.5 s to 1 s after its start.
template <int Dim> double error_of_pressure(bool walls) {
    const double d = 1.0 / layers;
    auto scene = scene_of<Dim, double>(narrow_tank<Dim>(d, 2.0, walls));
    const double dt = 0.01;
    double total = 0.0, count = 0.0;
    for (int n = 0; n < 100; ++n) {
        scene.step(dt);
        const auto& x = scene.template get<Positions<Dim>>();
        const auto& p = scene.template get<Pressure>();
        for (std::size_t i = 0; n >= 50 && i < x.size(); ++i) {
            const double y = x[i][Dim - 1];
            if (y < 0.5) total += p[i] / (1.0 - y), count += 1.0;
        }
    }
    return std::abs(total / count - 1.0);
}

/// Water, 1 m high and 0.5 m long, 0.25 s after it is let go: how far the farthest tenth of its particles
/// is from its wall [m], in the mean.
struct Collapse {
    double front, mean_step;
};
Collapse collapse(double courant, double relaxation = 0.5) {
    auto scene = scene_of<2, double>({.tank = {2.0, 1.5},
                                      .water = {0.5, 1.0},
                                      .spacing = 0.05,
                                      .courant = courant,
                                      .density = {.tolerance = 1e-4, .relaxation = relaxation},
                                      .divergence = {.tolerance = 1e-3, .relaxation = relaxation}});
    const double duration = 0.25;
    const Advance advance = advance_by_limits(scene, duration, courant / 0.4 * 0.005);
    std::vector<double> along;
    for (const Vec<2>& x : scene.get<Positions<2>>()) along.push_back(x[0]);
    std::ranges::sort(along, std::greater{});
    const std::size_t n = along.size() / 10;
    return {std::accumulate(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(n), 0.0) /
                static_cast<double>(n),
            duration / advance.steps};
}

const Register column{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "incompressible_tank.hydrostatic_pressure",
                 .source = {Paper::adams2009, "Secs. 6.1, 6.3"},
                 .says =
                     "DFSPH: pressure in the lower half of a column of 20 layers against ρ₀ g "
                     "(H − y), from 0.5 to 1 s after its start: relative error of the mean; "
                     "without the terms of the wall there is none",
                 .bound = at_most(0.2,
                                  "particles up to the support of 2 spacings below the surface are "
                                  "less dense than ρ₀ and have no pressure: 2 of the 10 to 20 "
                                  "layers above"),
                 .measure = [] { return error_of_pressure<D>(true); },
                 .sabotaged = [] { return error_of_pressure<D>(false); }};
})};
const Register steps{
    Claim{.id = "incompressible_tank.step_may_be_long",
          .source = {Paper::literature, "Bender and Koschier 2015"},
          .says =
              "a collapsing column 0.25 s on, the front with steps of 0.4 spacings against that "
              "with steps of 0.1 [spacings]; without pressures it stays where it is",
          .bound = at_most(1.0, "a front made of particles is known to a spacing"),
          .measure = [] { return std::abs(collapse(0.4).front - collapse(0.1).front) / 0.05; },
          .sabotaged =
              [] { return std::abs(collapse(0.4, 0.0).front - collapse(0.1).front) / 0.05; }},
    Claim{.id = "incompressible_tank.sound_does_not_limit",
          .source = {Paper::adams2009, "Sec. 6.1"},
          .says = "its mean step over the acoustic limit 0.4 h/(c + v) of a weakly compressible "
                  "fluid, c = 10 v, v = √(2 g H)",
          .bound = at_least(4.0,
                            "0.4 d/v over 0.4 · 2 d/(11 v) is 5.5 at the largest speed, and more "
                            "before; a step of 5 ms at most"),
          .measure =
              [] {
                  const double v = std::sqrt(2.0 * 9.81 * 1.0);
                  return collapse(0.4).mean_step / (0.4 * 0.1 / (11.0 * v));
              },
          .sabotaged =
              [] {
                  const double v = std::sqrt(2.0 * 9.81 * 1.0);
                  return collapse(0.1).mean_step / (0.4 * 0.1 / (11.0 * v));
              }}};

double column_error(double spacing, double support, double longest_step) {
    auto scene = scene_of<2, double>(narrow_tank<2>(spacing, support, true));
    advance_by_limits(scene, 1.0, longest_step);
    const auto& x = scene.get<Positions<2>>();
    const auto& p = scene.get<Pressure>();
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i][1] < 0.15 || x[i][1] > 0.85) continue;
        squares += std::pow(p[i] - (1.0 - x[i][1]), 2), count += 1.0;
    }
    return std::sqrt(squares / count);
}
}  // namespace
}  // namespace incompressible_tank_claims

double verification::error_of_column(double spacing, double support, double longest_step) {
    return incompressible_tank_claims::column_error(spacing, support, longest_step);
}
