#include "solver/fluid/brookshaw_viscosity.h"
#include "solver/fluid/continuity.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/sph_density.h"
#include "solver/fluid/tait_equation.h"
#include "solver/foundation/random.h"
#include "solver/kernels/cubic_spline.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/spiky.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"
#include "solver/scene/two_stage.h"
#include "verification/fluid/dispersion.h"
#include "verification/framework/eigenvalues.h"
#include "verification/framework/registry.h"

namespace stability_limits_claims {
namespace {
using namespace plumbline;
using namespace verification;

using Box = PeriodicBox<2>;
using Search = CellGrid<2, Box>;
using W = WendlandC2<2>;
using Start = Given<Positions<2>, Velocities<2>, Masses>;
constexpr double h = 2.3;  // support, in spacings
constexpr int columns = 10, rows = 12;
const Lattice<2> hexagonal = hexagonal_lattice(1.0);

Vec<2> size_of_box() { return {columns, rows * std::sqrt(0.75)}; }
/// f(k) for the waves that fit the box.
template <class F> void for_each_wave_of_box(F f) {
    for (int n = 1; n < columns * rows; ++n)
        f(Vec<2>(2.0 * std::numbers::pi *
                 Vec<2>(n % columns, n / columns).cwiseQuotient(size_of_box())));
}
/// A hexagonal lattice without end of a fluid with c₀ = 1, at rest.
template <class... Forces> auto lattice_of(double compression, Forces... forces) {
    const Box box(Vec<2>::Zero(), size_of_box());
    const double rho0 = compressed(W(h), hexagonal, compression).density / (1.0 + compression);
    Scene scene{Start{},
                WrapIntoBox<2>{box},
                FindNeighbours<2, Search>{h, Search(box)},
                SphDensity<W, Box>{W(h)},
                TaitPressure{TaitEquation(rho0, 1.0, 7.0)},
                forces...};
    auto& x = scene.template get<Positions<2>>();
    for (int n = 0; n < columns * rows; ++n) {
        const int row = n / columns;
        x.push_back(Vec<2>(n % columns + 0.25 + 0.5 * (row % 2), (row + 0.5) * std::sqrt(0.75)));
    }
    scene.template get<Velocities<2>>().assign(x.size(), Vec<2>::Zero());
    scene.template get<Masses>().assign(x.size(), 1.0);
    return scene;
}

/// max ‖a + D u‖ / max ‖a‖ of a displacement u cos(k·x) of 1e-6 spacings, at 2 % compression.
double error_of_dispersion(double compression_of_theory) {
    const auto neighbours = neighbours_on(hexagonal, h);
    const FluidAtRest fluid = compressed(W(h), hexagonal, compression_of_theory);
    double worst = 0.0;
    for (const Vec<2>& m : {Vec<2>(1, 0), Vec<2>(3, 2), Vec<2>(5, 6)}) {
        const Vec<2> k = 2.0 * std::numbers::pi * m.cwiseQuotient(size_of_box()), u(0.6e-6, 0.8e-6);
        auto scene = lattice_of(0.02, PressureForce<W, Box>{W(h)});
        const Points<2> start = scene.get<Positions<2>>();
        for (Vec<2>& x : scene.get<Positions<2>>()) x += std::cos(k.dot(x)) * u;
        scene.step(0.0);
        const Mat<2> D = dispersion(W(h), neighbours, fluid, k);
        double error = 0.0, size = 0.0;
        for (std::size_t i = 0; i < start.size(); ++i) {
            const Vec<2> a = scene.get<Accelerations<2>>()[i];
            error = std::max(error, (a + std::cos(k.dot(start[i])) * (D * u)).norm());
            size = std::max(size, a.norm());
        }
        worst = std::max(worst, error / size);
    }
    return worst;
}

/// Whether random velocities of 1e-9 grow a hundredfold in 500 steps.
template <class Make> bool grows(Make make, double dt) {
    auto scene = make();
    Random random(1);
    for (Vec<2>& v : scene.template get<Velocities<2>>())
        v = 1e-9 * Vec<2>(random.uniform(-1, 1), random.uniform(-1, 1));
    for (int n = 0; n < 500; ++n) {
        scene.step(dt);
        for (const Vec<2>& v : scene.template get<Velocities<2>>())
            if (!(v.norm() < 1e-7)) return true;
    }
    return false;
}
/// The border of growth over `theory`, by bisection to 0.4 %.
template <class Make> double border(Make make, double theory) {
    double stable = 0.9, growing = 1.1;
    if (grows(make, stable * theory) || !grows(make, growing * theory)) return NAN;
    while (growing - stable > 4e-3) {
        const double middle = 0.5 * (stable + growing);
        (grows(make, middle * theory) ? growing : stable) = middle;
    }
    return 0.5 * (stable + growing);
}
double acoustic_border(double factor) {
    const auto neighbours = neighbours_on(hexagonal, h);
    const FluidAtRest fluid = compressed(W(h), hexagonal, 0.02);
    double largest = 0.0;
    for_each_wave_of_box([&](const Vec<2>& k) {
        largest =
            std::max(largest, eigenvalues<2>(dispersion(W(h), neighbours, fluid, k)).maxCoeff());
    });
    return border(
        [] { return lattice_of(0.02, PressureForce<W, Box>{W(h)}, SymplecticEuler<2>{}); },
        factor * 2.0 / std::sqrt(largest));
}
double viscous_border(double factor) {
    const auto neighbours = neighbours_on(hexagonal, h);
    const double rho = density_on(W(h), neighbours);
    double largest = 0.0;
    for_each_wave_of_box([&](const Vec<2>& k) {
        const auto laplacian_of_pair = [](double r) { return -2.0 * W(h).derivative(r) / r; };
        largest = std::max(largest, decay_rate(laplacian_of_pair, neighbours, rho, k));
    });
    return border(
        [=] {
            return lattice_of(0.0, BrookshawViscosity<W, Box>{W(h), rho}, SymplecticEuler<2>{});
        },
        factor * 2.0 / largest);
}

/// The root mean square of random velocities, after 500 steps of a tenth of the acoustic limit over what
/// it was, if Continuity advances the density.
template <class Integrate> double growth_of_sound(Integrate integrate) {
    const Box box(Vec<2>::Zero(), size_of_box());
    auto scene = integrate(FindNeighbours<2, Search>{h, Search(box)}, Continuity<W, Box>{W(h)},
                           TaitPressure{TaitEquation(1.0 / hexagonal.cell_volume(), 1.0, 7.0)},
                           PressureForce<W, Box>{W(h)});
    const auto lattice = lattice_of(0.0);
    scene.template get<Positions<2>>() = lattice.template get<Positions<2>>();
    scene.template get<Masses>() = lattice.template get<Masses>();
    scene.template get<Density>().assign(columns * rows, 1.0 / hexagonal.cell_volume());
    Random random(1);
    for (int n = 0; n < columns * rows; ++n)
        scene.template get<Velocities<2>>().push_back(
            1e-9 * Vec<2>(random.uniform(-1, 1), random.uniform(-1, 1)));
    const auto mean_square = [&] {
        double sum = 0.0;
        for (const Vec<2>& v : scene.template get<Velocities<2>>()) sum += v.squaredNorm();
        return sum;
    };
    const double before = mean_square();
    const FluidAtRest fluid{1.0 / hexagonal.cell_volume(), 0.0, 1.0};
    const double dt = 0.2 / std::sqrt(spectrum(W(h), hexagonal, fluid, 20).largest);
    for (int n = 0; n < 500; ++n) scene.step(dt);
    return std::sqrt(mean_square() / before);
}
using StartWithDensity = Given<Positions<2>, Velocities<2>, Masses, Density>;
constexpr auto by_two_stages = [](auto... passes) {
    return Scene{StartWithDensity{}, TwoStage{Evolve<2, Density>{}, passes...}};
};
constexpr auto by_symplectic_euler = [](auto... passes) {
    return Scene{StartWithDensity{}, passes..., SymplecticEuler<2, Density>{}};
};

/// The decay rates of all waves on a lattice, times the square of the support.
template <int Dim, class LaplacianOfPair>
Spectrum decay_rates(const Lattice<Dim>& lattice, double support, LaplacianOfPair laplacian_of) {
    const auto neighbours = neighbours_on(lattice, support);
    Spectrum found;
    for_each_wave(lattice, Dim == 2 ? 20 : 8, [&](const Vec<Dim>& k) {
        const double rate = decay_rate(laplacian_of, neighbours, 1.0 / lattice.cell_volume(), k);
        found.include(support * support * rate, support * support * rate);
    });
    return found;
}
/// The slowest decay under poly6, by its Laplacian or by Brookshaw's form, over supports from 1.8 to 3.5.
double slowest_decay(bool brookshaw) {
    double slowest = -HUGE_VAL;
    for (const double support : {1.8, 2.0, 2.5, 3.0, 3.5}) {
        const Poly6<2> w(support);
        const auto laplacian_of_pair = [&](double r) {
            return brookshaw ? -2.0 * w.derivative(r) / r : laplacian(w, r);
        };
        slowest = std::max(slowest, decay_rates(hexagonal, support, laplacian_of_pair).smallest);
    }
    return slowest;
}
/// min over supports of the exact limit 2/λ of Brookshaw's form over ViscousLimit's.
template <template <int> class K, int Dim>
double viscous_margin(const Lattice<Dim>& lattice, double fraction) {
    double least = HUGE_VAL;
    for (const double support : {1.6, 2.0, 2.5, 3.0, 3.5}) {
        const K<Dim> w(support);
        const auto pair = [&](double r) { return -2.0 * w.derivative(r) / r; };
        least = std::min(least, 2.0 / decay_rates(lattice, support, pair).largest / fraction);
    }
    return least;
}
double viscous_margin_of_rule(double fraction) {
    return std::min({viscous_margin<WendlandC2>(hexagonal, fraction),
                     viscous_margin<Poly6>(hexagonal, fraction),
                     viscous_margin<CubicSpline>(hexagonal, fraction),
                     viscous_margin<Spiky>(hexagonal, fraction),
                     viscous_margin<WendlandC2>(close_packed_lattice(1.0), fraction),
                     viscous_margin<Spiky>(close_packed_lattice(1.0), fraction)});
}

/// min over lattices and supports of the exact limit over that of AcousticLimit.
template <template <int> class K, int Dim>
double margin(const std::vector<Lattice<Dim>>& lattices, double courant) {
    double least = HUGE_VAL;
    for (const auto& lattice : lattices)
        for (const double support : {1.6, 2.0, 2.4, 2.8, 3.2}) {
            const K<Dim> w(support);
            const FluidAtRest fluid = compressed(w, lattice, 0.01);
            const double largest = spectrum(w, lattice, fluid, Dim == 2 ? 16 : 8).largest;
            const double rule = courant * support / fluid.speed_of_sound;
            least = std::min(least, 2.0 / std::sqrt(largest) / rule);
        }
    return least;
}
template <template <int> class K> double margin_of_rule(double courant) {
    return std::min(margin<K, 2>({cubic_lattice<2>(1.0), hexagonal_lattice(1.0)}, courant),
                    margin<K, 3>({cubic_lattice<3>(1.0), close_packed_lattice(1.0)}, courant));
}

const Register claims_of_limits{
    Claim{.id = "stability.dispersion_is_that_of_the_forces",
          .source = {Paper::plumbline, "verification/fluid/dispersion.h"},
          .says =
              "the accelerations of a lattice displaced by a wave are −D(k) u, at 2 % compression",
          .bound = at_most(1e-5,
                           "displacements of 1e-6 spacings; terms of second order are that times "
                           "ω‴ h/ω″ < 10"),
          .measure = [] { return error_of_dispersion(0.02); },
          .sabotaged = [] { return error_of_dispersion(0.01); }},
    Claim{.id = "stability.acoustic_border",
          .source = {Paper::literature, "symplectic Euler is stable iff ω Δt ≤ 2"},
          .says =
              "a hexagonal lattice under pressure begins to shake at Δt = 2/ω, the largest ω of "
              "D(k): measured border over theory",
          .bound = between(0.98, 1.02,
                           "bisection to 0.4 %; growth by 100 in 500 steps needs 2 √(2 δ) "
                           "500 > ln 1e4, δ > 4e-5"),
          .measure = [] { return acoustic_border(1.0); },
          .sabotaged = [] { return acoustic_border(1.05); }},
    Claim{
        .id = "stability.viscous_border",
        .source = {Paper::literature, "Euler's step decays iff λ Δt ≤ 2"},
        .says =
            "Brookshaw's viscosity begins to shake at Δt = 2/(ν λ), the largest λ: measured border "
            "over theory",
        .bound = between(0.98, 1.02,
                         "bisection to 0.4 %; growth by 100 in 500 steps needs 1 + 2 δ "
                         "to the 500th to be 1e4: δ > 0.9 %"),
        .measure = [] { return viscous_border(1.0); },
        .sabotaged = [] { return viscous_border(1.05); }},
    Claim{.id = "stability.continuity_needs_two_stages",
          .source = {Paper::plumbline, "docstring of Continuity"},
          .says =
              "velocities of sound waves after 500 steps with ω Δt ≤ 0.2, over the first ones: two "
              "stages keep them; symplectic Euler, for which density and velocity are advanced "
              "together and not in turn, makes them grow at any time step",
          .bound = at_most(1.2,
                           "(ω Δt)⁴/8 per step: exp(500 · 2e-4) = 1.1, and no energy but that of "
                           "the velocities at first; Euler's (ω Δt)²/2 gives exp(500 · 0.02)"),
          .measure = [] { return growth_of_sound(by_two_stages); },
          .sabotaged = [] { return growth_of_sound(by_symplectic_euler); }},
    Claim{
        .id = "stability.acoustic_rule_is_safe",
        .source = {Paper::plumbline, "docstring of AcousticLimit"},
        .says =
            "exact limit over 0.4 h/c on square, hexagonal, cubic and close packed lattices, four "
            "kernels, 1.6 to 3.2 spacings per support: the least",
        .bound = at_least(1.415,
                          "1 is the border, and strong damping of a mode, velocities being "
                          "multiplied by s > −1 per step, lowers Δt² ω² from 4 to 2 (1 + s), "
                          "so Δt by √2 where it does not reverse them"),
        .measure =
            [] {
                return std::min({margin_of_rule<Poly6>(0.4), margin_of_rule<WendlandC2>(0.4),
                                 margin_of_rule<CubicSpline>(0.4), margin_of_rule<Spiky>(0.4)});
            },
        .sabotaged = [] { return margin_of_rule<WendlandC2>(0.8); }},
    Claim{.id = "stability.viscous_rule_is_safe",
          .source = {Paper::plumbline, "docstring of ViscousLimit"},
          .says = "exact limit of Brookshaw's viscosity over 0.04 h²/ν, hexagonal and close packed "
                  "lattices, 1.6 to 3.5 spacings per support: the least",
          .bound = at_least(1.0, "below 1 the shortest waves grow"),
          .measure = [] { return viscous_margin_of_rule(0.04); },
          .sabotaged = [] { return viscous_margin_of_rule(0.1); }},
    Claim{.id = "stability.laplacian_of_poly6_grows",
          .source = {Paper::adams2009, "Eqs. 11, 52; Sec. 6.2"},
          .says =
              "with the Laplacian of poly6 in Eq. 52 some wave grows at any time step, for each "
              "support from 1.8 spacings: λ h² of the slowest; with Brookshaw's form all decay",
          .bound = at_most(0.0, "a negative decay rate is growth"),
          .measure = [] { return slowest_decay(false); },
          .sabotaged = [] { return slowest_decay(true); }}};
}  // namespace
}  // namespace stability_limits_claims
