#pragma once

#include "solver/foundation/random.h"
#include "solver/neighbours/candidates.h"

namespace verification {

/// A query and n candidates on multiples of 0.1 in [-0.8, 0.8], so that many are at the radius.
template <class Real, int Dim> struct NearCase {
    plumbline::Candidates<Dim, Real> candidates;
    plumbline::VecOf<Real, Dim> centre;
    Real squared_radius = Real(0.5) * Real(0.5);

    explicit NearCase(std::size_t n) {
        plumbline::Random random(31 + n);
        const auto draw = [&](double most) {
            return static_cast<Real>(std::round(random.uniform(-most, most)) * 0.1);
        };
        candidates.resize(n);
        for (int a = 0; a < Dim; ++a) {
            centre[a] = draw(8.0);
            for (std::size_t k = 0; k < n; ++k) candidates.x(a)[k] = draw(8.0);
        }
        for (std::size_t k = 0; k < n; ++k)
            candidates.id()[k] = static_cast<plumbline::Index>(random.bits());
        candidates.close();
    }
    plumbline::VecOf<Real, Dim> point(std::size_t k) const {
        plumbline::VecOf<Real, Dim> x;
        for (int a = 0; a < Dim; ++a) x[a] = candidates.x(a)[k];
        return x;
    }
    template <class Space>
    plumbline::NearTest<Real> test(const Space& space, std::size_t from) const {
        return candidates.near(space, centre, squared_radius, from);
    }
};

}  // namespace verification
