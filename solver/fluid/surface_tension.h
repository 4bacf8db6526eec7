#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// 1 for the fluid whose surface has a tension, 0 for the one around it.
struct Colour : Each<double> {
    static constexpr std::string_view name = "colours";
};

/// aᵢ += −σ/ρᵢ (Δc)ᵢ nᵢ/‖nᵢ‖ where ‖nᵢ‖ > ε/h, nᵢ = (∇c)ᵢ                      Müller et al. 2003, Eqs. 17–20
/// with c the colour, in the difference forms (∇c)ᵢ = Σⱼ mⱼ/ρⱼ (cⱼ − cᵢ) ∇ᵢωᵢⱼ and, for the Laplacian of the kernel,
/// −2 ω′/r: the pressure jumps by σ (dim − 1)/R across a surface of radius R, to (h/R)². That needs fluid on both
/// sides: at a free surface, where all colours are 1, this term is 0. Linear momentum is not conserved exactly,
/// nor is angular.
template <RadialKernel K, class Space = OpenSpace<K::dim>> struct SurfaceTension {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Density, Colour, Neighbourhood<dim, Space>>;
    using Writes = Quantities<Accelerations<dim>>;
    K w;
    double sigma;           // σ [N/m], in the plane [N]
    double epsilon = 0.01;  // ε: directions of smaller normals are noise

    void run(double, const Positions<dim>& x, const Masses& m, const Density& rho, const Colour& c,
             const Neighbourhood<dim, Space>& near, Accelerations<dim>& a) const {
        parallel_for(x.size(), [&](std::size_t i) {
            double laplacian = 0.0;
            const Vec<dim> normal =
                near.template sum<Vec<dim>>(x, Index(i), [&](const auto& n) -> Vec<dim> {
                    const double jump = m[n.j] / rho[n.j] * (c[n.j] - c[i]);
                    if (n.r == 0.0 || jump == 0.0) return Vec<dim>::Zero();
                    laplacian += jump * (-2.0 * w.derivative(n.r) / n.r);
                    return jump * gradient(w, n);
                });
            const double length = normal.norm();
            if (length * w.support() > epsilon)
                a[i] -= sigma / rho[i] * laplacian / length * normal;
        });
    }
};

}  // namespace plumbline
