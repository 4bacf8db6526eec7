#pragma once

#include "solver/approximation/at_all.h"
#include "solver/approximation/samples.h"
#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"

#include <cmath>
#include <string>

namespace plumbline {

/// ρ(x) = Σⱼ ω(‖x − xⱼ‖) mⱼ                                                adams2009 Eqs. 5, 7
/// `x`, `m`: n positions [m] and masses [kg]; result [kg/m^dim]. A sample feels itself. Too small
/// where the support sticks out of the samples: 0 far from all of them.
template <RadialKernel K>
double density(const K& w, std::span<const Vec<K::dim>> x, std::span<const double> m,
               const Place<K::dim>& at) {
    return sum<double>(at.neighbours,
                       [&](Index j) { return w.value((at.x - x[j]).norm()) * m[j]; });
}

/// Throws InvalidInput, naming the first sample whose value is not positive and finite.
inline void require_positive(const char* what, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(values[i] > 0.0 && values[i] < HUGE_VAL))
            throw InvalidInput("volumes: expected a positive finite " + std::string(what) +
                               ", found " + std::to_string(values[i]) + " at sample " +
                               std::to_string(i));
}

/// Vᵢ = mᵢ / ρᵢ [m^dim], of all samples, with the density of Eq. 5                adams2009 Eq. 4
/// Throws InvalidInput where a mass is not positive and finite, or a density is not.
template <RadialKernel K>
std::vector<double> volumes(const K& w, std::span<const Vec<K::dim>> x, std::span<const double> m,
                            const NeighbourLists& neighbours) {
    require_positive("mass", m);
    const std::vector<double> rho = at_all(x.size(), [&](Index i) {
        return density(w, x, m, Place<K::dim>{x[i], neighbours.of(i)});
    });
    require_positive("density", rho);
    std::vector<double> V;
    for (std::size_t i = 0; i < rho.size(); ++i) V.push_back(m[i] / rho[i]);
    return V;
}

}  // namespace plumbline
