#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace plumbline {

/// a₀ + a₁ x + a₂ x² + …, one rounding per degree (Horner's rule with fused multiply-adds).
template <std::size_t N> double polynomial(const std::array<double, N>& a, double x) {
    double p = a[N - 1];
    for (std::size_t k = N - 1; k-- > 0;) p = std::fma(p, x, a[k]);
    return p;
}

}  // namespace plumbline
