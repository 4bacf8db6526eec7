#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/sum.h"
#include "solver/particles/quantities.h"
#include "solver/scene/pass.h"

#include <optional>
#include <span>
#include <string>

namespace plumbline {

/// What a scene starts with: fill it through scene.get<...>(). The first quantity of a set says how
/// many members the set has.
template <class... Initial> struct Given {
    using Reads = Quantities<>;
    using Writes = Quantities<Initial...>;
    void run(double, Initial&...) const {}
};

namespace detail {
template <class List> struct Storage;
template <class... Qs> struct Storage<Quantities<Qs...>> { using type = std::tuple<Qs...>; };

template <class Pass> struct GivenBy { using type = Quantities<>; };
template <class... Qs> struct GivenBy<Given<Qs...>> { using type = Quantities<Qs...>; };

template <class Q>
concept OnePerMember = requires {
    typename Q::set;
};
}  // namespace detail

/// An ordered list of passes; step() runs them once, in that order. Storage is the union of what the
/// passes write: physics that a scene does not name costs neither time nor memory, and a pass whose
/// input nobody writes does not compile.
template <class... Passes> class Scene {
public:
    using Stored = Union<typename Passes::Writes...>;
    template <class Q> static constexpr bool stores = contains<Stored, Q>;

    explicit Scene(Passes... passes) : passes_{std::move(passes)...} {
        check(Union<typename Passes::Reads...>{});
    }

    template <class Q> Q& get() { return std::get<Q>(store_); }
    template <class Q> const Q& get() const { return std::get<Q>(store_); }

    /// Advances by dt [s]; with dt = 0 everything is computed and nothing moves.
    /// Throws InvalidInput for a negative or infinite dt, and where given quantities of one set have
    /// different lengths.
    void step(double dt) {
        if (!(dt >= 0.0 && dt < HUGE_VAL))
            throw InvalidInput(
                "scene: expected a time step that is finite and not negative, found " +
                std::to_string(dt));
        fit(Stored{});
        run_passes(passes_, dt, [&]<class Q>(std::type_identity<Q>) -> Q& { return get<Q>(); });
    }

    /// Puts the particles into another order: member k of each of their quantities is the one that was
    /// member order[k]. Those that `order` does not name are gone. Neighbourhoods still have the old numbers,
    /// until they are found anew.
    void reorder(std::span<const Index> order) {
        const std::size_t n = count<Particles>(GivenQuantities{}).value_or(order.size());
        const auto put = [&]<class Q>(Q& q) {
            if constexpr (detail::OnePerMember<Q>)
                if constexpr (std::is_same_v<typename Q::set, Particles>)
                    if (q.size() == n) permute(q, order);
        };
        std::apply([&](auto&... q) { (put(q), ...); }, store_);
    }

private:
    using GivenQuantities = Union<typename detail::GivenBy<Passes>::type...>;

    template <class Q> static void permute(Q& q, std::span<const Index> order) {
        std::vector<typename Q::value_type> permuted(order.size());
        parallel_for_parts(order.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) permuted[k] = q[order[k]];
        });
        q.swap(permuted);
    }

    template <class... In> static constexpr void check(Quantities<In...>) {
        static_assert((stores<In> && ...),
                      "this pass reads a quantity that no pass of the scene writes");
    }

    /// How many members the set has, if it is given.
    template <class Set, class... Qs> std::optional<std::size_t> count(Quantities<Qs...>) const {
        std::optional<std::size_t> n;
        [[maybe_unused]] const auto look_at = [&]<class Q>(const Q& q) {
            if constexpr (std::is_same_v<typename Q::set, Set>)
                if (!n) n = q.size();
        };
        (look_at(get<Qs>()), ...);
        return n;
    }
    template <class... Qs> void fit(Quantities<Qs...>) { (fit_one(get<Qs>()), ...); }
    template <class Q> void fit_one(Q& q) const {
        if constexpr (detail::OnePerMember<Q>) {
            const auto n = count<typename Q::set>(GivenQuantities{});
            if (!n || q.size() == *n) return;
            if (contains<GivenQuantities, Q>)
                throw InvalidInput(
                    "scene: expected " + std::to_string(*n) + " " + std::string(Q::name) +
                    ", as of the first quantity given, found " + std::to_string(q.size()));
            q.resize(*n, zero<typename Q::value_type>());
        }
    }

    typename detail::Storage<Stored>::type store_;
    std::tuple<Passes...> passes_;
};

}  // namespace plumbline
