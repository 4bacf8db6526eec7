#include "solver/scene/guarded_run.h"
#include "verification/framework/registry.h"

#include <fmt/format.h>

#include <functional>
#include <numbers>

namespace floating_body_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Steps the scene to its end.
void run(const SceneFile& scene, const std::function<void(double, const BodyState&)>& look) {
    const auto simulation = make_simulation(scene);
    GuardedRun run(*simulation, domain_of(scene, simulation->snapshot()));
    while (run.time() < scene.end) {
        run.step(next_step(scene, simulation->limits(), run.time(), scene.end));
        look(run.time(), simulation->snapshot().bodies.at(0));
    }
}

constexpr const char* artificial = "\"artificial\"\nalpha = 0.1";
/// Water at rest under gravity in a tank, at speed of sound 25, with a body.
std::string water(int dim, double spacing, const std::string& tank, const std::string& surface,
                  const std::string& open, const std::string& gravity, const std::string& body,
                  double end, const std::string& viscosity = artificial, bool dfsph = false) {
    const std::string zero = dim == 2 ? "[0, 0]" : "[0, 0, 0]";
    return fmt::format(
        "title = \"body\"\ndim = {}\nmethod = \"{}\"\ngravity = {}\n[particles]\n"
        "spacing = {}\nsupport = {}\n[fluid]\ndensity = 1000\nspeed_of_sound = 25\n"
        "viscosity = {}\n{}[[block]]\nshape = \"box\"\n"
        "low = {}\nhigh = {}\n{}[[wall]]\nshape = \"tank\"\nlow = {}\nhigh = {}\n"
        "open = {}\n[[body]]\n{}\n[time]\nend = {}\n[output]\ninterval = {}\npicture = \"none\"\n",
        dim, dfsph ? "dfsph" : "delta_sph", gravity, spacing, dfsph ? 2.0 : 2.6, viscosity,
        dfsph ? "" : "tension = 0\n", zero, surface, dfsph ? "" : "hydrostatic = true\n", zero,
        tank, open, body, end, end);
}

/// How far the middle of a block is above the surface, in the mean over the second half of the time, in spacings. It
/// begins there, as it is 12 spacings (in space 6 x 6) wide and 6 (4) high; the water is 12 (6) spacings deep.
template <int Dim, bool Dfsph> double height_over_surface(double density) {
    const double d = Dim == 2 ? 0.025 : 0.05;
    const SceneFile scene = SceneFile::parse(
        "floating body",
        Dim == 2 ? water(2, d, "[0.8, 0.5]", "[0.8, 0.3]", "[\"+y\"]", "[0, -9.81]",
                         fmt::format("shape = \"box\"\nlow = [0.25, 0.225]\nhigh = [0.55, 0.375]\n"
                                     "density = {}",
                                     density),
                         0.6, artificial, Dfsph)
                 : water(3, d, "[0.6, 0.6, 0.5]", "[0.6, 0.6, 0.3]", "[\"+z\"]", "[0, 0, -9.81]",
                         fmt::format("shape = \"box\"\nlow = [0.15, 0.15, 0.2]\n"
                                     "high = [0.45, 0.45, 0.4]\ndensity = {}",
                                     density),
                         0.4, artificial, Dfsph));
    double sum = 0.0, weights = 0.0, before = 0.0;
    run(scene, [&](double time, const BodyState& body) {
        if (time > 0.5 * scene.end)
            sum += (time - before) * body.centre[Dim - 1], weights += time - before;
        before = time;
    });
    return (sum / weights - 0.3) / d;
}

/// A disc of radius 4 spacings in the middle of a closed box 4 times as wide, under gravity 1, for 0.2 s, which sound
/// crosses the box 6 times in. Without viscosity, whose drag on a disc that slips, 8 π μ V, would be as large
/// as its weight: μ = 8 of α = 0.1 at 0.06 m/s against 31 N.
void run_disc(const std::string& how, const std::function<void(double, const BodyState&)>& look) {
    const SceneFile scene = SceneFile::parse(
        "sinking body",
        water(2, 0.025, "[0.8, 0.8]", "[0.8, 0.8]", "[]", "[0, -1]",
              "shape = \"sphere\"\ncentre = [0.4, 0.4]\nradius = 0.1\n" + how, 0.2, "\"none\""));
    run(scene, look);
}
/// The lift of the disc, held, over the weight of the water in its circle: ghosts act as if it were somewhat larger.
double lift_of_disc() {
    double lift = 0.0, steps = 0.0;
    run_disc("fixed = true",
             [&](double, const BodyState& body) { lift += body.force[1], ++steps; });
    return lift / steps / (1000.0 * std::numbers::pi * 0.01);
}
/// Its mean acceleration when it is let go, with twice the water's density.
double acceleration_of_disc() {
    double mean = 0.0;
    run_disc("density = 2000",
             [&](double time, const BodyState& body) { mean = -body.velocity[1] / time; });
    return mean;
}
/// The acceleration over (s − A)/(s + C A) g with s = 2.
double over_that_with_added_mass(double C) {
    static const double A = lift_of_disc(), a = acceleration_of_disc();
    return a / ((2.0 - A) / (2.0 + C * A));
}

/// Where a block of three times the water's density is after 0.8 s, and how it lies: |height of its middle over where it
/// rests on the floor| and |turn|, over the spacing [1].
double rest_on_floor(double density) {
    const SceneFile scene = SceneFile::parse(
        "sunk body", water(2, 0.025, "[0.6, 0.5]", "[0.6, 0.3]", "[\"+y\"]", "[0, -9.81]",
                           fmt::format("shape = \"box\"\nlow = [0.2, 0.1]\nhigh = [0.4, 0.2]\n"
                                       "density = {}",
                                       density),
                           0.8));
    double above = 0.0;
    run(scene, [&](double, const BodyState& body) {
        above = std::abs(body.centre[1] - 0.05) + std::abs(body.turn[2]) * 0.1;
    });
    return above / 0.025;
}

Claim floats(const std::string& how, double (*height)(double), double support) {
    return {
        .id = "floating_body.archimedes_" + how,
        .source = {Paper::literature, "Archimedes: draft over height = density over the water's"},
        .says =
            "how far the middle of a block of half of the water's density is above the "
            "surface, in spacings; wrong: with 95 % of it",
        .bound = between(
            -0.5, 0.5 * support,
            fmt::format("the floor of the block feels the pressure of particles up to h = {} "
                        "spacings below it, half of that in the mean: up to {} higher; rows of "
                        "particles are known to half a spacing",
                        support, 0.5 * support)),
        .measure = [=] { return height(500.0); },
        .sabotaged = [=] { return height(950.0); }};
}
const Register floating{floats("2d", height_over_surface<2, false>, 2.6),
                        floats("3d", height_over_surface<3, false>, 2.6),
                        floats("dfsph_2d", height_over_surface<2, true>, 2.0),
                        floats("dfsph_3d", height_over_surface<3, true>, 2.0)};
const Register sinking{Claim{
    .id = "floating_body.added_mass",
    .source = {Paper::literature,
               "Lamb 1932, Arts. 68, 91: C = (b² + a²)/(b² − a²) of a cylinder in a cylinder"},
    .says =
        "acceleration of a disc of twice the water's density, just let go, over (s − A)/(s + C A) "
        "with its lift A and the added mass C = 1.1 of its box; wrong: without added mass, C = 0",
    .bound =
        between(0.82, 1.18,
                "C lies between those of the circles around and in the box, 33/31 (b = √2 · 4 "
                "a) and 17/15 (b = 4 a), as added mass falls when the vessel grows: 1.3 %; the "
                "sound of the start crosses the box 6 times: 1/6"),
    .measure = [] { return over_that_with_added_mass(1.1); },
    .sabotaged = [] { return over_that_with_added_mass(0.0); }}};
const Register sunk{Claim{
    .id = "floating_body.rests_on_the_floor",
    .source = {Paper::plumbline, "docstring of CollideBodies"},
    .says =
        "place and turn of a block of three times the water's density that has sunk, off those of "
        "a block on the floor, in spacings; wrong: it is lighter than water",
    .bound =
        at_most(1.0,
                "particles that it caught are under it, at most one layer of them, which is half "
                "a spacing from either wall"),
    .measure = [] { return rest_on_floor(3000.0); },
    .sabotaged = [] { return rest_on_floor(900.0); }}};
}  // namespace
}  // namespace floating_body_claims
