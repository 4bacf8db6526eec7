#pragma once

#include "solver/approximation/density.h"
#include "solver/approximation/shepard.h"
#include "solver/approximation/sph_interpolation.h"
#include "verification/framework/mutant.h"

namespace verification {

inline constinit Mutant unit_masses_for_shepard{29, "Sec. 2: Eq. 3 with mⱼ = 1 is Shepard's",
                                                "Shepard interpolation"};

/// The seam of Shepard interpolation: the solver's, or Eq. 3 with the densities of unit masses.
template <plumbline::RadialKernel K>
double shepard_under_test(const K& w, const plumbline::Samples<K::dim>& s,
                          std::span<const double> f, const plumbline::Place<K::dim>& at) {
    if (!unit_masses_for_shepard.applied()) return plumbline::shepard(w, s, f, at).value();
    const std::vector<double> one(s.x.size(), 1.0);
    const auto V = plumbline::volumes(w, s.x, std::span<const double>(one), s.neighbours);
    return plumbline::interpolate(w, plumbline::Samples<K::dim>{s.x, V, s.neighbours}, f, at);
}

}  // namespace verification
