#pragma once

#include "solver/fluid/gravity.h"
#include "solver/fluid/pressure_force.h"
#include "solver/fluid/sph_density.h"
#include "solver/fluid/tait_equation.h"
#include "solver/fluid/tension.h"
#include "solver/fluid/xsph.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"

namespace plumbline {

/// The parameters of adams2009 Algorithm 5, and the external force that it leaves out.
template <int Dim> struct SphParameters {
    TaitEquation equation;  // K, γ, ρ₀
    double zeta;            // scaling of negative pressures, 0 ≤ ζ ≤ 1
    XsphStrength xsph;      // ξ
    Vec<Dim> gravity;       // [m/s²]
};

/// adams2009 Algorithm 5: neighbours, density (Eq. 5), pressure (Eqs. 47, 54), forces (Eq. 51), artificial
/// viscosity (Eq. 53), velocities and positions (Eqs. 58, 59), in this order; with the corrections
/// of errata 16 (all neighbours), 20 (uniform motion is left alone) and 31 (gravity).
template <RadialKernel K> auto algorithm_5(const K& w, const SphParameters<K::dim>& parameters) {
    constexpr int dim = K::dim;
    return Scene{Given<Positions<dim>, Velocities<dim>, Masses>{},
                 FindNeighbours<dim, CellGrid<dim>>{w.support()},
                 SphDensity<K>{w},
                 TaitPressure{parameters.equation},
                 ScaleTension{parameters.zeta},
                 PressureForce<K>{w},
                 AverageVelocities<K>{w},
                 XsphVelocities<dim>{parameters.xsph},
                 Gravity<dim>{parameters.gravity},
                 SymplecticEuler<dim>{}};
}

}  // namespace plumbline
