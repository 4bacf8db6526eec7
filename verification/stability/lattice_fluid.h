#pragma once

#include "verification/framework/any_kernel.h"

#include <string>
#include <string_view>
#include <vector>

namespace verification {

enum class ViscousForm { none, brookshaw, monaghan, laplacian, artificial };

/// A hexagonal lattice without end, 10 by 12 particles that repeat, in space a close packed one, 256 particles: nearest
/// neighbours at 1, masses 1, c₀ = 1, γ = 7, at rest.
template <int Dim> struct LatticeFluid {
    AnyKernel<Dim> w;
    double compression = 0.0;                   // of its density against that of rest
    bool pressure = true;                       // Eq. 51; none: only what follows
    ViscousForm viscosity = ViscousForm::none;  // of ν = 1
    double xi = 0.0;                            // XSPH after Monaghan, that ξ in each step
};

/// Whether a hundredfold of random velocities of 1e-9 is reached within 500 steps of the solver's passes with symplectic
/// Euler.
template <int Dim> bool grows(const LatticeFluid<Dim>& fluid, double dt);

/// d ln ‖v‖/dt of the same, in the second half of a run over `duration`, scaled down whenever it has grown a
/// thousandfold; 0 if ‖v‖ grows less than tenfold in all.
template <int Dim> double growth_rate(const LatticeFluid<Dim>& fluid, double dt, double duration);

// The same by theory, over the waves that fit: v̈ = −D v for displacements, see dispersion.h.

/// The largest step without growth: 2/ω, with XSPH the smallest √(2 (1 + s)) / ω, where s = 1 − ξ λ is by what
/// a step multiplies the velocities of a wave; 0 where |s| > 1.
template <int Dim> double largest_step(const LatticeFluid<Dim>& fluid);
/// 2/λ of the fastest decay, 0 if a wave grows.
template <int Dim> double largest_viscous_step(const LatticeFluid<Dim>& fluid);
/// 2/λ of XSPH: the largest ξ with |1 − ξ λ| ≤ 1.
template <int Dim> double largest_xi(const AnyKernel<Dim>& w);
/// √(−ω²) of the wave that grows fastest, 0 if none does.
template <int Dim> double fastest_growth(const LatticeFluid<Dim>& fluid);

/// "wendland_c2" with that support, in spacings.
template <int Dim> AnyKernel<Dim> kernel_of(std::string_view name, double support);
/// That of the fluid, or Wendland's C2 where that is infinite at the centre, as Müller's for viscosity.
template <int Dim> AnyKernel<Dim> kernel_of_density(const LatticeFluid<Dim>& fluid);
/// The kernels with a finite value at the centre, without which there is no density.
template <int Dim> std::vector<std::string> kernels_for_fluids();

}  // namespace verification
