#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/surface/scalar_grid.h"

namespace plumbline {

/// A field that particles make around them: field.reach() is the distance beyond which a particle has no
/// part in it, field.value(x, points, near) its value at x with the particles nearer than that, and
/// field.far() where there is none. Negative inside, so that the surface is at 0.
template <class Field, int Dim>
concept ParticleField = requires(const Field field, const Vec<Dim>& x,
                                 std::span<const Vec<Dim>> points, std::span<const Index> near) {
    { field.reach() } -> std::same_as<double>;
    { field.value(x, points, near) } -> std::same_as<double>;
    { field.far() } -> std::same_as<double>;
};

/// The field on a grid of spacing `cell` [m] that reaches so far that the surface cannot leave it.
template <int Dim, class Field>
requires ParticleField<Field, Dim> ScalarGrid<Dim> on_grid(const Field& field,
                                                           std::span<const Vec<Dim>> points,
                                                           double cell) {
    ScalarGrid<Dim> grid = grid_around<Dim>(points, field.reach() + cell, cell);
    grid.values.resize(grid.nodes());
    CellGrid<Dim> search;
    search.build(points, field.reach());
    const std::size_t layer = grid.stride(Dim - 1);
    Points<Dim> nodes(layer);
    NeighbourLists near;
    for (std::size_t first = 0; first < grid.nodes(); first += layer) {
        for (std::size_t k = 0; k < layer; ++k) nodes[k] = grid.position(first + k);
        search.query(nodes, near);
        parallel_for(layer, [&](std::size_t k) {
            const auto js = near.of(Index(k));
            grid.values[first + k] = js.empty() ? field.far() : field.value(nodes[k], points, js);
        });
    }
    return grid;
}

}  // namespace plumbline
