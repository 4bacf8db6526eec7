#include "verification/cases/manufactured_flow.h"

#include "solver/fluid/averaged_pressure_force.h"
#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/density_diffusion.h"
#include "solver/fluid/monaghan_viscosity.h"
#include "solver/fluid/particle_shifting.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/sph_density.h"
#include "solver/fluid/tait_equation.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/jittered.h"
#include "solver/scene/advance.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/two_stage.h"

#include <numbers>

namespace verification {
namespace {
using namespace plumbline;
using Box2 = PeriodicBox<2>;
using Search = CellGrid<2, Box2>;
using W = WendlandC2<2>;

constexpr double k = 2.0 * std::numbers::pi;
Box2 box() { return {Vec<2>::Zero(), Vec<2>::Ones()}; }

/// The time, of every particle, since passes within a step are not told of it.
struct Clock : Each<double> {
    static constexpr std::string_view name = "clock";
};
struct ClockTicks {
    using Reads = Quantities<>;
    using Writes = Quantities<Rate<Clock>>;
    void run(double, Rate<Clock>& rate) const { std::ranges::fill(rate, 1.0); }
};
struct ManufacturedForce {
    using Reads = Quantities<Positions<2>, Clock>;
    using Writes = Quantities<Accelerations<2>>;
    double factor;
    void run(double, const Positions<2>& x, const Clock& t, Accelerations<2>& a) const {
        for (std::size_t i = 0; i < x.size(); ++i)
            a[i] += factor * ManufacturedFlow::force(x[i], t[i]);
    }
};

/// Particles at rest in their places, with the exact fields at t = 0.
struct Snapshot {
    Positions<2> x;
    Velocities<2> v;
    Masses m;
    Density rho;
    Pressure p;
    Neighbourhood<2, Box2> near;
    double h;

    explicit Snapshot(const ManufacturedSamples& s) : h{s.support * s.spacing} {
        for (const Vec<2>& at :
             jittered<2>({box().low(), box().high()}, s.spacing, s.jitter, s.seed)) {
            x.push_back(at);
            v.push_back(ManufacturedFlow::velocity(at, 0.0));
            p.push_back(ManufacturedFlow::pressure(at, 0.0));
        }
        m.assign(x.size(), s.spacing * s.spacing);
        rho.assign(x.size(), 1.0);
        FindNeighbours<2, Search>{h, Search(box())}.run(0.0, x, near);
        SphDensity<W, Box2>{W(h)}.run(0.0, x, m, near, rho);
    }
};

template <class Errors> TermErrors mean_and_largest(std::size_t n, Errors error) {
    TermErrors result{0.0, 0.0};
    for (std::size_t i = 0; i < n; ++i) {
        const double e = error(i);
        result.mean += e / static_cast<double>(n);
        result.largest = std::max(result.largest, e);
    }
    return result;
}
template <class Force>
TermErrors errors_of_pressure(const Snapshot& s, const Force& force, double factor = 1.0) {
    Accelerations<2> a;
    a.assign(s.x.size(), Vec<2>::Zero());
    force.run(0.0, s.x, s.m, s.rho, s.p, s.near, a);
    return mean_and_largest(a.size(), [&](std::size_t i) {
        return (factor * a[i] + ManufacturedFlow::pressure_gradient(s.x[i], 0.0)).norm();
    });
}
/// Of Δv, by a force of μ = 1.
template <class Force> TermErrors errors_of_viscosity(const Snapshot& s, const Force& force) {
    Accelerations<2> a;
    a.assign(s.x.size(), Vec<2>::Zero());
    force.run(0.0, s.x, s.v, s.m, s.rho, s.near, a);
    return mean_and_largest(a.size(), [&](std::size_t i) {
        return (a[i] - ManufacturedFlow::laplacian(s.x[i], 0.0)).norm();
    });
}
TermErrors errors_of_continuity(const Snapshot& s) {
    Rate<Density> rate;
    rate.assign(s.x.size(), 0.0);
    Continuity<W, Box2>{W(s.h)}.run(0.0, s.x, s.v, s.m, s.near, rate);
    return mean_and_largest(rate.size(), [&](std::size_t i) { return std::abs(rate[i]); });
}
TermErrors errors_of_divergence(const Snapshot& s) {
    return mean_and_largest(s.x.size(), [&](std::size_t i) {
        return std::abs(s.near.sum<double>(s.x, Index(i), [&](const Neighbour<2>& n) -> double {
            return s.m[n.j] * s.v[n.j].dot(gradient(W(s.h), n));
        }));
    });
}
}  // namespace

Vec<2> ManufacturedFlow::velocity(const Vec<2>& x, double t) {
    return std::exp(-t) * Vec<2>(std::sin(k * x[0]) * std::cos(k * x[1]),
                                 -std::cos(k * x[0]) * std::sin(k * x[1]));
}
double ManufacturedFlow::pressure(const Vec<2>& x, double t) {
    return 0.5 * std::exp(-t) * std::cos(k * x[0]) * std::cos(2.0 * k * x[1]);
}
Vec<2> ManufacturedFlow::pressure_gradient(const Vec<2>& x, double t) {
    return -k * std::exp(-t) *
           Vec<2>(0.5 * std::sin(k * x[0]) * std::cos(2.0 * k * x[1]),
                  std::cos(k * x[0]) * std::sin(2.0 * k * x[1]));
}
Vec<2> ManufacturedFlow::laplacian(const Vec<2>& x, double t) {
    return -2.0 * k * k * velocity(x, t);
}
Vec<2> ManufacturedFlow::force(const Vec<2>& x, double t) {
    const double e2 = std::exp(-2.0 * t);  // v·∇v = k/2 (sin 2kx, sin 2ky) e^(−2t)
    const Vec<2> advection =
        0.5 * k * e2 * Vec<2>(std::sin(2.0 * k * x[0]), std::sin(2.0 * k * x[1]));
    return -velocity(x, t) + advection + pressure_gradient(x, t) - viscosity * laplacian(x, t);
}

TermErrors errors_of_term(const ManufacturedSamples& samples, Term term) {
    const Snapshot s(samples);
    const W w(s.h);
    switch (term) {
        case Term::continuity:
            return errors_of_continuity(s);
        case Term::divergence_alone:
            return errors_of_divergence(s);
        case Term::pressure:
            return errors_of_pressure(s, PressureForce<W, Box2>{w});
        case Term::averaged_pressure:
            return errors_of_pressure(s, AveragedPressureForce<W, Box2>{w});
        case Term::printed_averaged_pressure:
            return errors_of_pressure(s, AveragedPressureForce<W, Box2>{w}, 0.5);
        case Term::brookshaw:
            return errors_of_viscosity(s, BrookshawViscosity<W, Box2>{w, 1.0});
        case Term::monaghan:
            return errors_of_viscosity(s, MonaghanViscosity<W, Box2>{w, 1.0});
    }
    throw InvalidInput("manufactured flow: expected one of its terms");
}

TermErrors errors_of_run(const ManufacturedSamples& samples, double force) {
    constexpr double duration = 0.5, c0 = 10.0, nu = ManufacturedFlow::viscosity;
    const Snapshot start(samples);
    const double h = start.h;
    const W w(h);
    const TaitEquation tait(1.0, c0, 7.0);
    Scene scene{Given<Positions<2>, Velocities<2>, Masses, Density, Clock>{},
                WrapIntoBox<2>{box()},
                TwoStage{Evolve<2, Density, Clock>{}, WrapIntoBox<2>{box()},
                         FindNeighbours<2, Search>{h, Search(box())}, ClockTicks{},
                         Continuity<W, Box2>{w}, DensityDiffusion<W, Box2>{w, 0.1, c0},
                         TaitPressure{tait}, AveragedPressureForce<W, Box2>{w},
                         BrookshawViscosity<W, Box2>{w, nu}, ManufacturedForce{force}},
                AcousticLimit<2>{tait, h, 0.4},
                ViscousLimit{nu, h},
                ShiftParticles<W, Box2>{w, 20.0}};
    scene.get<Positions<2>>() = start.x;
    scene.get<Velocities<2>>() = start.v;
    for (std::size_t i = 0; i < start.x.size(); ++i) {
        scene.get<Density>().push_back(tait.density(start.p[i]));
        scene.get<Masses>().push_back(scene.get<Density>().back() * start.m[i]);
    }
    scene.get<Clock>().assign(start.x.size(), 0.0);
    advance_by_limits(scene, duration);
    const auto& x = scene.get<Positions<2>>();
    const auto& v = scene.get<Velocities<2>>();
    return mean_and_largest(x.size(), [&](std::size_t i) {
        return (v[i] - ManufacturedFlow::velocity(x[i], duration)).norm() * std::exp(duration);
    });
}

}  // namespace verification
