#pragma once

#include "solver/foundation/parallel.h"
#include "solver/foundation/sum.h"
#include "solver/particles/quantities.h"
#include "solver/scene/pass.h"

namespace plumbline {

/// What an integrator that evaluates rates itself advances: positions, velocities and the quantities
/// `Evolved`, each by its Rate.
template <int Dim, class... Evolved> struct Evolve {
    using State = Quantities<Positions<Dim>, Velocities<Dim>, Evolved...>;
    using Rates = Quantities<Accelerations<Dim>, Rate<Evolved>...>;

    /// f(q, dq/dt) for the velocities and for each of `Evolved`: all but the positions.
    template <class Lookup, class F> static void for_each_rate(const Lookup& at, F f) {
        f(at(std::type_identity<Velocities<Dim>>{}), at(std::type_identity<Accelerations<Dim>>{}));
        (f(at(std::type_identity<Evolved>{}), at(std::type_identity<Rate<Evolved>>{})), ...);
    }

    /// Runs the passes that add to the rates, from zero.
    template <class Lookup, class... Passes>
    static void evaluate(const Lookup& at, double dt, const std::tuple<Passes...>& passes) {
        for_each_rate(at, [](const auto& q, auto& rate) {
            using T = typename std::remove_cvref_t<decltype(q)>::value_type;
            rate.resize(q.size());
            parallel_for_parts(q.size(), [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) rate[i] = zero<T>();
            });
        });
        run_passes(passes, dt, at);
    }
};

/// An array as it was at the start of a step.
template <class Q> struct Before : Each<typename Q::value_type, typename Q::set> {
    static constexpr std::string_view name = "earlier values";
};

/// q = start + dt · rate, member by member; `q` and `start` may be one array.
template <class Q, class Start, class R>
void advance(Q& q, const Start& start, double dt, const R& rate) {
    parallel_for_parts(q.size(), [&](std::size_t first, std::size_t last) {
        const double step = dt;  // a copy, which what is written cannot change
        for (std::size_t i = first; i < last; ++i) q[i] = start[i] + step * rate[i];
    });
}

}  // namespace plumbline
