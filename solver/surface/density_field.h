#pragma once

#include "solver/kernels/kernel.h"
#include "solver/surface/particle_field.h"

namespace plumbline {

/// ρ_level − Σⱼ mⱼ ω(‖x − xⱼ‖): the surface is where the density of adams2009 Eq. 5 has a level.     Sec. 6.5
/// With half of the density inside it runs through a flat free surface, as far beyond the
/// outermost particles as half of a spacing, for a kernel that is much wider than that.
template <RadialKernel K> struct DensityField {
    static constexpr int dim = K::dim;
    K w;
    std::span<const double> m;  // masses [kg]
    double level;               // [kg/m^dim]

    double reach() const { return w.support(); }
    double far() const { return level; }
    double value(const Vec<dim>& x, std::span<const Vec<dim>> points,
                 std::span<const Index> near) const {
        double rho = 0.0;
        for (const Index j : near) rho += m[j] * w.value((x - points[j]).norm());
        return level - rho;
    }
};

}  // namespace plumbline
