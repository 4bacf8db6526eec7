#include "solver/fluid/dfsph.h"

#include "solver/fluid/continuity.h"
#include "solver/fluid/ghost_continuity.h"
#include "solver/fluid/ghost_density.h"
#include "solver/fluid/rigid_coupling.h"
#include "solver/particles/lattice.h"
#include "solver/scene/one_of.h"
#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace dfsph_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double h = 2.6, dt = 0.1, tolerance = 1e-6;
constexpr double rho0 =
    0.7;  // less than the density inside, so that there is something to push apart
template <int Dim> using W = WendlandC2<Dim>;
/// What is done to the solve, to see that it would be noticed.
enum class Fault { none, no_walls, half_walls };

/// Ghosts that count once in the solve.
template <int Dim> struct HalveWalls {
    using Reads = Quantities<>;
    using Writes = Quantities<PairGradients<double, Dim>>;
    bool wanted;
    void run(double, PairGradients<double, Dim>& pairs) const {
        if (!wanted) return;
        for (auto& wall : pairs.walls) wall *= 0.5;
        for (double& flow : pairs.flow_of_walls) flow *= 0.5;
    }
};

/// Disordered particles of unequal masses and random velocities on a floor of two layers of ghosts: 1 is the
/// spacing and the mean density inside.
template <int Dim> struct Heap {
    Drop<Dim> drop{Dim == 2 ? 5.0 : 3.0};
    Points<Dim> ghosts;

    Heap() {
        const double radius = Dim == 2 ? 5.0 : 3.0;
        for (auto& x : drop.x) x[Dim - 1] += radius;
        Vec<Dim> low = Vec<Dim>::Constant(-8.0), high = -low;
        low[Dim - 1] = -2.0, high[Dim - 1] = 0.0;
        ghosts = lattice<Dim>({low, high}, 1.0);
    }
    template <class... Passes> auto scene(bool with_walls, Passes... passes) const {
        Scene scene{StartOfDrop<Dim>{},
                    Given<GhostPositions<Dim>, GhostVelocities<Dim>, GhostMasses>{},
                    FindNeighbours<Dim, BruteForce<Dim>>{h},
                    FindGhosts<Dim, BruteForce<Dim>>{h},
                    SphDensity<W<Dim>>{W<Dim>(h)},
                    AddGhostDensity<W<Dim>>{W<Dim>(h)},
                    passes...};
        fill(scene, drop);
        if (with_walls) {
            scene.template get<GhostPositions<Dim>>().assign(ghosts.begin(), ghosts.end());
            scene.template get<GhostVelocities<Dim>>().assign(ghosts.size(),
                                                              0.2 * Vec<Dim>::Unit(Dim - 1));
            scene.template get<GhostMasses>().assign(ghosts.size(), 1.0);
        }
        return scene;
    }
};

/// The velocities after one step in which nothing is moved.
template <int Dim, template <int, class> class Solver>
std::vector<Vec<Dim>> solved(const Heap<Dim>& heap, Fault fault) {
    auto scene = heap.scene(fault != Fault::no_walls, CollectGradients<W<Dim>>{W<Dim>(h)},
                            HalveWalls<Dim>{fault == Fault::half_walls},
                            Solver<Dim, double>{rho0, {.tolerance = tolerance, .most = 2000}});
    scene.step(dt);
    return scene.template get<Velocities<Dim>>();
}
/// Σ max(0, error(ρᵢ, dρᵢ/dt)) / n for these velocities, by the passes of weakly compressible fluids; ghosts count twice.
template <int Dim, class Error>
double mean_error(Heap<Dim> heap, const std::vector<Vec<Dim>>& v, Error error) {
    heap.drop.v = v;
    auto scene = heap.scene(true, Continuity<W<Dim>>{W<Dim>(h)}, GhostContinuity<W<Dim>>{W<Dim>(h)},
                            GhostContinuity<W<Dim>>{W<Dim>(h)});
    scene.step(dt);
    const auto& rho = scene.template get<Density>();
    const auto& rate = scene.template get<Rate<Density>>();
    double total = 0.0;
    for (std::size_t i = 0; i < rho.size(); ++i) total += std::max(0.0, error(rho[i], rate[i]));
    return total / static_cast<double>(rho.size());
}
template <int Dim> double error_of_density(Fault fault) {
    const Heap<Dim> heap;
    return mean_error<Dim>(heap, solved<Dim, ConstantDensity>(heap, fault),
                           [](double rho, double rate) { return (rho + dt * rate) / rho0 - 1.0; });
}
template <int Dim> double error_of_divergence(Fault fault) {
    const Heap<Dim> heap;
    return mean_error<Dim>(
        heap, solved<Dim, ZeroDivergence>(heap, fault),
        [](double rho, double rate) { return rho < 0.75 * rho0 ? 0.0 : dt * rate / rho0; });
}
/// ‖Σ mᵢ Δvᵢ‖ / Σ mᵢ ‖Δvᵢ‖ and ‖Σ xᵢ × mᵢ Δvᵢ‖ / Σ …, the larger, of a free drop; with masses of 1 if they are left out.
template <int Dim> double change_of_momentum(bool with_masses) {
    const Heap<Dim> heap;
    const auto v = solved<Dim, ConstantDensity>(heap, Fault::no_walls);
    Vec<Dim> linear = Vec<Dim>::Zero();
    Vec<3> angular = Vec<3>::Zero();
    double p = 0.0, l = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vec<Dim>& x = heap.drop.x[i];
        const Vec<Dim> impulse = (with_masses ? heap.drop.m[i] : 1.0) * (v[i] - heap.drop.v[i]);
        linear += impulse, p += impulse.norm();
        angular += cross<Dim>(x, impulse), l += x.norm() * impulse.norm();
    }
    return std::max(linear.norm() / p, angular.norm() / l);
}

/// ‖Σ mᵢ Δvᵢ + Δt F‖ / Σ mᵢ ‖Δvᵢ‖ with the force F on the floor, a body that gets what the fluid loses in one step.
template <int Dim> double lost_to_floor(bool both_solves) {
    const Heap<Dim> heap;
    using Pass = OneOf<Skip, AddPressureOfDivergence>;
    auto scene = heap.scene(true, Given<BodyOfGhost, PlaceInBody<Dim>>{}, Given<RigidBodies<Dim>>{},
                            CollectGradients<W<Dim>>{W<Dim>(h)}, ZeroDivergence<Dim>{rho0},
                            ConstantDensity<Dim>{rho0},
                            both_solves ? Pass(AddPressureOfDivergence{}) : Pass(Skip{}),
                            ForgetForces<Dim>{}, PressureOnBodies<W<Dim>>{W<Dim>(h)});
    scene.template get<RigidBodies<Dim>>().resize(1);
    scene.template get<BodyOfGhost>().assign(heap.ghosts.size(), 0);
    scene.template get<PlaceInBody<Dim>>().assign(heap.ghosts.begin(), heap.ghosts.end());
    scene.step(dt);
    const auto& v = scene.template get<Velocities<Dim>>();
    Vec<Dim> lost = dt * scene.template get<RigidBodies<Dim>>()[0].force;
    double all = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vec<Dim> impulse = heap.drop.m[i] * (v[i] - heap.drop.v[i]);
        lost += impulse, all += impulse.norm();
    }
    return lost.norm() / all;
}

const char* const its_own_tolerance =
    "the tolerance of the solve, 1e-6, and rounding, 100 · 1.1e-16, which is nothing beside it";

const Register density{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "dfsph.density_after_the_solve",
                 .source = {Paper::literature, "Bender and Koschier 2017, Algorithm 3"},
                 .says =
                     "mean of max(0, ρ + Δt dρ/dt − ρ₀)/ρ₀, of a heap on a moving floor, by "
                     "Continuity and GhostContinuity; with a solve that leaves out the floor "
                     "it is not solved",
                 .bound = at_most(1.001 * tolerance, its_own_tolerance),
                 .measure = [] { return error_of_density<D>(Fault::none); },
                 .sabotaged = [] { return error_of_density<D>(Fault::no_walls); }};
})};
const Register divergence{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "dfsph.divergence_after_the_solve",
        .source = {Paper::literature, "Bender and Koschier 2017, Algorithm 2"},
        .says =
            "mean of max(0, Δt dρ/dt)/ρ₀ where the fluid is dense; with ghosts that count once in "
            "the solve too much of the floor's motion is left",
        .bound = at_most(1.001 * tolerance, its_own_tolerance),
        .measure = [] { return error_of_divergence<D>(Fault::none); },
        .sabotaged = [] { return error_of_divergence<D>(Fault::half_walls); }};
})};
const Register momentum{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "dfsph.conserves_momentum",
                 .source = {Paper::plumbline, "docstring of project"},
                 .says =
                     "linear and angular momentum that the solve gives to a free drop, over the "
                     "sum of what it gives to its particles; wrong: equal masses",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return change_of_momentum<D>(true); },
                 .sabotaged = [] { return change_of_momentum<D>(false); }};
})};
const Register exchange{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "dfsph.gives_bodies_what_it_takes",
                 .source = {Paper::plumbline, "docstring of AddPressureOfDivergence"},
                 .says =
                     "momentum of a heap and of the floor together after one step, over the sum of "
                     "what particles "
                     "got; wrong: the body feels the pressure of the second solve only",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return lost_to_floor<D>(true); },
                 .sabotaged = [] { return lost_to_floor<D>(false); }};
})};
}  // namespace
}  // namespace dfsph_claims
