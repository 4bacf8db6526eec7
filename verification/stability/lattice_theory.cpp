#include "solver/kernels/all_kernels.h"
#include "verification/stability/lattice_fluid.h"
#include "verification/stability/lattice_waves.h"

#include <algorithm>
#include <optional>

namespace verification {
namespace {
using namespace plumbline;

/// Λ(k) with v̇ = −ν Λ v for velocities v e^(ik·x).
template <int Dim, class PairTerm>
Mat<Dim> decay(const Points<Dim>& neighbours, double density, const Vec<Dim>& k, PairTerm term) {
    Mat<Dim> sum = Mat<Dim>::Zero();
    for (const Vec<Dim>& x : neighbours) sum += (1.0 - std::cos(k.dot(x))) * term(x, x.norm());
    return sum / density;
}
/// What a pair at x adds to Λ/(1 − cos k·x), times the density, with ν = 1.
template <int Dim> Mat<Dim> pair_term(const LatticeFluid<Dim>& f, const Vec<Dim>& x, double r) {
    const Mat<Dim> identity = Mat<Dim>::Identity();
    switch (f.viscosity) {
        case ViscousForm::brookshaw:
            return -2.0 * f.w.derivative(r) / r * identity;
        case ViscousForm::laplacian:
            return f.w.laplacian(r) * identity;
        case ViscousForm::monaghan:
            return -2.0 * (Dim + 2) * f.w.derivative(r) / (r * r * r) * x * x.transpose();
        case ViscousForm::artificial: {  // half of the pairs approach
            const double h = 0.5 * f.w.support();
            return -(Dim + 2.0) * f.w.derivative(r) / (r * (r * r + 0.01 * h * h)) * x *
                   x.transpose();
        }
        case ViscousForm::none:
            break;
    }
    return Mat<Dim>::Zero();
}
/// λ of XSPH: v ← (1 − ξ λ) v.
template <int Dim>
double smoothing(const AnyKernel<Dim>& w, const Points<Dim>& neighbours, double density,
                 const Vec<Dim>& k) {
    return decay_rate([&](double r) { return w.value(r); }, neighbours, density, k);
}
}  // namespace

template <int Dim> double largest_step(const LatticeFluid<Dim>& f) {
    const auto neighbours = neighbours_on(packed_lattice<Dim>(), f.w.support());
    const FluidAtRest fluid = compressed(f.w, packed_lattice<Dim>(), f.compression);
    double step = HUGE_VAL;
    for_each_wave_of_lattice<Dim>([&](const Vec<Dim>& k) {
        const double s = 1.0 - f.xi * smoothing(f.w, neighbours, fluid.density, k);
        const double fastest = eigenvalues<Dim>(dispersion(f.w, neighbours, fluid, k)).maxCoeff();
        const double limit = std::abs(s) <= 1.0 ? std::sqrt(2.0 * (1.0 + s) / fastest) : 0.0;
        step = std::min(step, limit);
    });
    return step;
}

template <int Dim> double largest_viscous_step(const LatticeFluid<Dim>& f) {
    const auto neighbours = neighbours_on(packed_lattice<Dim>(), f.w.support());
    const double density = density_on(kernel_of_density(f), neighbours);
    double fastest = 0.0, slowest = HUGE_VAL;
    for_each_wave_of_lattice<Dim>([&](const Vec<Dim>& k) {
        const Vec<Dim> rates =
            eigenvalues<Dim>(decay<Dim>(neighbours, density, k, [&](const Vec<Dim>& x, double r) {
                return pair_term(f, x, r);
            }));
        fastest = std::max(fastest, rates.maxCoeff()),
        slowest = std::min(slowest, rates.minCoeff());
    });
    return slowest < -1e-12 * fastest ? 0.0 : 2.0 / fastest;
}

template <int Dim> double largest_xi(const AnyKernel<Dim>& w) {
    const auto neighbours = neighbours_on(packed_lattice<Dim>(), w.support());
    const double density = density_on(w, neighbours);
    double strongest = 0.0;
    for_each_wave_of_lattice<Dim>([&](const Vec<Dim>& k) {
        strongest = std::max(strongest, smoothing(w, neighbours, density, k));
    });
    return 2.0 / strongest;
}

template <int Dim> double fastest_growth(const LatticeFluid<Dim>& f) {
    const auto neighbours = neighbours_on(packed_lattice<Dim>(), f.w.support());
    const FluidAtRest fluid = compressed(f.w, packed_lattice<Dim>(), f.compression);
    double softest = 0.0;
    for_each_wave_of_lattice<Dim>([&](const Vec<Dim>& k) {
        softest =
            std::min(softest, eigenvalues<Dim>(dispersion(f.w, neighbours, fluid, k)).minCoeff());
    });
    return softest > -1e-12 ? 0.0 : std::sqrt(-softest);
}

template <int Dim> AnyKernel<Dim> kernel_of(std::string_view name, double support) {
    std::optional<AnyKernel<Dim>> found;
    AllKernels::with<Dim>(name, support, [&](const auto& w) { found.emplace(w); });
    return *found;
}

template <int Dim> AnyKernel<Dim> kernel_of_density(const LatticeFluid<Dim>& f) {
    return std::isfinite(f.w.value(0.0)) ? f.w : kernel_of<Dim>("wendland_c2", f.w.support());
}

template <int Dim> std::vector<std::string> kernels_for_fluids() {
    std::vector<std::string> names;
    for (const std::string_view name : AllKernels::names<Dim>())
        if (std::isfinite(kernel_of<Dim>(name, 1.0).value(0.0))) names.emplace_back(name);
    return names;
}

template double largest_step<2>(const LatticeFluid<2>&);
template double largest_viscous_step<2>(const LatticeFluid<2>&);
template double largest_xi<2>(const AnyKernel<2>&);
template double fastest_growth<2>(const LatticeFluid<2>&);
template AnyKernel<2> kernel_of<2>(std::string_view, double);
template AnyKernel<2> kernel_of_density<2>(const LatticeFluid<2>&);
template std::vector<std::string> kernels_for_fluids<2>();
template double largest_step<3>(const LatticeFluid<3>&);
template double largest_viscous_step<3>(const LatticeFluid<3>&);
template double largest_xi<3>(const AnyKernel<3>&);
template double fastest_growth<3>(const LatticeFluid<3>&);
template AnyKernel<3> kernel_of<3>(std::string_view, double);
template AnyKernel<3> kernel_of_density<3>(const LatticeFluid<3>&);
template std::vector<std::string> kernels_for_fluids<3>();

}  // namespace verification
