#pragma once

#include <cmath>

namespace plumbline {

/// A number as value + rest, where rest is what rounding took from value: differences and products
/// keep about 100 bits, at a few operations each. It keeps kernels accurate to the last place where
/// rounding errors would be raised to a high power, as in (1 − q)⁸.
struct Twofold {
    double value, rest;
};

/// a − b without error, for |a| ≥ |b|.                                                Dekker 1971
inline Twofold difference(double a, double b) {
    const double value = a - b;
    return {value, (a - value) - b};
}

/// a + b without error, for |a| ≥ |b|.                                                Dekker 1971
inline Twofold sum(double a, double b) { return difference(a, -b); }

/// a b to about 2⁻¹⁰⁰ relative: the rests' product is left out. One fused multiply-add finds what
/// rounding takes from the product of the values.
inline Twofold operator*(const Twofold& a, const Twofold& b) {
    const double value = a.value * b.value;
    return {value, std::fma(a.value, b.value, -value) + (a.value * b.rest + a.rest * b.value)};
}
inline Twofold square(double a) {
    const double value = a * a;
    return {value, std::fma(a, a, -value)};
}

/// a b, rounded once: the nearest double or its neighbour.
inline double rounded_product(const Twofold& a, const Twofold& b) {
    return std::fma(a.value, b.value, a.value * b.rest + a.rest * b.value);
}

}  // namespace plumbline
