#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// FindNeighbours and FindGhosts in open space with a CellGrid, compiled once for all compositions.
template <int Dim> struct FindInGrid {
    using Reads = Quantities<Positions<Dim>>;
    using Writes = Quantities<Neighbourhood<Dim>>;
    double radius;  // [m], the largest support of the kernels
    void run(double, const Positions<Dim>& x, Neighbourhood<Dim>& near) const;
};
template <int Dim> struct FindGhostsInGrid {
    using Reads = Quantities<Positions<Dim>, GhostPositions<Dim>>;
    using Writes = Quantities<GhostNeighbourhood<Dim>>;
    double radius;  // [m]
    void run(double, const Positions<Dim>& x, const GhostPositions<Dim>& ghosts,
             GhostNeighbourhood<Dim>& near) const;
};

}  // namespace plumbline
