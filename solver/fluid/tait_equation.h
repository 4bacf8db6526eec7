#pragma once

#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/box.h"
#include "solver/particles/quantities.h"

#include <cmath>

namespace plumbline {

/// p = K ((ρ/ρ₀)^γ − 1) with K = ρ₀ c₀² / γ, so that c₀ is the speed of sound at ρ₀.     adams2009 Eq. 47
/// A fluid is compressed by about (v/c₀)²: c₀ of ten times the largest speed keeps that to 1 %.
class TaitEquation {
public:
    /// ρ₀ [kg/m^dim], c₀ [m/s], γ. Throws InvalidInput unless all are positive and γ ≥ 1.
    TaitEquation(double rest_density, double speed_of_sound, double exponent)
        : rho0_{rest_density}, c0_{speed_of_sound}, gamma_{exponent} {
        require_positive(rest_density, "rest density");
        require_positive(speed_of_sound, "speed of sound");
        require_positive(exponent, "exponent of the Tait equation");
        if (exponent < 1.0)
            throw InvalidInput("exponent of the Tait equation: expected at least 1, found " +
                               std::to_string(exponent));
    }

    double rest_density() const { return rho0_; }
    double stiffness() const { return rho0_ * c0_ * c0_ / gamma_; }  // K [Pa]

    /// p(ρ) [Pa].
    double pressure(double rho) const {
        if (gamma_ == 1.0) return c0_ * c0_ * (rho - rho0_);
        if (gamma_ == 7.0) {  // water's: pow takes as long as the sums over a few neighbours
            const double s = rho / rho0_, s2 = s * s;
            return stiffness() * (s2 * s2 * s2 * s - 1.0);
        }
        return stiffness() * (std::pow(rho / rho0_, gamma_) - 1.0);
    }
    /// The inverse: ρ(p). NaN below −K, which no density has.
    double density(double p) const { return rho0_ * std::pow(p / stiffness() + 1.0, 1.0 / gamma_); }

    /// c = √(dp/dρ) [m/s].
    double speed_of_sound(double rho) const {
        return c0_ * std::pow(rho / rho0_, 0.5 * (gamma_ - 1.0));
    }
    /// e(ρ) with de/dρ = p/ρ² and e(ρ₀) = 0 [J/kg]: what compression stores.
    double energy(double rho) const {
        const double s = rho / rho0_, g = gamma_;
        const double compressed = g == 1.0 ? std::log(s) : (std::pow(s, g - 1.0) - 1.0) / (g - 1.0);
        return stiffness() / rho0_ * (compressed + 1.0 / s - 1.0);
    }

private:
    double rho0_, c0_, gamma_;
};

/// pᵢ = p(ρᵢ) of each particle.                                                adams2009 Eq. 47
struct TaitPressure {
    using Reads = Quantities<Density>;
    using Writes = Quantities<Pressure>;
    TaitEquation equation;

    void run(double, const Density& rho, Pressure& p) const {
        parallel_for_parts(rho.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) p[i] = equation.pressure(rho[i]);
        });
    }
};

}  // namespace plumbline
