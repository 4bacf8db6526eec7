#pragma once

namespace verification {

/// A square of fluid, 1 m wide, that turns at 1/s around its centre, without gravity or walls: the pressure that
/// keeps it together is negative everywhere.                                     Colagrossi 2005
struct RotatingPatch {
    double spacing;     // [m]
    double zeta = 1.0;  // how much of a tension is kept, adams2009 Eq. 54
};

/// Δp = 2 ρ ω² with p = 0 on the edges: a parabola and a series; in units of ρ ω² L², x and y in those of L.
double pressure_of_patch(double x, double y);
/// ∫ p dA of the same, by the double series of sines.
double mean_pressure_of_patch();

/// 2 (I(t)/I(0) − 1)/t² with I = Σ m x², t = 0.3/ω, started with the exact pressure.
double spreading(const RotatingPatch& patch);

}  // namespace verification
