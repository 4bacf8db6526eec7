#pragma once

#include "solver/neighbours/cell_order.h"
#include "solver/scene/scene.h"

namespace plumbline {

/// Sorts the particles of a scene by cells as wide as `width` [m], the support as a rule: particles near in
/// space are then near in memory, which sums over neighbours are faster for by a factor of their own. Worth it
/// every 50 steps or so. Results do not change but for the order in which sums are added; who must know
/// particles again gives them a quantity to carry.
template <int Dim, class Scene> void sort_particles(Scene& scene, double width) {
    const std::span<const Vec<Dim>> x = scene.template get<Positions<Dim>>();
    CellOrder<Dim> cells;
    cells.sort(CellFrame<Dim>::around(x, width), x);
    scene.reorder({cells.order(), x.size()});
}

}  // namespace plumbline
