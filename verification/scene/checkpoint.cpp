#include "solver/scene/checkpoint.h"

#include "solver/fluid/rigid_body.h"
#include "solver/foundation/parallel.h"
#include "solver/scene/enforce_constraints.h"
#include "solver/scene/guarded_run.h"
#include "solver/scene/open_flow.h"
#include "verification/framework/registry.h"
#include "verification/scene/scene_texts.h"

#include <algorithm>

namespace checkpoint_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// A state of a simulation, and where in time it is.
struct State {
    double time = 0.0;
    std::string bytes = {};
};

/// `steps` steps from `start`, or from the beginning if that is empty.
State advanced(const SceneFile& scene, const State& start, int steps) {
    const auto simulation = make_simulation(scene);
    if (!start.bytes.empty()) simulation->load(start.bytes);
    GuardedRun run(*simulation, domain_of(scene, simulation->snapshot()));
    run.restart_at(start.time, 0);
    for (int n = 0; n < steps; ++n)
        run.step(next_step(scene, simulation->limits(), run.time(), scene.end));
    State end{run.time()};
    simulation->save(end.bytes);
    return end;
}

/// The state without what its particles have of density: as in a checkpoint that has only positions,
/// velocities and masses.
void forget_density(const SceneFile& scene, std::string& bytes) {
    std::size_t n = 0;
    std::memcpy(&n, bytes.data(), sizeof n);
    const std::size_t vectors = sizeof n + n * sizeof(double) * static_cast<std::size_t>(scene.dim);
    const std::size_t masses = sizeof n + n * sizeof(double);
    const std::vector<double> densities(n, scene.density);
    std::memcpy(bytes.data() + 2 * vectors + masses + sizeof n, densities.data(),
                n * sizeof(double));
}
/// Fluid that begins at rest.
void forget_velocities(const SceneFile& scene, std::string& bytes) {
    std::size_t n = 0;
    std::memcpy(&n, bytes.data(), sizeof n);
    const std::size_t numbers = n * sizeof(double) * static_cast<std::size_t>(scene.dim);
    std::memset(bytes.data() + sizeof n + numbers + sizeof n, 0, numbers);
}
/// The state without the limits of the next step, its last quantity but one.
void forget_limits(const SceneFile&, std::string& bytes) {
    TimeStepLimits limits;
    limits.acoustic = 1e-4;
    std::memcpy(bytes.data() + bytes.size() - sizeof(TakenBySolids) - sizeof limits, &limits,
                sizeof limits);
}

/// The state with no layer of the first emitter out yet.
void forget_emitters(const SceneFile& scene, std::string& bytes) {
    const auto dim = static_cast<std::size_t>(scene.dim);
    const std::size_t vector = dim * sizeof(double);
    const std::size_t body = dim == 2 ? sizeof(RigidBody<2>) : sizeof(RigidBody<3>);
    std::size_t at = 0;
    for (const std::size_t size : {vector, vector, sizeof(double), sizeof(double), vector, vector,
                                   sizeof(double), sizeof(Index), vector, body}) {
        std::size_t n = 0;
        std::memcpy(&n, bytes.data() + at, sizeof n);
        at += sizeof n + n * size;
    }
    std::memset(bytes.data() + at + sizeof at, 0, sizeof(EmitterState));
}

/// A body that falls into the water and one that is pushed through it, fast fluid that comes, and some that goes.
std::string busy(int dim) {
    const auto at = [dim](const std::string& x, const std::string& up) {
        return "[" + x + (dim == 2 ? ", " : ", 0.15, ") + up + "]";
    };
    return "[[body]]\nshape = \"sphere\"\ncentre = " + at("0.8", "0.2") +
           "\nradius = 0.1\ndensity = 2000\nspin = " + (dim == 2 ? "1" : "[1, 2, 3]") +
           "\n[[body]]\nshape = \"box\"\nfixed = true\nvelocity = " +
           (dim == 2 ? "[1, 0]" : "[1, 0, 0]") +
           "\nlow = " + (dim == 2 ? "[0.2, 0.1]" : "[0.2, 0.1, 0.1]") +
           "\nhigh = " + (dim == 2 ? "[0.3, 0.2]" : "[0.3, 0.2, 0.2]") +
           "\n[[emitter]]\ncentre = " + at("0.5", "0.45") +
           "\ndirection = " + (dim == 2 ? "[0, 1]" : "[0, 0, 1]") +
           "\nradius = 0.08\nspeed = 18\n" +
           "[[outflow]]\nshape = \"box\"\nlow = " + (dim == 2 ? "[0.5, 0]" : "[0.5, 0, 0]") +
           "\nhigh = " + (dim == 2 ? "[0.6, 0.1]" : "[0.6, 0.3, 0.1]") +
           "\n[domain]\nlow = " + (dim == 2 ? "[-1, -1]" : "[-1, -1, -1]") +
           "\nhigh = " + (dim == 2 ? "[2, 2]" : "[2, 2, 2]") + "\n";
}

double differences(const std::string& one, const std::string& other) {
    double different = one.size() == other.size() ? 0.0 : HUGE_VAL;
    for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k)
        different += one[k] != other[k];
    return different;
}

using Forget = void (*)(const SceneFile&, std::string&);

/// Bytes in which 6 steps differ from 3, a checkpoint, and 3 more; and 3 steps with one thread from 3 with two.
double different_bytes(int dim, const std::string& method, Forget forget, const std::string& more) {
    const SceneFile scene = SceneFile::parse("scene", dam_break_scene(dim, method, 1.0) + more);
    const int threads = thread_count();
    set_thread_count(2);
    const State half_by_two = advanced(scene, {}, 3);
    set_thread_count(1);
    State half = advanced(scene, {}, 3);
    const double by_threads = differences(half.bytes, half_by_two.bytes);
    const State whole = advanced(scene, {}, 6);
    if (forget) forget(scene, half.bytes);
    const State rest = advanced(scene, half, 3);
    set_thread_count(threads);
    return by_threads + differences(whole.bytes, rest.bytes);
}

Claim continues(const std::string& id, int dim, const std::string& method, Forget forget,
                const std::string& forgotten, const std::string& more = "") {
    return {.id = "checkpoint.continues_bit_for_bit_" + id,
            .source = {Paper::plumbline, "docstring of save_state"},
            .says = "6 steps are 3, a checkpoint, and 3 in a new simulation (" + method +
                    "): bytes of the state that differ, and those after 3 steps with 2 threads; "
                    "not if the checkpoint leaves out " +
                    forgotten,
            .bound = at_most(0.0,
                             "the same operations on the same bits, and no sum depends on "
                             "the threads"),
            .measure = [=] { return different_bytes(dim, method, nullptr, more); },
            .sabotaged = [=] { return different_bytes(dim, method, forget, more); }};
}

const Register claims_of_checkpoint{
    continues("delta_sph_2d", 2, "delta_sph", forget_density, "the density"),
    continues("delta_sph_3d", 3, "delta_sph", forget_density, "the density"),
    continues("dfsph_2d", 2, "dfsph", forget_velocities, "the velocities"),
    continues("dfsph_3d", 3, "dfsph", forget_velocities, "the velocities"),
    continues("sph_2d", 2, "sph", forget_limits, "the limits of the time step"),
    continues("sph_3d", 3, "sph", forget_limits, "the limits of the time step"),
    continues("busy_2d", 2, "delta_sph", forget_emitters, "what emitters have done", busy(2)),
    continues("busy_3d", 3, "delta_sph", forget_emitters, "what emitters have done", busy(3))};
}  // namespace
}  // namespace checkpoint_claims
