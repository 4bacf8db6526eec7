#pragma once

#include "solver/neighbours/near_points.h"

namespace plumbline {

/// Vectors of so many bytes, as GCC and Clang have them, with operators.
template <class Real_, std::size_t Bytes> struct VectorOf {
    using Real = Real_;
    typedef Real Vector __attribute__((vector_size(Bytes)));
    static constexpr std::size_t size = Bytes / sizeof(Real);

    static Vector all(Real x) { return x - Vector{}; }
    static Vector load(const Real* p) {
        Vector v;
        __builtin_memcpy(&v, p, sizeof v);
        return v;
    }
    static Vector into_box(Vector d, Vector edge, Vector half, Vector minus_half) {
        return (d - (d > half ? edge : Vector{})) + (d < minus_half ? edge : Vector{});
    }
};

/// The distance test for all lanes of a vector at once. `Lanes` is a VectorOf with what differs between
/// instruction sets: larger(a, b); below(a, b) -> bits; pack(vector, bits, out), which writes the lanes
/// whose bits are set to `out`, and then others; and store(ids, bits, out), which does so with the ids
/// of a step.
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

    static std::size_t keep(const BoxTest<Real>& shared_test) {
        const BoxTest<Real> test = shared_test;  // a copy, which what is moved cannot change
        Vector low[Dim], high[Dim], edge[Dim];
        for (int axis = 0; axis < Dim; ++axis) {
            low[axis] = Lanes::all(test.low[axis]);
            high[axis] = Lanes::all(test.high[axis]);
            if (Periodic) edge[axis] = Lanes::all(test.edge[axis]);
        }
        const auto gap = [&](int axis, Vector x) {
            const Vector below = low[axis] - x, above = x - high[axis];
            const Vector direct = Lanes::larger(Lanes::larger(below, above), Vector{});
            if (!Periodic) return direct;
            const Vector through = edge[axis] - Lanes::larger(-below, -above);
            return -Lanes::larger(-direct, -Lanes::larger(through, Vector{}));
        };
        const Vector limit = Lanes::all(test.squared_radius);
        constexpr std::size_t vectors = step / Lanes::size;
        constexpr unsigned all_lanes = (1u << Lanes::size) - 1;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < test.size; k += step) {
            Vector x[vectors][Dim];
            unsigned bits = 0;
            for (std::size_t v = 0; v < vectors; ++v) {
                Vector squared{};
                for (int axis = 0; axis < Dim; ++axis) {
                    x[v][axis] = Lanes::load(test.x[axis] + k + v * Lanes::size);
                    const Vector g = gap(axis, x[v][axis]);
                    squared = squared + g * g;
                }
                bits |= Lanes::below(squared, limit) << v * Lanes::size;
            }
            if (k + step > test.size) bits &= (1u << (test.size - k)) - 1;
            Lanes::store(test.id + k, bits, test.id + kept);
            for (std::size_t v = 0; v < vectors; ++v) {
                const unsigned these = bits >> v * Lanes::size & all_lanes;
                for (int axis = 0; axis < Dim; ++axis)
                    Lanes::pack(x[v][axis], these, test.x[axis] + kept);
                kept += static_cast<std::size_t>(__builtin_popcount(these));
            }
        }
        return kept;
    }

private:
    /// The differences of a test along one axis.
    struct Axis {
        Vector centre, edge, half, minus_half;
        const Real* x;

        Axis() = default;
        Axis(const NearTest<Real>& test, int axis)
            : centre{Lanes::all(test.centre[axis])},
              edge{Lanes::all(test.edge[axis])},
              half{Lanes::all(Real(0.5) * test.edge[axis])},
              minus_half{Lanes::all(Real(-0.5) * test.edge[axis])},
              x{test.x[axis]} {}
        Vector difference(std::size_t k) const {
            const Vector d = centre - Lanes::load(x + k);
            return Periodic ? Lanes::into_box(d, edge, half, minus_half) : d;
        }
    };
    static constexpr std::size_t step = candidates_per_step;

    /// One bit for each candidate of the step that begins with k.
    struct Exactly {
        Axis axes[Dim];
        Vector limit;

        explicit Exactly(const NearTest<Real>& test) : limit{Lanes::all(test.squared_radius)} {
            for (int axis = 0; axis < Dim; ++axis) axes[axis] = Axis(test, axis);
        }
        [[gnu::always_inline]] unsigned operator()(std::size_t k) const {
            unsigned bits = 0;
            for (std::size_t lane = 0; lane < step; lane += Lanes::size) {
                Vector d = axes[0].difference(k + lane);
                Vector squared = d * d;
                for (int axis = 1; axis < Dim; ++axis) {
                    d = axes[axis].difference(k + lane);
                    squared = squared + d * d;
                }
                bits |= Lanes::below(squared, limit) << lane;
            }
            return bits;
        }
    };
    /// The same in single precision, where it can tell.
    struct Roundedly {
        using Single = typename Lanes::Rounded;
        typename Single::Vector centre[Dim], near, perhaps;
        const float* x[Dim];
        const NearTest<Real>& exact;

        explicit Roundedly(const NearTest<Real>& test)
            : near{Single::all(test.rounded.near)},
              perhaps{Single::all(test.rounded.perhaps)},
              exact{test} {
            for (int axis = 0; axis < Dim; ++axis) {
                centre[axis] = Single::all(test.rounded.centre[axis]);
                x[axis] = test.rounded.x[axis];
            }
        }
        [[gnu::always_inline]] unsigned operator()(std::size_t k) const {
            unsigned bits = 0, sure = 0;
            for (std::size_t lane = 0; lane < step; lane += Single::size) {
                typename Single::Vector squared{};
                for (int axis = 0; axis < Dim; ++axis) {
                    const auto d = centre[axis] - Single::load(x[axis] + k + lane);
                    squared = squared + d * d;
                }
                bits |= Single::below(squared, perhaps) << lane;
                sure |= Single::below(squared, near) << lane;
            }
            return __builtin_expect(bits == sure, 1) ? bits : exactly(exact, k);
        }
        [[gnu::noinline]] static unsigned exactly(const NearTest<Real>& test, std::size_t k) {
            return Exactly(test)(k);
        }
    };

    /// Calls use(ids, bits, number of the step) for each step of candidates.
    template <class Use>
    [[gnu::always_inline]] static void for_each_step(const NearTest<Real>& test, Use use) {
        if constexpr (sizeof(Real) == sizeof(double) && !Periodic) {
            if (test.rounded.x[0] != nullptr) return for_each_step(test, Roundedly(test), use);
        }
        for_each_step(test, Exactly(test), use);
    }
    template <class BitsOf, class Use>
    [[gnu::always_inline]] static void for_each_step(const NearTest<Real>& test,
                                                     const BitsOf bits_of, Use use) {
        const std::uint32_t* const id = test.id;  // copies, which what `use` writes cannot change
        const std::size_t from = test.from, size = test.size;
        for (std::size_t k = from / step * step; k < size; k += step) {
            unsigned bits = bits_of(k);
            if (k < from) bits &= ~0u << (from - k);
            use(id + k, bits, k / step);
        }
    }
};

/// The functions of near_functions (near_points.h) for one instruction set.
template <class Lanes>
NearFunctions<typename Lanes::Real> near_functions_of(int dim, bool periodic) {
    using Real = typename Lanes::Real;
    const auto of = []<class Near>(Near) {
        return NearFunctions<Real>{Near::select, Near::mark, Near::take, Near::keep};
    };
    if (dim == 1)
        return periodic ? of(NearLanes<Lanes, 1, true>{}) : of(NearLanes<Lanes, 1, false>{});
    if (dim == 2)
        return periodic ? of(NearLanes<Lanes, 2, true>{}) : of(NearLanes<Lanes, 2, false>{});
    return periodic ? of(NearLanes<Lanes, 3, true>{}) : of(NearLanes<Lanes, 3, false>{});
}

}  // namespace plumbline
