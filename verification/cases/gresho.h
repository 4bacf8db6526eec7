#pragma once

namespace verification {

/// A vortex without viscosity in the periodic box [−1/2, 1/2]² that would turn for ever: v = 5 r up to r = 0.2, 2 − 5 r
/// up to 0.4, 0 beyond; density 1, γ = 7.                     Gresho and Chan 1990
struct Gresho {
    double spacing = 1.0 / 16.0;  // [m]
    double support = 4.0;         // in spacings
    double viscosity = 0.0;       // α of ArtificialViscosity
    double diffusion = 0.1;       // δ of DensityDiffusion
    double shifting = 20.0;       // A of ShiftParticles
    double speed_of_sound = 6.0;  // in units of the largest speed: densities differ by 2 %
};

double velocity_of_gresho(double r);
/// Less that at the centre; it balances v²/r.
double pressure_of_gresho(double r);

/// Mean |v_φ − exact| after `duration` [s]; one turn of the core takes 1.26 s. No particle may start at the centre:
/// an even number of spacings per edge.
double error_of_gresho(const Gresho& vortex, double duration);

}  // namespace verification
