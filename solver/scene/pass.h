#pragma once

#include "solver/foundation/quantities.h"

#include <tuple>
#include <type_traits>
#include <utility>

namespace plumbline {

/// A pass is one physical term or one step of a method: `Reads` and `Writes` list the quantities, and
/// `run(dt, const In&..., Out&...) const` computes. What it writes may hold values from before.
namespace detail {
template <class Pass, class Lookup, class... In, class... Out>
void run_pass(const Pass& pass, double dt, const Lookup& at, Quantities<In...>,
              Quantities<Out...>) {
    pass.run(dt, std::as_const(at(std::type_identity<In>{}))..., at(std::type_identity<Out>{})...);
}
}  // namespace detail

/// Runs the passes once each, in order; `at(std::type_identity<Q>{})` finds the array of Q.
template <class Lookup, class... Passes>
void run_passes(const std::tuple<Passes...>& passes, double dt, const Lookup& at) {
    std::apply(
        [&](const Passes&... pass) {
            (detail::run_pass(pass, dt, at, typename Passes::Reads{}, typename Passes::Writes{}),
             ...);
        },
        passes);
}

/// What the passes need from outside of them: read by one, written by none.
template <class... Passes>
using ReadFromOutside =
    Difference<Union<typename Passes::Reads...>, Union<typename Passes::Writes...>>;

/// Finds the arrays of a pass that is made of passes among its own arguments: `Read` come const.
template <class Read, class... Arrays> class Arguments {
public:
    explicit Arguments(Arrays&... arrays) : arrays_{arrays...} {}

    template <class Q> auto& operator()(std::type_identity<Q>) const {
        if constexpr (contains<Read, Q>)
            return std::get<const Q&>(arrays_);
        else
            return std::get<Q&>(arrays_);
    }
    template <class Q> auto& get() const { return (*this)(std::type_identity<Q>{}); }

private:
    std::tuple<Arrays&...> arrays_;
};

}  // namespace plumbline
