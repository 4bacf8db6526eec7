#pragma once

#include "solver/particles/quantities.h"
#include "solver/scene/pass.h"

#include <cmath>
#include <optional>
#include <string_view>

namespace plumbline {

/// Finds out which pass of a step goes wrong. Not armed, it costs one branch per pass.
template <int Dim> struct Watch {
    bool armed = false;
    std::size_t particle = 0;  // whose accelerations are followed

    struct Fault {
        std::string_view term, quantity;
        std::size_t particle;
    };
    std::optional<Fault> first_fault = {};  // the first number that is not finite
    std::string_view strongest_term = {};   // that accelerated the particle most ...
    double strongest = 0.0;                 // ... by this much [m/s²]
};

/// A pass with the name of its physical term, under a watch that outlives the scene.
template <int Dim, class Pass> struct Watched {
    using Reads = typename Pass::Reads;
    using Writes = typename Pass::Writes;
    std::string_view term;
    Watch<Dim>* watch;
    Pass pass;

    template <class... Arrays> void run(double dt, Arrays&... arrays) const {
        if (!watch->armed) return pass.run(dt, arrays...);
        const Vec<Dim> before = (Vec<Dim>::Zero() + ... + push(dt, arrays));
        pass.run(dt, arrays...);
        const Vec<Dim> after = (Vec<Dim>::Zero() + ... + push(dt, arrays));
        if (const double change = (after - before).norm(); change > watch->strongest)
            watch->strongest = change, watch->strongest_term = term;
        (look(arrays), ...);
    }

private:
    /// a or v/Δt of the particle, if that is what the array holds and the pass may write it; 0 otherwise. Their sum
    /// changes by what a pass does to the particle, and not where a step turns a into v.
    template <class A> Vec<Dim> push(double dt, A& array) const {
        if constexpr (std::is_same_v<A, Accelerations<Dim>>) {
            if (watch->particle < array.size()) return array[watch->particle];
        } else if constexpr (std::is_same_v<A, Velocities<Dim>>) {
            if (watch->particle < array.size() && dt > 0.0) return array[watch->particle] / dt;
        }
        return Vec<Dim>::Zero();
    }
    template <class A> void look(A& array) const {
        if constexpr (!std::is_const_v<A> && requires {
                          typename A::set;
                          A::name;
                      }) {
            if constexpr (std::is_same_v<typename A::set, Particles>)
                for (std::size_t i = 0; i < array.size() && !watch->first_fault; ++i)
                    if (!is_finite(array[i])) watch->first_fault = {term, A::name, i};
        }
    }
    static bool is_finite(double x) { return std::isfinite(x); }
    static bool is_finite(const Vec<Dim>& x) { return x.allFinite(); }
};

/// Changes nothing: Watched behind a pass that is not watched itself, it looks at what that one wrote.
template <class... Qs> struct Inspect {
    using Reads = Quantities<>;
    using Writes = Quantities<Qs...>;
    void run(double, Qs&...) const {}
};

}  // namespace plumbline
