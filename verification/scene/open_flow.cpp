#include "solver/scene/open_flow.h"

#include "solver/foundation/random.h"
#include "solver/scene/guarded_run.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace open_flow_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// A jet along x, of 8 particles or of the 32 of a disc, at speed 2, without gravity; out of it all that is beyond x = 0.6.
std::string jet(int dim, const std::string& method) {
    const bool plane = dim == 2;
    return "title = \"jet\"\ndim = " + std::to_string(dim) + "\nmethod = \"" + method +
           "\"\n[particles]\nspacing = 0.05\n[fluid]\ndensity = 1000\nspeed_of_sound = 30\n"
           "[[emitter]]\ncentre = " +
           (plane ? "[0, 0.5]" : "[0, 0.5, 0.5]") +
           "\ndirection = " + (plane ? "[1, 0]" : "[1, 0, 0]") +
           "\nradius = " + (plane ? "0.2" : "0.16") +
           "\nspeed = 2\n[[outflow]]\nshape = \"plane\"\npoint = " +
           (plane ? "[0.6, 0]" : "[0.6, 0, 0]") +
           "\nnormal = " + (plane ? "[-1, 0]" : "[-1, 0, 0]") +
           "\n[domain]\nlow = " + (plane ? "[-0.1, 0]" : "[-0.1, 0, 0]") +
           "\nhigh = " + (plane ? "[1, 1]" : "[1, 1, 1]") +
           "\n[time]\nend = 0.5\n[output]\ninterval = 0.5\npicture = \"none\"\n";
}
struct Flow {
    double layers_off = 0.0;  // |mass − ρ A v t| over the mass of a layer, at most
    double lost = 0.0;        // |emitted − removed − there|, particles
    double removed = 0.0;     // particles
};
/// All of it after every step of 0.5 s; the mass is compared with that of an emitter `wider` times as large.
Flow flow(int dim, const std::string& method, double end, double wider) {
    const SceneFile scene = SceneFile::parse("jet", jet(dim, method));
    const auto simulation = make_simulation(scene);
    GuardedRun run(*simulation, domain_of(scene, simulation->snapshot()));
    const double per_layer = dim == 2 ? 8.0 : 32.0;
    Flow found;
    while (run.time() < end) {
        const double time = run.time();
        run.step(next_step(scene, simulation->limits(), run.time(), end));
        const Snapshot s = simulation->snapshot();
        // What a step emits belongs to the time of its beginning.
        const double layers = s.emitted.particles / per_layer;
        found.layers_off =
            std::max(found.layers_off, std::abs(layers - wider * 2.0 * time / scene.spacing));
        found.lost = std::max(found.lost, std::abs(s.emitted.particles - s.removed.particles -
                                                   static_cast<double>(s.size())));
        found.removed = s.removed.particles;
    }
    return found;
}

Claim mass_that_comes(int dim, const std::string& method) {
    return {.id = "open_flow.mass_that_comes_" + method + "_" + std::to_string(dim) + "d",
            .source = {Paper::plumbline, "docstring of OpenFlow"},
            .says =
                "mass of a jet against ρ A v t in 0.5 s of steps that adapt, in masses of a layer "
                "(" +
                method + "); wrong: an area a tenth larger",
            .bound = at_most(1.0 + 1e-6, "layers come whole: at most one is on its way"),
            .measure = [=] { return flow(dim, method, 0.5, 1.0).layers_off; },
            .sabotaged = [=] { return flow(dim, method, 0.5, 1.1).layers_off; }};
}
const Register masses{mass_that_comes(2, "delta_sph"), mass_that_comes(2, "sph"),
                      mass_that_comes(2, "dfsph"), mass_that_comes(3, "delta_sph")};
const Register account{
    Claim{.id = "open_flow.all_are_accounted_for",
          .source = {Paper::plumbline, "docstring of OpenFlow"},
          .says = "particles that came, less those that went and those that are there, after any "
                  "step; wrong: those that went, before any did",
          .bound = at_most(0.0, "whole numbers"),
          .measure = [] { return flow(2, "delta_sph", 0.5, 1.0).lost; },
          .sabotaged = [] { return flow(2, "delta_sph", 0.5, 1.0).removed; }}};
/// The closest two particles of a jet, in spacings, after 100 steps of different lengths; with `late`, layers begin at
/// the emitter whenever they come.
template <int Dim> double closest_in_jet(bool late) {
    const double d = 0.1;
    Vec<Dim> direction = Vec<Dim>::Ones();
    direction[0] = -2.0;
    const OpenFlow<Dim> flow{{{.centre = Vec<Dim>::Constant(0.3),
                               .direction = direction.normalized(),
                               .radius = 0.25,
                               .speed = 1.0,
                               .spacing = d,
                               .mass = 1.0,
                               .density = 1.0}},
                             {}};
    const Emitter<Dim>& e = flow.emitters[0];
    Positions<Dim> x;
    Velocities<Dim> v;
    Masses m;
    Density rho;
    EmitterStates states;
    states.resize(1);
    Random random(3);
    for (int step = 0; step < 100; ++step) {
        const std::size_t before = x.size();
        flow.emit(x, v, m, rho, states);
        for (std::size_t i = before; i < x.size() && late; ++i)
            x[i] -= e.direction.dot(x[i] - e.centre) * e.direction;
        const double dt = random.uniform(0.001, 0.04);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
        states[0].time += dt;
    }
    double closest = HUGE_VAL;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) closest = std::min(closest, (x[i] - x[j]).norm() / d);
    return closest - states[0].blocked;
}
const Register apart{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "open_flow.layers_stay_apart",
                 .source = {Paper::plumbline, "docstring of OpenFlow"},
                 .says =
                     "the closest two particles of a jet, in spacings, less those that found no "
                     "room; wrong: layers begin where the emitter is, not where they would be by "
                     "now",
                 .bound = at_least(1.0 - 1e-12,
                                   "a lattice moves as a whole; 100 additions, each "
                                   "rounded by 4e-16 of a way below 4, over 0.1"),
                 .measure = [] { return closest_in_jet<Dim>(false); },
                 .sabotaged = [] { return closest_in_jet<Dim>(true); }};
})};
}  // namespace
}  // namespace open_flow_claims
