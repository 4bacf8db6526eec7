#pragma once

#include "solver/kernels/kernel.h"
#include "verification/framework/eigenvalues.h"
#include "verification/framework/patch.h"

#include <Eigen/LU>

#include <numbers>

namespace verification {

/// A fluid at rest on a lattice, all particles of mass 1: its density by Eq. 5, its pressure, and the
/// speed of sound √(dp/dρ) there.
struct FluidAtRest {
    double density, pressure, speed_of_sound;
};

/// The points of `lattice` closer than `support` to the origin, itself left out.
template <int Dim>
plumbline::Points<Dim> neighbours_on(const Lattice<Dim>& lattice, double support) {
    const Patch<Dim> patch(lattice, {.support = support, .reach = 1.0});
    plumbline::Points<Dim> points;
    for (const auto& x : patch.x)
        if (const double r = x.norm(); r > 0.0 && r < support) points.push_back(x);
    return points;
}

template <plumbline::RadialKernel K>
double density_on(const K& w, const plumbline::Points<K::dim>& neighbours) {
    double rho = w.value(0.0);
    for (const auto& x : neighbours) rho += w.value(x.norm());
    return rho;
}

/// D(k) with ü = −D u for displacements u e^(ik·x) under Eqs. 5, 51, masses 1:
/// D = (dP/dρ) s sᵀ + 2 P Σ ∇∇ω (1 − cos k·x), P = p/ρ², s = Σ ∇ω sin k·x.
/// Its eigenvalues are squared angular frequencies; a negative one grows.
template <plumbline::RadialKernel K>
plumbline::Mat<K::dim> dispersion(const K& w, const plumbline::Points<K::dim>& neighbours,
                                  const FluidAtRest& fluid, const plumbline::Vec<K::dim>& k) {
    const double rho = fluid.density, P = fluid.pressure / (rho * rho);
    const double dP = fluid.speed_of_sound * fluid.speed_of_sound / (rho * rho) - 2.0 * P / rho;
    plumbline::Vec<K::dim> s = plumbline::Vec<K::dim>::Zero();
    plumbline::Mat<K::dim> stiffness = plumbline::Mat<K::dim>::Zero();
    for (const auto& x : neighbours) {
        const double phase = k.dot(x);
        s += std::sin(phase) * plumbline::gradient(w, x);
        stiffness += (1.0 - std::cos(phase)) * plumbline::hessian(w, x);
    }
    return dP * s * s.transpose() + 2.0 * P * stiffness;
}

/// λ(k) ≥ 0 with v̇ = −ν λ v for velocities v e^(ik·x), where a pair at distance r has the coefficient
/// `laplacian(r)`, the volume of a particle being 1/ρ.
template <class LaplacianOfPair, int Dim>
double decay_rate(LaplacianOfPair laplacian, const plumbline::Points<Dim>& neighbours,
                  double density, const plumbline::Vec<Dim>& k) {
    double rate = 0.0;
    for (const auto& x : neighbours) rate += laplacian(x.norm()) * (1.0 - std::cos(k.dot(x)));
    return rate / density;
}

/// f(k) for k = 2π B⁻ᵀ (n₁, n₂, …)/n: the wave vectors that fit n cells of the lattice.
template <int Dim, class F> void for_each_wave(const Lattice<Dim>& lattice, int n, F f) {
    const plumbline::Mat<Dim> reciprocal =
        2.0 * std::numbers::pi / n * lattice.basis.inverse().transpose();
    const int count = Dim == 2 ? n * n : n * n * n;
    for (int index = 1; index < count; ++index) {
        plumbline::Vec<Dim> m;
        for (int d = 0, rest = index; d < Dim; ++d, rest /= n) m[d] = rest % n;
        f(plumbline::Vec<Dim>(reciprocal * m));
    }
}

/// The smallest and the largest of the squared frequencies over all waves that fit n cells.
struct Spectrum {
    double smallest = HUGE_VAL, largest = -HUGE_VAL;
    void include(double low, double high) {
        smallest = std::min(smallest, low), largest = std::max(largest, high);
    }
};
template <plumbline::RadialKernel K>
Spectrum spectrum(const K& w, const Lattice<K::dim>& lattice, const FluidAtRest& fluid, int n) {
    const auto neighbours = neighbours_on(lattice, w.support());
    Spectrum found;
    for_each_wave(lattice, n, [&](const auto& k) {
        const auto squared = eigenvalues<K::dim>(dispersion(w, neighbours, fluid, k));
        found.include(squared.minCoeff(), squared.maxCoeff());
    });
    return found;
}

/// The fluid of the lattice with the Tait equation, c₀ = 1, γ, compressed by `compression` against its
/// rest density.
template <plumbline::RadialKernel K>
FluidAtRest compressed(const K& w, const Lattice<K::dim>& lattice, double compression,
                       double gamma = 7.0) {
    const double rho = density_on(w, neighbours_on(lattice, w.support()));
    const double rho0 = rho / (1.0 + compression), s = std::pow(1.0 + compression, gamma);
    return {rho, rho0 / gamma * (s - 1.0), std::sqrt(s / (1.0 + compression))};
}

}  // namespace verification
