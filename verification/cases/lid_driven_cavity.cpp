#include "verification/cases/lid_driven_cavity.h"

#include "solver/fluid/averaged_pressure_force.h"
#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/extrapolated_walls.h"
#include "solver/fluid/no_slip_walls.h"
#include "solver/fluid/particle_shifting.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/particles/lattice.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/one_of.h"
#include "solver/scene/scene.h"
#include "solver/scene/time_step.h"
#include "solver/scene/two_stage.h"

namespace verification {
namespace {
using namespace plumbline;
using W = WendlandC2<2>;

std::vector<MirrorPlane<2>> walls() {
    const auto plane = [](const Vec<2>& point, const Vec<2>& n, double speed) {
        return MirrorPlane<2>{point, n, speed * Vec<2>::Unit(0)};
    };
    const Vec<2> low = Vec<2>::Zero(), high = Vec<2>::Ones(), right = Vec<2>::Unit(0),
                 up = Vec<2>::Unit(1);
    return {plane(low, right, 0.0), plane(high, -right, 0.0), plane(low, up, 0.0),
            plane(high, -up, 1.0)};
}

auto scene_of(const LidDrivenCavity& c) {
    const double d = c.spacing, h = c.support * d, nu = 1.0 / c.reynolds;
    const W w(h);
    const TaitEquation tait(1.0, c.speed_of_sound, 7.0);
    using Stick = OneOf<Skip, StickToWalls<W>>;
    using Viscosity = OneOf<Skip, BrookshawViscosity<W>>;
    Scene scene{Given<Positions<2>, Velocities<2>, Masses, Density, IsWall>{},
                KeepTime{},
                TwoStage{Evolve<2, Density>{}, FindNeighbours<2, CellGrid<2>>{h}, Continuity<W>{w},
                         DensityDiffusion<W>{w, c.diffusion, c.speed_of_sound}, TaitPressure{tait},
                         SwayingFrame<2>{Vec<2>::Zero()}, ExtrapolateToWalls<W>{w, tait},
                         AveragedPressureForce<W>{w},
                         c.sticks ? Stick(StickToWalls<W>{w, walls()}) : Stick(Skip{}),
                         c.sticks ? Viscosity(BrookshawViscosity<W>{w, nu}) : Viscosity(Skip{}),
                         RestWalls<2>{}, HoldWalls<2>{1.0}},
                AcousticLimit<2>{tait, h, c.courant},
                ViscousLimit{nu, h},
                ShiftParticles<W>{w, c.shifting}};
    const double rho = tait.density(c.background);
    const Vec<2> margin = Vec<2>::Constant(std::ceil(c.support) * d);
    for (const Vec<2>& x : lattice<2>({-margin, Vec<2>::Ones() + margin}, d)) {
        const bool inside = (x.array() > 0.0).all() && (x.array() < 1.0).all();
        scene.template get<Positions<2>>().push_back(x);
        scene.template get<IsWall>().push_back(inside ? 0 : 1);
    }
    const std::size_t n = scene.template get<Positions<2>>().size();
    scene.template get<Velocities<2>>().assign(n, Vec<2>::Zero());
    scene.template get<Density>().assign(n, rho);
    scene.template get<Masses>().assign(n, rho * d * d);
    return scene;
}

/// Σ vⱼ ωⱼ / Σ ωⱼ over the fluid.
Vec<2> velocity_at(const Vec<2>& at, const Positions<2>& x, const Velocities<2>& v,
                   const IsWall& wall, const W& w) {
    Vec<2> sum = Vec<2>::Zero();
    double weights = 0.0;
    for (std::size_t j = 0; j < x.size(); ++j) {
        const double r = (x[j] - at).norm();
        if (wall[j] != 0 || r >= w.support()) continue;
        sum += w.value(r) * v[j], weights += w.value(r);
    }
    return weights > 0.0 ? Vec<2>(sum / weights) : Vec<2>::Constant(NAN);
}
}  // namespace

CavityProfiles profiles_of(const LidDrivenCavity& c, const std::vector<double>& y,
                           const std::vector<double>& x, double latest) {
    auto scene = scene_of(c);
    const auto& at = scene.get<Positions<2>>();
    const auto& v = scene.get<Velocities<2>>();
    const auto& wall = scene.get<IsWall>();
    const W w(2.0 * c.spacing);
    constexpr int samples = 20;
    int quiet = 0;
    CavityProfiles now;
    double energy_before = 0.0, t = 0.0;
    scene.step(0.0);
    for (int second = 1;; ++second) {
        now = {std::vector<double>(y.size()), std::vector<double>(x.size()), 0.0, 0.0};
        double energy = 0.0;
        for (int sample = 1; sample <= samples; ++sample) {
            const double until = second - 1.0 + static_cast<double>(sample) / samples;
            while (t < until) {
                const double dt = std::min(scene.get<TimeStepLimits>().smallest(), until - t);
                scene.step(dt);
                t = dt == until - t ? until : t + dt;
            }
            for (const Vec<2>& v_i : v) energy += v_i.squaredNorm() / samples;
            for (std::size_t k = 0; k < y.size(); ++k)
                now.u[k] += velocity_at({0.5, y[k]}, at, v, wall, w)[0] / samples;
            for (std::size_t k = 0; k < x.size(); ++k)
                now.v[k] += velocity_at({x[k], 0.5}, at, v, wall, w)[1] / samples;
        }
        now.time = t, now.change_per_time = std::abs(energy / energy_before - 1.0);
        energy_before = energy;
        constexpr double little = 2e-3;
        quiet = now.change_per_time < little ? quiet + 1 : 0;
        if (quiet == 3 || t >= latest) return now;
    }
}

}  // namespace verification
