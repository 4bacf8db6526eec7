#include "verification/cases/incompressible_tank.h"

#include "solver/fluid/brookshaw_viscosity.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace incompressible_tank_claims {
namespace {
using namespace verification;
using namespace plumbline;

constexpr int layers = 16;

/// A column of 1 m, so many spacings wide, with g = 1 m/s² and ν = 0.02 m²/s.
constexpr double nu = 0.02;
template <int Dim> auto column(double d, int wide, double support, double tolerance, bool walls) {
    Vec<Dim> water = Vec<Dim>::Constant(wide * d), tank = water;
    water[Dim - 1] = 1.0, tank[Dim - 1] = 1.2;
    return scene_of<Dim, double>(
        IncompressibleTank<Dim>{.tank = tank,
                                .water = water,
                                .spacing = d,
                                .support = support,
                                .density = {.tolerance = tolerance},
                                .walls = walls,
                                .gravity = 1.0,
                                .rest_density = 1.0},
        BrookshawViscosity<CubicSpline<Dim>>{CubicSpline<Dim>(support * d), nu});
}
/// Whether a particle of it has others on all sides but up and down.
template <int Dim> bool is_inner(const Vec<Dim>& x, double d, int wide) {
    const auto side = x.template head<Dim - 1>().array();
    return (side > d).all() && (side < (wide - 1) * d).all();
}

/// What the sums of a lattice make of a linear pressure: −Σ m/ρ₀ x ∂ω/∂x, 1 for fine lattices. The pressure that carries a
/// column is as much larger.
template <int Dim> double slope_on_lattice(double support) {
    const CubicSpline<Dim> w(support);
    const double mass = mass_on_lattice(w, 1.0, 1.0);
    const auto around = Vec<Dim>::Constant(std::ceil(support) + 0.5);
    double sum = 0.0;
    for (const Vec<Dim>& x : lattice<Dim>({-around, around}, 1.0))
        if (const double r = x.norm(); r > 0.0) sum -= mass * x[0] * x[0] / r * w.derivative(r);
    return sum;
}

/// p/(ρ₀ g (H − y)) on a lattice, less 1, away from the sides, in the lower half of a column of 16 layers, from 0.5 s to 1 s after its start.
struct ErrorOfPressure {
    double mean, rms;
};
template <int Dim> ErrorOfPressure error_of_pressure(bool walls, double tolerance) {
    const double d = 1.0 / layers;
    constexpr double support = 2.0;
    constexpr int wide = Dim == 2 ? 16 : 6;
    auto scene = column<Dim>(d, wide, support, tolerance, walls);
    const double dt = 0.01, slope = slope_on_lattice<Dim>(support);
    double total = 0.0, squares = 0.0, count = 0.0;
    for (int n = 0; n < 100; ++n) {
        scene.step(dt);
        const auto& x = scene.template get<Positions<Dim>>();
        const auto& p = scene.template get<Pressure>();
        for (std::size_t i = 0; n >= 50 && i < x.size(); ++i) {
            const double y = x[i][Dim - 1];
            if (y > 0.5 || !is_inner<Dim>(x[i], d, wide)) continue;
            const double error = slope * p[i] / (1.0 - y) - 1.0;
            total += error, squares += error * error, count += 1.0;
        }
    }
    return {total / count, std::sqrt(squares / count)};
}

/// Water, 1 m high and 0.5 m long, 0.25 s after it is let go: how far the farthest tenth of its particles
/// is from its wall [m], in the mean.
struct Collapse {
    double front, mean_step;
};
Collapse collapse(double courant, int most = 200) {
    auto scene = scene_of<2, double>({.tank = {2.0, 1.5},
                                      .water = {0.5, 1.0},
                                      .spacing = 0.05,
                                      .courant = courant,
                                      .density = {.tolerance = 1e-4, .most = most},
                                      .divergence = {.tolerance = 1e-3, .most = most}});
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

const Register of_pressure{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "incompressible_tank.hydrostatic_pressure",
        .source = {Paper::adams2009, "Secs. 6.1, 6.3"},
        .says =
            "DFSPH: mean pressure in the lower half of a column of 20 layers over ρ₀ g (H − y) on "
            "a "
            "lattice, from 0.5 to 1 s after its start, less 1; without the terms of the wall there "
            "is "
            "none",
        .bound = between(
            -0.1, 0.1,
            "the column is carried, so the mean has its weight: a depth of 8 to 16 layers is "
            "known to half of one, 3 to 6 %, and once more for particles that have left "
            "the lattice"),
        .measure = [] { return error_of_pressure<D>(true, 1e-5).mean; },
        .sabotaged = [] { return error_of_pressure<D>(false, 1e-5).mean; }};
})};
const Register calm{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "incompressible_tank.pressure_is_calm",
        .source = {Paper::plumbline, "docstring of ConstantDensity"},
        .says =
            "rms of the same for each particle and step; with a tolerance of 1e-3, ten times what "
            "gravity "
            "compresses per step, g Δt²/(n d), pressures are left to chance",
        .bound = at_most(0.25, "the target: one reading of one particle is right to a quarter"),
        .measure = [] { return error_of_pressure<D>(true, 1e-5).rms; },
        .sabotaged = [] { return error_of_pressure<D>(true, 1e-3).rms; }};
})};
const Register steps{
    Claim{
        .id = "incompressible_tank.step_may_be_long",
        .source = {Paper::literature, "Bender and Koschier 2015"},
        .says = "a collapsing column 0.25 s on, the front with steps of 0.4 spacings against that "
                "with steps of 0.1 [spacings]; without pressures it stays where it is",
        .bound = at_most(1.0, "a front made of particles is known to a spacing"),
        .measure = [] { return std::abs(collapse(0.4).front - collapse(0.1).front) / 0.05; },
        .sabotaged = [] { return std::abs(collapse(0.4, 1).front - collapse(0.1).front) / 0.05; }},
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

/// Iterations of the first solve of a column, to a thousandth of what gravity compresses.
double first_iterations(int rows, bool momentum) {
    const double d = 1.0 / rows, dt = 0.01;
    Vec<2> water{4.0 * d, 1.0}, tank{4.0 * d, 1.2};
    auto scene = scene_of<2, double>(IncompressibleTank<2>{
        .tank = tank,
        .water = water,
        .spacing = d,
        .density = {.tolerance = 1e-3 * dt * dt, .most = 100000, .momentum = momentum},
        .gravity = 1.0,
        .rest_density = 1.0});
    scene.step(dt);
    return scene.get<DensityReport>().iterations;
}
double growth_of_iterations(bool momentum) {
    return std::log2(first_iterations(64, momentum) / first_iterations(8, momentum)) / 3.0;
}
const Register iterations{Claim{
    .id = "incompressible_tank.iterations_grow_with_layers",
    .source = {Paper::plumbline, "docstring of project"},
    .says = "exponent with which the iterations of a first solve grow from 8 to 64 layers, to a "
            "thousandth of "
            "what gravity compresses in the step; without Nesterov's momentum 2",
    .bound = between(
        0.5, 1.5,
        "1: the condition of the system grows with the square of the layers, and momentum takes "
        "its root; nearer to it than to 0 and 2"),
    .measure = [] { return growth_of_iterations(true); },
    .sabotaged = [] { return growth_of_iterations(false); }}};

double column_error(double spacing, double support, double longest_step) {
    constexpr int wide = 12;
    auto scene = column<2>(spacing, wide, support, 1e-5, true);
    advance_by_limits(scene, 1.0, longest_step);
    const auto& x = scene.get<Positions<2>>();
    const auto& p = scene.get<Pressure>();
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i][1] < 0.15 || x[i][1] > 0.85 || !is_inner<2>(x[i], spacing, wide)) continue;
        squares += std::pow(p[i] - (1.0 - x[i][1]), 2), count += 1.0;
    }
    return std::sqrt(squares / count);
}
}  // namespace
}  // namespace incompressible_tank_claims

double verification::error_of_column(double spacing, double support, double longest_step) {
    return incompressible_tank_claims::column_error(spacing, support, longest_step);
}
