#pragma once

#include "solver/particles/box.h"

namespace plumbline {

/// Φ_b(i) = Σₖ dₖ b^(−k−1), with dₖ the digits of i = Σₖ dₖ bᵏ: the digits mirrored at the point.
/// Rounded once, hence the double nearest to the exact value: numerator and denominator are whole
/// numbers below 2⁵³ as long as base · i is, which is so for every Index and base ≤ 5.
inline double radical_inverse(std::uint64_t base, std::uint64_t i) {
    std::uint64_t mirrored = 0, power = 1;
    for (; i > 0; i /= base) {
        mirrored = mirrored * base + i % base;
        power *= base;
    }
    return static_cast<double>(mirrored) / static_cast<double>(power);
}

/// `count` points of the Halton sequence, from its number `first` on: coordinate d of point i is
/// Φ_b(first + i) with b = 2, 3, 5. Not random, yet irregular; its star discrepancy is
/// O(log^Dim n / n) (Halton 1960), so each point stands for the volume of the box / count.
/// Another `first` gives another sample. Number 0, the low corner itself, is left out by default.
/// Throws InvalidInput for a box without extent, no points, or numbers beyond an Index.
template <int Dim> Points<Dim> halton(const Box<Dim>& box, Index count, Index first = 1) {
    constexpr std::uint64_t bases[] = {2, 3, 5};
    require_proper(box);
    require_count(count);
    require_count(static_cast<double>(first) + count);
    Points<Dim> points(count);
    for (Index i = 0; i < count; ++i) {
        Vec<Dim> u;
        for (int d = 0; d < Dim; ++d) u[d] = radical_inverse(bases[d], first + i);
        points[i] = box.at(u);
    }
    return points;
}

}  // namespace plumbline
