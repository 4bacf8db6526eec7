#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

#include <functional>

namespace verification {

/// What a term of a pair may depend on, beside the neighbour itself.
template <int Dim> struct PairState {
    const plumbline::Velocities<Dim>& v;
    const plumbline::Masses& m;
    const plumbline::Density& rho;
};

/// aᵢ += Σⱼ term(i, neighbour, state): forces that are wrong on purpose, or printed so.
template <int Dim, class Space = plumbline::OpenSpace<Dim>> struct PairForce {
    using Reads = plumbline::Quantities<plumbline::Positions<Dim>, plumbline::Velocities<Dim>,
                                        plumbline::Masses, plumbline::Density,
                                        plumbline::Neighbourhood<Dim, Space>>;
    using Writes = plumbline::Quantities<plumbline::Accelerations<Dim>>;
    /// One type for all terms keeps the number of kinds of scenes, and the time to compile them, low.
    using Term = std::function<plumbline::Vec<Dim>(
        plumbline::Index, const plumbline::Neighbour<Dim>&, const PairState<Dim>&)>;
    Term term;
    explicit PairForce(Term t) : term{std::move(t)} {}

    void run(double, const plumbline::Positions<Dim>& x, const plumbline::Velocities<Dim>& v,
             const plumbline::Masses& m, const plumbline::Density& rho,
             const plumbline::Neighbourhood<Dim, Space>& near,
             plumbline::Accelerations<Dim>& a) const {
        using Vec = plumbline::Vec<Dim>;
        const PairState<Dim> state{v, m, rho};
        for (plumbline::Index i = 0; i < x.size(); ++i)
            a[i] += near.template sum<Vec>(x, i,
                                           [&](const auto& n) -> Vec { return term(i, n, state); });
    }
};

}  // namespace verification
