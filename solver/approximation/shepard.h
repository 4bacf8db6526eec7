#pragma once

#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

#include <cmath>
#include <optional>

namespace plumbline {

/// f̄ = Σⱼ ωⱼ Vⱼ fⱼ / W and W = Σⱼ ωⱼ Vⱼ with ωⱼ = ω(‖x − xⱼ‖).
struct WeightedMean {
    double value, weights;
};

/// Empty where the weights sum to 0. A sample of infinite weight, at x with a singular kernel, outweighs
/// all others.
template <RadialKernel K>
std::optional<WeightedMean> weighted_mean(const K& w, const Samples<K::dim>& s,
                                          std::span<const double> f, const Place<K::dim>& at) {
    const auto weight = [&](Index j) { return w.value((at.x - s.x[j]).norm()) * s.V[j]; };
    double weights = 0.0, weighted = 0.0;
    for (const Index j : at.neighbours) {
        const double w_j = weight(j);
        weights += w_j;
        weighted += w_j * f[j];
    }
    if (!(weights > 0.0)) return std::nullopt;
    if (weights < HUGE_VAL) return WeightedMean{weighted / weights, weights};
    double n = 0.0, total = 0.0;
    for (const Index j : at.neighbours)
        if (weight(j) == HUGE_VAL) n += 1.0, total += f[j];
    if (n == 0.0) return std::nullopt;
    return WeightedMean{total / n, weights};
}

/// ⟨f⟩(x) = Σⱼ Φⱼ fⱼ with Φⱼ = ω(‖x − xⱼ‖) Vⱼ / Σₖ ω(‖x − xₖ‖) Vₖ
/// Shepard 1968; adams2009, text after Eq. 7: not the same as Eq. 3 with mⱼ = 1 (erratum 29), but
/// MLS of order 0. `f`: n samples of unit U; result [U]. Exact for constant f; within the range of
/// the neighbours' f. Takes the value fⱼ at xⱼ if the kernel is singular (Sec. 2.1). Empty where no
/// sample is near: the weights sum to 0.
template <RadialKernel K>
std::optional<double> shepard(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                              const Place<K::dim>& at) {
    const auto mean = weighted_mean(w, s, f, at);
    if (!mean) return std::nullopt;
    return mean->value;
}

/// ∇⟨f⟩(x) = Σⱼ (fⱼ − ⟨f⟩(x)) ∇ω(x − xⱼ) Vⱼ / Σₖ ω(‖x − xₖ‖) Vₖ
/// The exact derivative of `shepard`, by the quotient rule [U/m]. Zero to rounding for constant f; not
/// exact for linear f. Empty where `shepard` is, and at a sample if the kernel is singular.
template <RadialKernel K>
std::optional<Vec<K::dim>> shepard_gradient(const K& w, const Samples<K::dim>& s,
                                            std::span<const double> f, const Place<K::dim>& at) {
    using V = Vec<K::dim>;
    const auto mean = weighted_mean(w, s, f, at);
    if (!mean || mean->weights == HUGE_VAL) return std::nullopt;
    const V weighted = sum<V>(at.neighbours, [&](Index j) -> V {
        return (f[j] - mean->value) * s.V[j] * gradient(w, V(at.x - s.x[j]));
    });
    return V(weighted / mean->weights);
}

/// Δ⟨f⟩(x) = Σⱼ ((fⱼ − ⟨f⟩) Δω(‖x − xⱼ‖) − 2 ∇⟨f⟩ · ∇ω(x − xⱼ)) Vⱼ / Σₖ ω(‖x − xₖ‖) Vₖ
/// The exact Laplacian of `shepard`, by the quotient rule [U/m²]. Zero to rounding for constant f; not
/// exact for linear f. Empty where `shepard_gradient` is.
template <RadialKernel K>
std::optional<double> shepard_laplacian(const K& w, const Samples<K::dim>& s,
                                        std::span<const double> f, const Place<K::dim>& at) {
    using V = Vec<K::dim>;
    const auto mean = weighted_mean(w, s, f, at);
    const auto grad = shepard_gradient(w, s, f, at);
    if (!mean || !grad) return std::nullopt;
    const double weighted = sum<double>(at.neighbours, [&](Index j) {
        const V x = at.x - s.x[j];
        return ((f[j] - mean->value) * laplacian(w, x.norm()) - 2.0 * grad->dot(gradient(w, x))) *
               s.V[j];
    });
    return weighted / mean->weights;
}

}  // namespace plumbline
