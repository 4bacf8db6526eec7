#pragma once

#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// Which particles are of a wall, 1, and which of the fluid, 0.
struct IsWall : Each<char> {
    static constexpr std::string_view name = "marks of walls";
};

/// Walls of particles like those of the fluid, that do not move: fluid that comes near raises their density
/// by Continuity, and so their pressure.        Dalrymple and Knio 2001; Crespo et al. 2007
/// Sets dv/dt = 0 for them, and keeps their density from falling below ρ₀, so that walls do not
/// pull. The last of the passes that add to rates. One layer is enough to hold a fluid, at a distance of about
/// the support.
template <int Dim> struct HoldWalls {
    using Reads = Quantities<IsWall, Density>;
    using Writes = Quantities<Accelerations<Dim>, Rate<Density>>;
    double rest_density;  // ρ₀ [kg/m^Dim]

    void run(double, const IsWall& wall, const Density& rho, Accelerations<Dim>& a,
             Rate<Density>& rate) const {
        parallel_for_parts(wall.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                if (wall[i] == 0) continue;
                a[i].setZero();
                if (rho[i] <= rest_density) rate[i] = std::max(rate[i], 0.0);
            }
        });
    }
};

}  // namespace plumbline
