#include "verification/stability/lattice_fluid.h"

#include "solver/fluid/artificial_viscosity.h"
#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/laplacian_viscosity.h"
#include "solver/fluid/monaghan_viscosity.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/sph_density.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/xsph.h"
#include "solver/foundation/random.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/one_of.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"
#include "verification/stability/lattice_waves.h"

namespace verification {
namespace {
using namespace plumbline;
using Box = PeriodicBox<2>;
using W = AnyKernel<2>;
using Forces = OneOf<Skip, PressureForce<W, Box>>;
using Averages = OneOf<Skip, AverageVelocities<W, Box>>;
using Smoothing = OneOf<Skip, XsphVelocities<2>>;
using Viscosities = OneOf<Skip, BrookshawViscosity<W, Box>, MonaghanViscosity<W, Box>,
                          LaplacianViscosity<W, Box>, ArtificialViscosity<W, Box>>;

Forces forces_of(const LatticeFluid& f) {
    if (!f.pressure) return Skip{};
    return PressureForce<W, Box>{f.w};
}
Averages averages_of(const LatticeFluid& f) {
    if (f.xi == 0.0) return Skip{};
    return AverageVelocities<W, Box>{f.w};
}
Smoothing smoothing_of(const LatticeFluid& f, double dt) {
    if (f.xi == 0.0) return Skip{};
    return XsphVelocities<2>{{f.xi, dt}};
}
/// The artificial one with the α that gives ν = 1: ν = α c h/16 in the plane, h half of the support.
Viscosities viscosity_of(const LatticeFluid& f, double density) {
    switch (f.viscosity) {
        case ViscousForm::brookshaw:
            return BrookshawViscosity<W, Box>{f.w, density};
        case ViscousForm::monaghan:
            return MonaghanViscosity<W, Box>{f.w, density};
        case ViscousForm::laplacian:
            return LaplacianViscosity<W, Box>{f.w, density};
        case ViscousForm::artificial:
            return ArtificialViscosity<W, Box>{f.w, 16.0 / f.w.support(), 1.0};
        case ViscousForm::none:
            break;
    }
    return Skip{};
}

/// The particles hardly move, so their neighbours are found once.
struct FindOnce {
    using Reads = Quantities<Positions<2>>;
    using Writes = Quantities<Neighbourhood<2, Box>>;
    FindNeighbours<2, CellGrid<2, Box>> find;

    void run(double dt, const Positions<2>& x, Neighbourhood<2, Box>& near) const {
        if (!near.space) find.run(dt, x, near);
    }
};

auto scene_of(const LatticeFluid& f, double dt) {
    const Box box(Vec<2>::Zero(), size_of_lattice());
    const W w = kernel_of_density(f);
    const double density = density_on(w, neighbours_on(hexagonal, w.support()));
    Scene scene{Given<Positions<2>, Velocities<2>, Masses>{},
                FindOnce{{w.support(), CellGrid<2, Box>(box)}},
                SphDensity<W, Box>{w},
                TaitPressure{TaitEquation(density / (1.0 + f.compression), 1.0, 7.0)},
                averages_of(f),
                smoothing_of(f, dt),
                forces_of(f),
                viscosity_of(f, density),
                SymplecticEuler<2>{}};
    auto& x = scene.get<Positions<2>>();
    auto& v = scene.get<Velocities<2>>();
    const auto points = points_of_lattice();
    x.assign(points.begin(), points.end());
    Random random(1);
    for (std::size_t i = 0; i < x.size(); ++i)
        v.push_back(1e-9 * Vec<2>(random.uniform(-1, 1), random.uniform(-1, 1)));
    scene.get<Masses>().assign(x.size(), 1.0);
    return scene;
}
double norm_of(const Points<2>& v) {
    double squares = 0.0;
    for (const Vec<2>& v_i : v) squares += v_i.squaredNorm();
    return std::sqrt(squares);
}
}  // namespace

bool grows(const LatticeFluid& fluid, double dt) {
    auto scene = scene_of(fluid, dt);
    const auto& v = scene.get<Velocities<2>>();
    const double start = norm_of(v);
    for (int n = 0; n < 500; ++n) {
        scene.step(dt);
        if (!(norm_of(v) < 100.0 * start)) return true;
    }
    return false;
}

double growth_rate(const LatticeFluid& fluid, double dt, double duration) {
    auto scene = scene_of(fluid, dt);
    const Points<2> lattice = scene.get<Positions<2>>();
    auto& x = scene.get<Positions<2>>();
    auto& v = scene.get<Velocities<2>>();
    const double start = norm_of(v);
    double scaled = 0.0, at_half = 0.0;  // logarithms
    const auto logarithm = [&] { return scaled + std::log(norm_of(v) / start); };
    const int steps = static_cast<int>(std::ceil(duration / dt)), half = steps / 2;
    for (int n = 0; n < steps; ++n) {
        if (n == half) at_half = logarithm();
        scene.step(dt);
        if (const double factor = norm_of(v) / start; factor > 1e3) {
            scaled += std::log(factor);
            for (std::size_t i = 0; i < v.size(); ++i) {
                v[i] /= factor;
                x[i] = lattice[i] + (x[i] - lattice[i]) / factor;
            }
        }
    }
    const double end = logarithm();
    return end < std::log(10.0) ? 0.0 : (end - at_half) / (dt * (steps - half));
}

}  // namespace verification
