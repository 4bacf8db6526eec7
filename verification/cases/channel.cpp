#include "verification/cases/channel.h"

#include <numbers>

namespace verification {
namespace {
using namespace plumbline;

/// Fills the fluid, under the pressure of a column at rest with g = 1 m/s² if there is no lid, and three layers of ghosts per wall.
template <class Scene>
void fill(Scene& scene, const Channel& c, double width, const TaitEquation& tait) {
    const double d = c.spacing, wall = 3.0 * d, hydrostatic = 1.0;  // ρ₀ g of g = 1
    for (const Vec<2>& x : lattice<2>({Vec<2>(0.0, -wall), Vec<2>(width, 1.0 + wall)}, d)) {
        if (x[1] > 0.0 && x[1] < 1.0) {
            const double pressure = c.lid ? 0.0 : hydrostatic * (1.0 - x[1]);
            scene.template get<Positions<2>>().push_back(x);
            scene.template get<Density>().push_back(tait.density(pressure));
        } else if (x[1] < 0.0 || c.lid) {
            scene.template get<GhostPositions<2>>().push_back(x);
            scene.template get<GhostVelocities<2>>().push_back(
                Vec<2>(x[1] > 0.5 ? c.speed_of_lid : 0.0, 0.0));
        }
    }
    const std::size_t n = scene.template get<Positions<2>>().size();
    scene.template get<Velocities<2>>().assign(n, Vec<2>::Zero());
    for (const double rho : scene.template get<Density>())
        scene.template get<Masses>().push_back(rho * d * d);
    scene.template get<GhostMasses>().assign(scene.template get<GhostPositions<2>>().size(), d * d);
}

/// Without end along x, after `width`.
auto scene_of(const Channel& c, double width) {
    using Box = PeriodicBox<2>;
    using Search = CellGrid<2, Box>;
    using W = WendlandC2<2>;
    const double h = c.support * c.spacing, c0 = c.speed_of_sound;
    const W w(h);
    const TaitEquation tait(1.0, c0, 7.0);
    const Box box(Vec<2>(0.0, -1.0), Vec<2>(width, 2.0));
    Scene scene{Given<Positions<2>, Velocities<2>, Masses, Density>{},
                Given<GhostPositions<2>, GhostVelocities<2>, GhostMasses>{},
                WrapIntoBox<2>{box},
                TwoStage{Evolve<2, Density>{}, WrapIntoBox<2>{box},
                         FindNeighbours<2, Search>{h, Search(box)},
                         FindGhosts<2, Search>{h, Search(box)}, Continuity<W, Box>{w},
                         GhostContinuity<W, Box>{w}, DensityDiffusion<W, Box>{w, c.diffusion, c0},
                         TaitPressure{tait}, Gravity<2>{c.gravity}, PressureForce<W, Box>{w},
                         GhostPressureForce<W, Box>{w}, BrookshawViscosity<W, Box>{w, c.viscosity},
                         GhostViscosity<W, Box>{w, c.slip ? 0.0 : c.viscosity}},
                AcousticLimit<2>{tait, h, c.courant},
                ViscousLimit{c.viscosity, h}};
    fill(scene, c, width, tait);
    return scene;
}

/// ∇ (cos kx cosh ky / sinh k) / k: the velocity of a standing wave of depth 1, 1 m/s at its surface.
Vec<2> velocity_of_wave(double k, const Vec<2>& x) {
    return Vec<2>(-std::sin(k * x[0]) * std::cosh(k * x[1]),
                  std::cos(k * x[0]) * std::sinh(k * x[1])) /
           std::sinh(k);
}
}  // namespace

ChannelState simulate(const Channel& c, double duration) {
    auto scene = scene_of(c, 8.0 * c.spacing);
    ChannelState end;
    end.steps = advance_by_limits(scene, duration);
    end.x = scene.get<Positions<2>>();
    end.v = scene.get<Velocities<2>>();
    end.pressure = scene.get<Pressure>();
    return end;
}

StandingWave standing_wave(Channel c, double steepness) {
    constexpr double length = 2.0, k = std::numbers::pi;
    c.lid = false, c.slip = true;
    auto scene = scene_of(c, length);
    const Points<2> start = scene.get<Positions<2>>();
    auto& v = scene.get<Velocities<2>>();
    const double speed = steepness / k * std::sqrt(-c.gravity[1] * k * std::tanh(k));
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = speed * velocity_of_wave(k, start[i]);
    const auto share = [&] {  // of the wave that is left, by its own velocities
        double sum = 0.0, whole = 0.0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const Vec<2> u = velocity_of_wave(k, start[i]);
            sum += v[i].dot(u), whole += speed * u.squaredNorm();
        }
        return sum / whole;
    };
    scene.step(0.0);
    double t = 0.0, before = 1.0, crossing = 0.0;
    const double latest = 10.0 / std::sqrt(k);
    while (t < (crossing > 0.0 ? 2.0 * crossing : latest)) {
        const double dt = scene.get<TimeStepLimits>().smallest();
        scene.step(dt), t += dt;
        const double now = share();
        if (crossing == 0.0 && now <= 0.0) crossing = t - dt * now / (now - before);
        before = now;
    }
    return {0.5 * std::numbers::pi / crossing, -std::log(-before)};
}

}  // namespace verification
