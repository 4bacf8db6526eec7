#pragma once

#include "solver/foundation/types.h"

#include <cstdint>

namespace verification {

/// u = sin 2πx cos 2πy e^(−t), v = −cos 2πx sin 2πy e^(−t), p = cos 2πx cos 4πy e^(−t)/2 on the periodic unit square:
/// density 1, without divergence, driven by the force that makes it exact.  As Negi and Ramachandran 2021
struct ManufacturedFlow {
    static constexpr double viscosity = 0.01;  // ν

    static plumbline::Vec<2> velocity(const plumbline::Vec<2>& x, double t);
    static double pressure(const plumbline::Vec<2>& x, double t);
    static plumbline::Vec<2> pressure_gradient(const plumbline::Vec<2>& x, double t);
    static plumbline::Vec<2> laplacian(const plumbline::Vec<2>& x, double t);  // of the velocity
    static plumbline::Vec<2> force(const plumbline::Vec<2>& x, double t);  // Dv/Dt + ∇p − ν Δv
};

/// The particles that an error is measured on: `spacing` 1/n, moved by `jitter` spacings.
struct ManufacturedSamples {
    double spacing;
    double support = 4.0;  // in spacings
    double jitter = 0.0;
    std::uint64_t seed = 1;
};

/// What one evaluation of each term gives for the exact fields, less what it should: mean and largest length.
struct TermErrors {
    double mean, largest;
};
enum class Term {
    continuity,
    divergence_alone,  // −Σⱼ mⱼ vⱼ·∇ω, adams2009 Eq. 9: Continuity without vᵢ
    pressure,
    averaged_pressure,
    printed_averaged_pressure,  // with the 1/2 of adams2009
    brookshaw,
    monaghan
};
TermErrors errors_of_term(const ManufacturedSamples& samples, Term term);

/// Mean and largest ‖v − exact‖ at t = 0.5, over e^(−0.5); `force` is a factor of the force, 1 but for mistakes.
TermErrors errors_of_run(const ManufacturedSamples& samples, double force = 1.0);

}  // namespace verification
