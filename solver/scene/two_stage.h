#pragma once

#include "solver/scene/evolve.h"

namespace plumbline {

/// The explicit midpoint rule: rates at t, half a step with them, rates there, and with those the whole
/// step from t. Of order 2 for forces of any kind, at two evaluations per step; not symplectic: an
/// oscillation of angular frequency ω grows by (ωΔt)⁴/8 per step, so it needs some damping.
/// `Passes` add to the accelerations and to the rates of `Evolved`.
template <class Evolving, class... Passes> class TwoStage;

template <int Dim, class... Evolved, class... Passes>
class TwoStage<Evolve<Dim, Evolved...>, Passes...> {
    using Evolving = Evolve<Dim, Evolved...>;

public:
    using Writes =
        Union<typename Evolving::State, typename Evolving::Rates,
              Quantities<Before<Positions<Dim>>, Before<Velocities<Dim>>, Before<Evolved>...>,
              typename Passes::Writes...>;
    using Reads = Difference<Union<Quantities<>, typename Passes::Reads...>, Writes>;

    explicit TwoStage(Evolving, Passes... passes) : passes_{std::move(passes)...} {}

    template <class... Arrays> void run(double dt, Arrays&... arrays) const {
        const Arguments<Reads, Arrays...> at(arrays...);
        save<Positions<Dim>>(at);
        save<Velocities<Dim>>(at);
        (save<Evolved>(at), ...);
        move(at, 0.5 * dt, dt);
        move(at, dt, dt);
    }

private:
    template <class Q, class At> static void save(const At& at) {
        at.template get<Before<Q>>().assign(at.template get<Q>().begin(),
                                            at.template get<Q>().end());
    }
    template <class Q, class At> static void restart(const At& at, double dt, const auto& rate) {
        advance(at.template get<Q>(), at.template get<Before<Q>>(), dt, rate);
    }
    /// From the saved state by `by`, with the rates of the present one.
    template <class At> void move(const At& at, double by, double dt) const {
        Evolving::evaluate(at, dt, passes_);
        restart<Positions<Dim>>(at, by, at.template get<Velocities<Dim>>());
        restart<Velocities<Dim>>(at, by, at.template get<Accelerations<Dim>>());
        (restart<Evolved>(at, by, at.template get<Rate<Evolved>>()), ...);
    }

    std::tuple<Passes...> passes_;
};

template <int Dim, class... Evolved, class... Passes>
TwoStage(Evolve<Dim, Evolved...>, Passes...) -> TwoStage<Evolve<Dim, Evolved...>, Passes...>;

}  // namespace plumbline
