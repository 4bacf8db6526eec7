#pragma once

#include "solver/approximation/density.h"
#include "verification/framework/patch.h"

#include <limits>

namespace verification {

/// The unit roundoff: each operation is off by at most that much, relatively. A sum of n terms with k
/// operations each is off by at most (n + k) u Σ |terms|; claims measure their error relative to Σ |terms|.
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Samples as they come: disordered, of unequal mass; density and volumes by adams2009 Eqs. 4, 5.
template <class K> struct Disordered {
    K w;
    Patch<K::dim> patch;
    std::vector<double> m, rho;

    /// `support` in spacings, of which each sample is moved up to `jitter`; masses between 1/2 and 3/2.
    explicit Disordered(double support, PatchShape shape = {.support = 0, .jitter = 0.3})
        : w(support), patch(cubic_lattice<K::dim>(1.0), with_support(shape, support)) {
        plumbline::Random random(shape.seed + 1);
        for (std::size_t i = 0; i < patch.x.size(); ++i) m.push_back(random.uniform(0.5, 1.5));
        const auto s = patch.samples();
        rho = plumbline::at_all(m.size(), [&](plumbline::Index i) {
            return plumbline::density<K>(w, patch.x, m, s.at(i));
        });
        patch.V = plumbline::volumes<K>(w, patch.x, m, patch.neighbours);
    }

    plumbline::Samples<K::dim> samples() const { return patch.samples(); }
    std::size_t size() const { return patch.x.size(); }

private:
    static PatchShape with_support(PatchShape shape, double support) {
        shape.support = support;
        return shape;
    }
};

}  // namespace verification
