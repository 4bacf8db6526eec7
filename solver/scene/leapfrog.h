#pragma once

#include "solver/scene/evolve.h"

namespace plumbline {

/// Whether the rates are those of the present state. Whoever changes the state between two steps of
/// Leapfrog sets it to false, and the next step evaluates them anew.
struct RatesAreCurrent {
    bool value = false;
};

/// Kick, drift, kick: v½ = v + Δt/2 a(t),  x(t + Δt) = x + Δt v½,  v(t + Δt) = v½ + Δt/2 a(t + Δt).
/// Of order 2 at one evaluation of the forces per step; symplectic if they depend on x alone. Those
/// that depend on v are evaluated with the prediction v½ + Δt/2 a(t), which keeps the order.
/// `Passes` add to the accelerations. Rates of `Evolved` are treated as accelerations are.
/// A fixed Δt keeps the step symplectic.
template <class Evolving, class... Passes> class Leapfrog;

template <int Dim, class... Evolved, class... Passes>
class Leapfrog<Evolve<Dim, Evolved...>, Passes...> {
    using Evolving = Evolve<Dim, Evolved...>;
    template <class Q>
    using RateOf =
        std::conditional_t<std::is_same_v<Q, Velocities<Dim>>, Accelerations<Dim>, Rate<Q>>;

public:
    using Writes =
        Union<typename Evolving::State, typename Evolving::Rates,
              Quantities<Before<Accelerations<Dim>>, Before<Rate<Evolved>>..., RatesAreCurrent>,
              typename Passes::Writes...>;
    using Reads = Difference<Union<Quantities<>, typename Passes::Reads...>, Writes>;

    explicit Leapfrog(Evolving, Passes... passes) : passes_{std::move(passes)...} {}

    template <class... Arrays> void run(double dt, Arrays&... arrays) const {
        const Arguments<Reads, Arrays...> at(arrays...);
        auto& x = at.template get<Positions<Dim>>();
        auto& v = at.template get<Velocities<Dim>>();
        auto& a = at.template get<Accelerations<Dim>>();
        auto& before = at.template get<Before<Accelerations<Dim>>>();
        auto& current = at.template get<RatesAreCurrent>().value;
        if (!current) Evolving::evaluate(at, dt, passes_);
        current = true;
        before.swap(a);
        (at.template get<Before<Rate<Evolved>>>().swap(at.template get<Rate<Evolved>>()), ...);
        advance(v, v, 0.5 * dt, before);
        advance(x, x, dt, v);
        predict<Velocities<Dim>>(at, 0.5 * dt);
        (predict<Evolved>(at, dt), ...);
        Evolving::evaluate(at, dt, passes_);
        correct<Velocities<Dim>>(at, 0.5 * dt);
        (correct<Evolved>(at, 0.5 * dt), ...);
    }

private:
    template <class Q, class At> static void predict(const At& at, double dt) {
        auto& q = at.template get<Q>();
        advance(q, q, dt, at.template get<Before<RateOf<Q>>>());
    }
    /// From the prediction with the earlier rate to the mean of both rates.
    template <class Q, class At> static void correct(const At& at, double half) {
        auto& q = at.template get<Q>();
        const auto& rate = at.template get<RateOf<Q>>();
        const auto& before = at.template get<Before<RateOf<Q>>>();
        parallel_for_parts(q.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) q[i] += half * (rate[i] - before[i]);
        });
    }

    std::tuple<Passes...> passes_;
};

template <int Dim, class... Evolved, class... Passes>
Leapfrog(Evolve<Dim, Evolved...>, Passes...) -> Leapfrog<Evolve<Dim, Evolved...>, Passes...>;

}  // namespace plumbline
