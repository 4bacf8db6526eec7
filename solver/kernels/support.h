#pragma once

#include "solver/foundation/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

namespace plumbline {

/// The support radius h of a kernel [m], and lengths in units of a power of two near h: scaling by it
/// is exact, and no power of a scaled length overflows or underflows, however small h is.
class Support {
public:
    static constexpr double smallest = 1e-50, largest = 1e50;

    /// Throws InvalidInput, naming the kernel, unless smallest ≤ radius ≤ largest [m].
    Support(std::string_view kernel, double radius) : radius_{radius} {
        if (!(smallest <= radius && radius <= largest)) throw InvalidInput(message(kernel, radius));
        unit_ = std::exp2(-std::ilogb(radius));
        scaled_ = radius * unit_;
    }

    double radius() const { return radius_; }  // h [m]
    double scaled() const { return scaled_; }  // h in units, 1 ≤ scaled < 2

    /// r ≥ 0 in units, and scaled() for every r ≥ h: a kernel that is 0 at the rim needs no test of
    /// its own for being outside. NaN stays NaN.
    double clamp(double r) const { return std::min(r, radius_) * unit_; }

    /// sigma / (h^(dim + derivatives) · scaled^degree): what a homogeneous polynomial of that degree in
    /// scaled lengths is multiplied with to be a kernel's derivative of that order
    /// [m^-(dim + derivatives)].
    double factor(long double sigma, int dim, int degree, int derivatives = 0) const {
        const auto power = [](long double base, int exponent) { return std::pow(base, exponent); };
        return static_cast<double>(sigma / power(radius_, dim + derivatives) /
                                   power(scaled_, degree));
    }

private:
    static std::string message(std::string_view kernel, double radius) {
        std::ostringstream text;
        text << kernel << ": expected a support radius from " << smallest << " to " << largest
             << ", found " << radius;
        return text.str();
    }

    double radius_, unit_, scaled_;
};

}  // namespace plumbline
