#pragma once

#include "verification/framework/patch.h"
#include "verification/kernels/under_test.h"

#include <limits>

namespace verification {

/// The unit roundoff: each operation is off by at most that much, relatively. A sum of n terms with k
/// operations each is off by at most (n + k) u Σ |terms|; claims measure their error relative to Σ |terms|.
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Samples as they come: disordered, of unequal mass; density and volumes by adams2009 Eqs. 4, 5 with
/// poly6.
template <int Dim> struct Disordered {
    UnderTest<plumbline::Poly6<Dim>> w;
    Patch<Dim> patch;
    std::vector<double> m, rho;

    /// `support` in spacings, of which each sample is moved up to `jitter`; masses between 1/2 and 3/2.
    explicit Disordered(double support, PatchShape shape = {.support = 0, .jitter = 0.3});

    plumbline::Samples<Dim> samples() const { return patch.samples(); }
    std::size_t size() const { return patch.x.size(); }
};

}  // namespace verification
