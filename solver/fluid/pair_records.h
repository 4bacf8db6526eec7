#pragma once

#include "solver/foundation/lanes.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/quantities.h"

#include <algorithm>
#include <array>
#include <optional>

namespace plumbline {

/// What a sum over pairs reads of a particle, or of several, one in each lane.
template <class Real, int Dim> struct FluidLanes {
    LaneVector<Real, Dim> x, v;
    Lanes<Real> m, rho, V, P;  // V = m/ρ, P = p/ρ²
};

/// The state of a fluid as sums over pairs read it: one record for each particle, in the precision Real,
/// so that a neighbour is one or two lines of memory. Single precision is enough for sums that are then added to a
/// state in double precision; distances are off by 6e-8 of the coordinates.
template <class Real, int Dim> class FluidRecords {
public:
    void pack(const Positions<Dim>& x, const Velocities<Dim>& v, const Masses& m,
              const Density& rho, const Pressure& p) {
        numbers_.resize(x.size() * stride);
        x_.resize(x.size());
        parallel_for_parts(x.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                Real* to = numbers_.data() + i * stride;
                const auto put = [&](double number) { *to++ = static_cast<Real>(number); };
                for (int d = 0; d < Dim; ++d) put(x[i][d]);
                for (int d = 0; d < Dim; ++d) put(v[i][d]);
                put(m[i]), put(rho[i]), put(m[i] / rho[i]), put(p[i] / (rho[i] * rho[i]));
                x_[i] = x[i].template cast<Real>();
            }
        });
    }
    std::size_t size() const { return x_.size(); }
    std::span<const VecOf<Real, Dim>> positions() const { return x_; }

    /// One in each lane.
    [[gnu::always_inline]] FluidLanes<Real, Dim> of(const Index* particles) const {
        Lanes<Real> all[stride];
        for_each_constant<static_cast<int>(stride / 4)>([&](auto block) {
            gather_four(numbers_.data() + 4 * block, stride, particles, all + 4 * block);
        });
        return named(all);
    }
    /// The same in all lanes.
    FluidLanes<Real, Dim> of(Index i) const {
        std::array<Index, Lanes<Real>::size> same;
        same.fill(i);
        return of(same.data());
    }
    std::size_t memory() const {
        return numbers_.capacity() * sizeof(Real) + x_.capacity() * sizeof(VecOf<Real, Dim>);
    }

private:
    static constexpr std::size_t stride = (2 * Dim + 4 + 3) / 4 * 4;

    static FluidLanes<Real, Dim> named(const Lanes<Real>* all) {
        FluidLanes<Real, Dim> f;
        for_each_constant<Dim>([&](auto d) { f.x.x[d] = all[d], f.v.x[d] = all[Dim + d]; });
        f.m = all[2 * Dim], f.rho = all[2 * Dim + 1];
        f.V = all[2 * Dim + 2], f.P = all[2 * Dim + 3];
        return f;
    }

    std::vector<Real> numbers_;
    std::vector<VecOf<Real, Dim>> x_;  // once more, as searches take them
};

/// The memory of a loop over pairs: kept from step to step, since new memory is slow.
template <class Real, int Dim, class Space = OpenSpace<Dim>> struct PairMemory {
    FluidRecords<Real, Dim> records;
    std::optional<CellGrid<Dim, Space, Real>> grid;
    std::size_t memory() const { return records.memory() + (grid ? grid->memory() : 0); }
};

/// Calls use(particles) for the particles of `row`, as many as there are lanes at a time; the last ones are
/// filled up with i itself, for which every term of a pair must be 0.
template <class Real, class Use>
[[gnu::always_inline]] inline void for_lanes_of(std::span<const Index> row, Index i, Use use) {
    constexpr std::size_t lanes = Lanes<Real>::size;
    std::array<Index, lanes> rest;
    for (std::size_t k = 0; k < row.size(); k += lanes) {
        const Index* next = row.data() + k;
        if (const std::size_t left = row.size() - k; left < lanes) {
            rest.fill(i);
            std::copy_n(next, left, rest.begin());
            next = rest.data();
        }
        use(next);
    }
}

}  // namespace plumbline
