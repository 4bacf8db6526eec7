#pragma once

#include "solver/scene/pass.h"

#include <utility>
#include <variant>

namespace plumbline {

/// The pass that does nothing.
struct Skip {
    using Reads = Quantities<>;
    using Writes = Quantities<>;
    void run(double) const {}
};

/// One of several passes, chosen when the scene is made: a scene file selects here. The choice costs one
/// branch per step, none per particle; what any of them writes is stored.
template <class... Passes> class OneOf {
public:
    using Writes = Union<typename Passes::Writes...>;
    using Reads = Difference<Union<typename Passes::Reads...>, Writes>;

    template <class Pass> OneOf(Pass pass) : chosen_{std::move(pass)} {}  // NOLINT: as a variant

    template <class... Arrays> void run(double dt, Arrays&... arrays) const {
        const Arguments<Reads, Arrays...> at(arrays...);
        std::visit(
            [&]<class Pass>(const Pass& pass) {
                detail::run_pass(pass, dt, at, typename Pass::Reads{}, typename Pass::Writes{});
            },
            chosen_);
    }

private:
    std::variant<Passes...> chosen_;
};

}  // namespace plumbline
