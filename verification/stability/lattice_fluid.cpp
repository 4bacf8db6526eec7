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
/// What a composition chooses from.
template <int Dim> struct Choices {
    using Box = PeriodicBox<Dim>;
    using W = AnyKernel<Dim>;
    using Forces = OneOf<Skip, PressureForce<W, Box>>;
    using Averages = OneOf<Skip, AverageVelocities<W, Box>>;
    using Smoothing = OneOf<Skip, XsphVelocities<Dim>>;
    using Viscosities = OneOf<Skip, BrookshawViscosity<W, Box>, MonaghanViscosity<W, Box>,
                              LaplacianViscosity<W, Box>, ArtificialViscosity<W, Box>>;

    static Forces forces_of(const LatticeFluid<Dim>& f) {
        if (!f.pressure) return Skip{};
        return PressureForce<W, Box>{f.w};
    }
    static Averages averages_of(const LatticeFluid<Dim>& f) {
        if (f.xi == 0.0) return Skip{};
        return AverageVelocities<W, Box>{f.w};
    }
    static Smoothing smoothing_of(const LatticeFluid<Dim>& f, double dt) {
        if (f.xi == 0.0) return Skip{};
        return XsphVelocities<Dim>{{f.xi, dt}};
    }
    /// The artificial one with the α that gives ν = 1: ν = α c h/(2 (Dim + 2)), h half of the support.
    static Viscosities viscosity_of(const LatticeFluid<Dim>& f, double density) {
        switch (f.viscosity) {
            case ViscousForm::brookshaw:
                return BrookshawViscosity<W, Box>{f.w, density};
            case ViscousForm::monaghan:
                return MonaghanViscosity<W, Box>{f.w, density};
            case ViscousForm::laplacian:
                return LaplacianViscosity<W, Box>{f.w, density};
            case ViscousForm::artificial:
                return ArtificialViscosity<W, Box>{f.w, 4.0 * (Dim + 2) / f.w.support(), 1.0};
            case ViscousForm::none:
                break;
        }
        return Skip{};
    }
};

/// The particles hardly move, so their neighbours are found once.
template <int Dim> struct FindOnce {
    using Box = PeriodicBox<Dim>;
    using Reads = Quantities<Positions<Dim>>;
    using Writes = Quantities<Neighbourhood<Dim, Box>>;
    FindNeighbours<Dim, CellGrid<Dim, Box>> find;

    void run(double dt, const Positions<Dim>& x, Neighbourhood<Dim, Box>& near) const {
        if (!near.space) find.run(dt, x, near);
    }
};

template <int Dim> auto scene_of(const LatticeFluid<Dim>& f, double dt) {
    using Choice = Choices<Dim>;
    using Box = typename Choice::Box;
    using W = typename Choice::W;
    const Box box(Vec<Dim>::Zero(), size_of_lattice<Dim>());
    const W w = kernel_of_density(f);
    const double density = density_on(w, neighbours_on(packed_lattice<Dim>(), w.support()));
    Scene scene{Given<Positions<Dim>, Velocities<Dim>, Masses>{},
                FindOnce<Dim>{{w.support(), CellGrid<Dim, Box>(box)}},
                SphDensity<W, Box>{w},
                TaitPressure{TaitEquation(density / (1.0 + f.compression), 1.0, 7.0)},
                Choice::averages_of(f),
                Choice::smoothing_of(f, dt),
                Choice::forces_of(f),
                Choice::viscosity_of(f, density),
                SymplecticEuler<Dim>{}};
    auto& x = scene.template get<Positions<Dim>>();
    auto& v = scene.template get<Velocities<Dim>>();
    const auto points = points_of_lattice<Dim>();
    x.assign(points.begin(), points.end());
    Random random(1);
    for (std::size_t i = 0; i < x.size(); ++i)
        v.push_back(1e-9 * Vec<Dim>::NullaryExpr([&] { return random.uniform(-1, 1); }));
    scene.template get<Masses>().assign(x.size(), 1.0);
    return scene;
}
template <int Dim> double norm_of(const Points<Dim>& v) {
    double squares = 0.0;
    for (const Vec<Dim>& v_i : v) squares += v_i.squaredNorm();
    return std::sqrt(squares);
}
}  // namespace

template <int Dim> bool grows(const LatticeFluid<Dim>& fluid, double dt) {
    auto scene = scene_of(fluid, dt);
    const auto& v = scene.template get<Velocities<Dim>>();
    const double start = norm_of<Dim>(v);
    for (int n = 0; n < 500; ++n) {
        scene.step(dt);
        if (!(norm_of<Dim>(v) < 100.0 * start)) return true;
    }
    return false;
}

template <int Dim> double growth_rate(const LatticeFluid<Dim>& fluid, double dt, double duration) {
    auto scene = scene_of(fluid, dt);
    const Points<Dim> lattice = scene.template get<Positions<Dim>>();
    auto& x = scene.template get<Positions<Dim>>();
    auto& v = scene.template get<Velocities<Dim>>();
    const double start = norm_of<Dim>(v);
    double scaled = 0.0, at_half = 0.0;  // logarithms
    const auto logarithm = [&] { return scaled + std::log(norm_of<Dim>(v) / start); };
    const int steps = static_cast<int>(std::ceil(duration / dt)), half = steps / 2;
    for (int n = 0; n < steps; ++n) {
        if (n == half) at_half = logarithm();
        scene.step(dt);
        if (const double factor = norm_of<Dim>(v) / start; factor > 1e3) {
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

template bool grows<2>(const LatticeFluid<2>&, double);
template bool grows<3>(const LatticeFluid<3>&, double);
template double growth_rate<2>(const LatticeFluid<2>&, double, double);
template double growth_rate<3>(const LatticeFluid<3>&, double, double);

}  // namespace verification
