#include "solver/kernels/all_kernels.h"
#include "verification/stability/lattice_fluid.h"
#include "verification/stability/lattice_waves.h"

#include <algorithm>
#include <optional>

namespace verification {
namespace {
using namespace plumbline;

/// λ ≤ μ, the eigenvalues of a symmetric matrix.
struct Eigenvalues {
    double low, high;
    explicit Eigenvalues(const Mat<2>& m) {
        const double mean = 0.5 * m.trace(), half = 0.5 * (m(0, 0) - m(1, 1));
        const double radius = std::hypot(half, m(0, 1));
        low = mean - radius, high = mean + radius;
    }
};

/// Λ(k) with v̇ = −ν Λ v for velocities v e^(ik·x).
template <class PairTerm>
Mat<2> decay(const Points<2>& neighbours, double density, const Vec<2>& k, PairTerm term) {
    Mat<2> sum = Mat<2>::Zero();
    for (const Vec<2>& x : neighbours) sum += (1.0 - std::cos(k.dot(x))) * term(x, x.norm());
    return sum / density;
}
/// What a pair at x adds to Λ/(1 − cos k·x), times the density, with ν = 1.
Mat<2> pair_term(const LatticeFluid& f, const Vec<2>& x, double r) {
    const Mat<2> identity = Mat<2>::Identity();
    switch (f.viscosity) {
        case ViscousForm::brookshaw:
            return -2.0 * f.w.derivative(r) / r * identity;
        case ViscousForm::laplacian:
            return f.w.laplacian(r) * identity;
        case ViscousForm::monaghan:
            return -8.0 * f.w.derivative(r) / (r * r * r) * x * x.transpose();
        case ViscousForm::artificial: {  // half of the pairs approach
            const double h = 0.5 * f.w.support();
            return -4.0 * f.w.derivative(r) / (r * (r * r + 0.01 * h * h)) * x * x.transpose();
        }
        case ViscousForm::none:
            break;
    }
    return Mat<2>::Zero();
}
/// λ of XSPH: v ← (1 − ξ λ) v.
double smoothing(const AnyKernel<2>& w, const Points<2>& neighbours, double density,
                 const Vec<2>& k) {
    return decay_rate([&](double r) { return w.value(r); }, neighbours, density, k);
}
}  // namespace

double largest_step(const LatticeFluid& f) {
    const auto neighbours = neighbours_on(hexagonal, f.w.support());
    const FluidAtRest fluid = compressed(f.w, hexagonal, f.compression);
    double step = HUGE_VAL;
    for_each_wave_of_lattice([&](const Vec<2>& k) {
        const double s = 1.0 - f.xi * smoothing(f.w, neighbours, fluid.density, k);
        const Eigenvalues squares(dispersion(f.w, neighbours, fluid, k));
        const double limit = std::abs(s) <= 1.0 ? std::sqrt(2.0 * (1.0 + s) / squares.high) : 0.0;
        step = std::min(step, limit);
    });
    return step;
}

double largest_viscous_step(const LatticeFluid& f) {
    const auto neighbours = neighbours_on(hexagonal, f.w.support());
    const double density = density_on(kernel_of_density(f), neighbours);
    double fastest = 0.0, slowest = HUGE_VAL;
    for_each_wave_of_lattice([&](const Vec<2>& k) {
        const Eigenvalues rates(decay(
            neighbours, density, k, [&](const Vec<2>& x, double r) { return pair_term(f, x, r); }));
        fastest = std::max(fastest, rates.high), slowest = std::min(slowest, rates.low);
    });
    return slowest < -1e-12 * fastest ? 0.0 : 2.0 / fastest;
}

double largest_xi(const AnyKernel<2>& w) {
    const auto neighbours = neighbours_on(hexagonal, w.support());
    const double density = density_on(w, neighbours);
    double strongest = 0.0;
    for_each_wave_of_lattice([&](const Vec<2>& k) {
        strongest = std::max(strongest, smoothing(w, neighbours, density, k));
    });
    return 2.0 / strongest;
}

double fastest_growth(const LatticeFluid& f) {
    const auto neighbours = neighbours_on(hexagonal, f.w.support());
    const FluidAtRest fluid = compressed(f.w, hexagonal, f.compression);
    double softest = 0.0;
    for_each_wave_of_lattice([&](const Vec<2>& k) {
        softest = std::min(softest, Eigenvalues(dispersion(f.w, neighbours, fluid, k)).low);
    });
    return softest > -1e-12 ? 0.0 : std::sqrt(-softest);
}

AnyKernel<2> kernel_of(std::string_view name, double support) {
    std::optional<AnyKernel<2>> found;
    AllKernels::with<2>(name, support, [&](const auto& w) { found.emplace(w); });
    return *found;
}

AnyKernel<2> kernel_of_density(const LatticeFluid& f) {
    return std::isfinite(f.w.value(0.0)) ? f.w : kernel_of("wendland_c2", f.w.support());
}

std::vector<std::string> kernels_for_fluids() {
    std::vector<std::string> names;
    for (const std::string_view name : AllKernels::names<2>())
        if (std::isfinite(kernel_of(name, 1.0).value(0.0))) names.emplace_back(name);
    return names;
}

}  // namespace verification
