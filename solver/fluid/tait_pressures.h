#pragma once

#include "solver/fluid/tait_equation.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// Which of several fluids a particle is of, by number.
struct Fluid : Each<Index> {
    static constexpr std::string_view name = "fluids";
};

/// pᵢ = p(ρᵢ) by the equation of the particle's own fluid.                     adams2009 Eq. 47
/// Throws InvalidInput where there is none for it.
struct TaitPressures {
    using Reads = Quantities<Density, Fluid>;
    using Writes = Quantities<Pressure>;
    std::vector<TaitEquation> equations;

    void run(double, const Density& rho, const Fluid& fluid, Pressure& p) const {
        for (std::size_t i = 0; i < rho.size(); ++i) {
            if (fluid[i] >= equations.size())
                throw InvalidInput("fluids: expected a number below " +
                                   std::to_string(equations.size()) + ", found " +
                                   std::to_string(fluid[i]) + " at particle " + std::to_string(i));
            p[i] = equations[fluid[i]].pressure(rho[i]);
        }
    }
};

}  // namespace plumbline
