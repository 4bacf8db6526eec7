#include "solver/fluid/ghost_density.h"
#include "solver/fluid/ghost_pressure_force.h"
#include "solver/fluid/gravity.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/sph_density.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/tension.h"
#include "solver/foundation/random.h"
#include "solver/kernels/wendland_c4.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"
#include "verification/fluid/dispersion.h"
#include "verification/framework/eigenvalues.h"
#include "verification/stability/findings.h"

#include <fmt/format.h>

namespace stability_column_map {
namespace {
using namespace plumbline;
using namespace verification;
using W = WendlandC4<2>;
using Box = PeriodicBox<2>;
using Search = CellGrid<2, Box>;

constexpr double h = 2.35;  // support, in spacings; c₀ = 1, masses 1
constexpr int columns = 10, rows = 16;
const double height = rows * std::sqrt(0.75);

double rest_density() { return density_on(W(h), neighbours_on(hexagonal_lattice(1.0), h)); }
TaitEquation tait() { return {rest_density(), 1.0, 7.0}; }
double gravity_of(double g_height_over_c2) { return g_height_over_c2 / height; }
/// Below n rows of the column, each of mass 1 per length.
double pressure_below(double g, double n) { return g * n; }

/// The border of a hexagonal lattice squeezed along y to the density at the bottom.
double step_at_the_bottom(double g) {
    const double p = pressure_below(g, rows - 0.5), rho = tait().density(p);
    Lattice<2> squeezed = hexagonal_lattice(1.0);
    squeezed.basis.row(1) *= rest_density() / rho;
    const auto neighbours = neighbours_on(squeezed, h);
    const FluidAtRest fluid{rho, p, tait().speed_of_sound(rho)};
    double largest = 0.0;
    for_each_wave(squeezed, 24, [&](const Vec<2>& k) {
        largest =
            std::max(largest, eigenvalues<2>(dispersion(W(h), neighbours, fluid, k)).maxCoeff());
    });
    return 2.0 / std::sqrt(largest);
}

/// Rows as dense as the weight above them asks for, on three rows of ghosts.
template <class Scene> void fill(Scene& scene, double g) {
    auto& x = scene.template get<Positions<2>>();
    auto& ghosts = scene.template get<GhostPositions<2>>();
    double y = height, gap = 0.0;
    for (int row = 0; row < rows + 3; ++row) {
        const double n = std::min(row + 0.5, rows - 0.5);
        gap = std::sqrt(0.75) * rest_density() / tait().density(pressure_below(g, n));
        y -= gap;
        for (int column = 0; column < columns; ++column)
            (row < rows ? static_cast<Points<2>&>(x) : static_cast<Points<2>&>(ghosts))
                .emplace_back(column + 0.25 + 0.5 * (row % 2), y);
    }
    scene.template get<Velocities<2>>().assign(x.size(), Vec<2>::Zero());
    scene.template get<Masses>().assign(x.size(), 1.0);
    scene.template get<GhostVelocities<2>>().assign(ghosts.size(), Vec<2>::Zero());
    scene.template get<GhostMasses>().assign(ghosts.size(), 1.0);
}
auto column_at_rest(double g, double dt) {
    const Box box(Vec<2>(0.0, -10.0), Vec<2>(columns, height + 10.0));
    const W w(h);
    Scene scene{Given<Positions<2>, Velocities<2>, Masses>{},
                Given<GhostPositions<2>, GhostVelocities<2>, GhostMasses>{},
                WrapIntoBox<2>{box},
                FindNeighbours<2, Search>{h, Search(box)},
                FindGhosts<2, Search>{h, Search(box)},
                SphDensity<W, Box>{w},
                AddGhostDensity<W, Box>{w},
                TaitPressure{tait()},
                ScaleTension{0.0},
                Gravity<2>{{0.0, -g}},
                PressureForce<W, Box>{w},
                GhostPressureForce<W, Box>{w},
                SymplecticEuler<2>{}};
    fill(scene, g);
    for (int n = 0; n < 600; ++n) {
        scene.step(dt);
        for (Vec<2>& v : scene.template get<Velocities<2>>()) v *= 0.9;
    }
    return scene;
}

/// Whether velocities of 1e-9, added to the lower half of the column at rest, reach 1e-6 within 100 steps. The upper half is
/// held: its surface is slowly unstable at any step, as all that is under tension.
template <class Scene> bool shakes(Scene scene, double dt) {
    Random random(1);
    auto& x = scene.template get<Positions<2>>();
    auto& v = scene.template get<Velocities<2>>();
    const Points<2> at_rest = x;
    for (std::size_t i = v.size() / 2; i < v.size(); ++i)
        v[i] += 1e-9 * Vec<2>(random.uniform(-1, 1), random.uniform(-1, 1));
    for (int n = 0; n < 100; ++n) {
        scene.step(dt);
        for (std::size_t i = 0; i < v.size() / 2; ++i) x[i] = at_rest[i], v[i].setZero();
        for (const Vec<2>& v_i : v)
            if (!(v_i.norm() < 1e-6)) return true;
    }
    return false;
}

std::string finding(const MapResult& result) {
    const auto& border = result.lines.front();
    const auto& rule = result.lines.back();
    return fmt::format(
        "A column shakes at the acoustic limit of its bottom; the force limit 0.25 √(h/g) would "
        "allow {:.1f} "
        "to {:.0f} times that",
        rule.curve.back() / border.curve.back(), rule.curve.front() / border.curve.front());
}

const RegisterMap column{
    Map{.id = "force_limit",
        .source = {Paper::plumbline, "docstrings of ForceLimit and AcousticLimit"},
        .says = "the largest step of a column under its own weight: that of a lattice squeezed to "
                "the density at "
                "its bottom, not that of its acceleration",
        .x = {"gH/c₀²", "1", true},
        .y = {"largest time step over h/c₀", "1", true},
        .curve_at = {0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5},
        .lines = {{"column of 16 rows",
                   [](double x) { return step_at_the_bottom(gravity_of(x)) / h; },
                   [](double x, double theory) {
                       const double g = gravity_of(x);
                       const auto scene = column_at_rest(g, 0.3 * theory * h);
                       return bisected([&](double y) { return shakes(scene, y * h); }, theory);
                   },
                   {0.1},
                   {0.01, 0.02, 0.05, 0.1, 0.2, 0.5},
                   between(0.98, 1.02 + h / (2.0 * height),
                           "what shakes reaches one support up from the bottom, half a support on "
                           "the average, where "
                           "pressure is lower by h/2H; its square root, and 2 % as elsewhere")},
                  {"acoustic rule: 0.4 h/c at the bottom",
                   [](double x) {
                       const double p = pressure_below(gravity_of(x), rows - 0.5);
                       return 0.4 / tait().speed_of_sound(tait().density(p));
                   }},
                  {"force rule: 0.25 √(h/g)",
                   [](double x) { return 0.25 / std::sqrt(gravity_of(x) * h); }}},
        .what_is_run = "10 by 16 particles on three rows of ghosts, Wendland C4, h/s = 2.35, 600 "
                       "damped steps, then "
                       "velocities of 1e-9 c₀ in the lower half, the upper one is held; broken: "
                       "1e-6 c₀ within 100 steps; bisected to "
                       "0.4 %",
        .finding = finding}};
}  // namespace
}  // namespace stability_column_map
