#pragma once

#include "solver/neighbours/near_points.h"

namespace plumbline {

/// The distance test for all lanes of a vector at once. `Lanes` wraps the instructions of one set:
/// Real, Vector, size, all(x), load(p), subtract, add, multiply, into_box(difference, edge, edge / 2,
/// -edge / 2), below(a, b) -> bits, and store(ids, bits, out), which writes the ids of a step whose
/// bits are set to `out`, and then up to a step of others.
template <class Lanes, int Dim, bool Periodic> struct NearLanes {
    using Real = typename Lanes::Real;
    using Vector = typename Lanes::Vector;

    using Bits = typename NearFunctions<Real>::Bits;

    static std::size_t select(const NearTest<Real>& test, std::uint32_t* out) {
        std::size_t found = 0;
        for_each_step(test, [&](const std::uint32_t* id, unsigned bits, std::size_t) {
            Lanes::store(id, bits, out + found);
            found += static_cast<std::size_t>(__builtin_popcount(bits));
        });
        return found;
    }
    static std::size_t mark(const NearTest<Real>& test, Bits* all_bits) {
        std::size_t found = 0;
        for_each_step(test, [&](const std::uint32_t*, unsigned bits, std::size_t step) {
            if (all_bits != nullptr) all_bits[step] = static_cast<Bits>(bits);
            found += static_cast<std::size_t>(__builtin_popcount(bits));
        });
        return found;
    }
    static std::size_t take(const NearTest<Real>& test, const Bits* bits, std::uint32_t* out) {
        const std::uint32_t* id = test.id;
        const std::size_t size = test.size;
        std::size_t found = 0;
        for (std::size_t k = 0; k < size; k += candidates_per_step) {
            const unsigned these = bits[k / candidates_per_step];
            Lanes::store(id + k, these, out + found);
            found += static_cast<std::size_t>(__builtin_popcount(these));
        }
        return found;
    }

private:
    /// Calls use(ids, bits, number of the step) for each step of candidates.
    template <class Use>
    [[gnu::always_inline]] static void for_each_step(const NearTest<Real>& shared_test, Use use) {
        const NearTest<Real> test = shared_test;  // a copy, which what `use` writes cannot change
        Vector centre[Dim], edge[Dim], half[Dim], minus_half[Dim];
        for (int axis = 0; axis < Dim; ++axis) {
            centre[axis] = Lanes::all(test.centre[axis]);
            if (!Periodic) continue;
            edge[axis] = Lanes::all(test.edge[axis]);
            half[axis] = Lanes::all(Real(0.5) * test.edge[axis]);
            minus_half[axis] = Lanes::all(Real(-0.5) * test.edge[axis]);
        }
        const Vector limit = Lanes::all(test.squared_radius);
        const auto difference = [&](int axis, std::size_t k) {
            const Vector d = Lanes::subtract(centre[axis], Lanes::load(test.x[axis] + k));
            if (!Periodic) return d;
            return Lanes::into_box(d, edge[axis], half[axis], minus_half[axis]);
        };
        constexpr std::size_t step = candidates_per_step;
        for (std::size_t k = test.from / step * step; k < test.size; k += step) {
            unsigned bits = 0;
            for (std::size_t lane = 0; lane < step; lane += Lanes::size) {
                Vector d = difference(0, k + lane);
                Vector squared = Lanes::multiply(d, d);
                for (int axis = 1; axis < Dim; ++axis) {
                    d = difference(axis, k + lane);
                    squared = Lanes::add(squared, Lanes::multiply(d, d));
                }
                bits |= Lanes::below(squared, limit) << lane;
            }
            if (k < test.from) bits &= ~0u << (test.from - k);
            use(test.id + k, bits, k / step);
        }
    }
};

/// The functions of near_functions (near_points.h) for one instruction set.
template <class Lanes>
NearFunctions<typename Lanes::Real> near_functions_of(int dim, bool periodic) {
    using Real = typename Lanes::Real;
    const auto of = []<class Near>(Near) {
        return NearFunctions<Real>{Near::select, Near::mark, Near::take};
    };
    if (dim == 1)
        return periodic ? of(NearLanes<Lanes, 1, true>{}) : of(NearLanes<Lanes, 1, false>{});
    if (dim == 2)
        return periodic ? of(NearLanes<Lanes, 2, true>{}) : of(NearLanes<Lanes, 2, false>{});
    return periodic ? of(NearLanes<Lanes, 3, true>{}) : of(NearLanes<Lanes, 3, false>{});
}

}  // namespace plumbline
