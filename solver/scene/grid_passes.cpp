#include "solver/scene/grid_passes.h"

#include "solver/neighbours/cell_grid.h"
#include "solver/scene/find_neighbours.h"

namespace plumbline {

template <int Dim>
void FindInGrid<Dim>::run(double dt, const Positions<Dim>& x, Neighbourhood<Dim>& near) const {
    FindNeighbours<Dim, CellGrid<Dim>>{radius}.run(dt, x, near);
}
template <int Dim>
void FindGhostsInGrid<Dim>::run(double dt, const Positions<Dim>& x,
                                const GhostPositions<Dim>& ghosts,
                                GhostNeighbourhood<Dim>& near) const {
    FindGhosts<Dim, CellGrid<Dim>>{radius}.run(dt, x, ghosts, near);
}

template struct FindInGrid<2>;
template struct FindInGrid<3>;
template struct FindGhostsInGrid<2>;
template struct FindGhostsInGrid<3>;

}  // namespace plumbline
