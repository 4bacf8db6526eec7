#pragma once

#include "verification/cases/water_tank.h"

namespace verification {

/// How water in a tank dies down after a push in its first mode, k = π/L: its share of the velocities,
/// Σ m v·u / Σ m u², u = ∇(cos kx cosh ky), is followed over `periods`.
struct SloshingDecay {
    double frequency;  // ω, of a line through its zeros [1/s]
    double decay;      // δ of exp(−δ t), of a line through the logarithms of its extremes [1/s]
};
/// `steepness` is k a, a the height of the wave.
SloshingDecay sloshing_decay(WaterTank tank, double steepness, int periods);

/// ω² = g k tanh kh of the first mode.
double sloshing_frequency(const WaterTank& tank);

/// How the water stands `from_wall` off the left wall, against its depth at rest [m].
struct Elevation {
    std::vector<double> t, height;  // [s], [m]
};
Elevation swayed_elevation(const WaterTank& tank, double from_wall, double duration);

/// The same by linear theory, of a tank that moves to sway · cos(2π t/period) from rest: modes cos nkx, n odd, below
/// `modes`.                                                              Faltinsen 1978
double linear_elevation(const WaterTank& tank, double from_wall, double t, int modes = 40);

}  // namespace verification
