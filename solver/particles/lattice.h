#pragma once

#include "solver/particles/box.h"

#include <array>

namespace plumbline {

/// How many whole cells of length `spacing` [m] fit into `length` [m]; what rounding took from a
/// length that is a multiple of the spacing, 1 part in 10⁹ at most, is given back.
inline double whole_cells(double length, double spacing) {
    return std::floor(length / spacing * (1.0 + 1e-9));
}

/// The centres of the cells with edges `step` [m] that tile `box` from its low corner, those for
/// which keep(k), with k the whole numbers of the cell, is true; x varies fastest. Cells that the
/// high faces cut are left out.
/// Throws InvalidInput for a box or a step without extent, a box smaller than one cell, or too many
/// cells for an Index.
template <int Dim, class Keep>
Points<Dim> cell_centres(const Box<Dim>& box, const Vec<Dim>& step, Keep keep) {
    require_proper(box);
    std::array<std::int64_t, Dim> n;
    double cells = 1.0;
    for (int d = 0; d < Dim; ++d) {
        require_positive(step[d], "spacing");
        const double along = whole_cells(box.size()[d], step[d]);
        if (along < 1.0)
            throw InvalidInput("spacing: expected cells that fit into the box, found " +
                               std::to_string(step[d]) + " in " + std::to_string(box.size()[d]));
        cells *= along;
        require_count(cells);
        n[d] = static_cast<std::int64_t>(along);
    }
    Points<Dim> points;
    std::array<std::int64_t, Dim> k{};
    for (auto cell = require_count(cells); cell > 0; --cell) {
        if (keep(k)) {
            Vec<Dim> x;
            for (int d = 0; d < Dim; ++d)
                x[d] = box.low[d] + (static_cast<double>(k[d]) + 0.5) * step[d];
            points.push_back(x);
        }
        for (int d = 0; d < Dim && ++k[d] == n[d]; ++d) k[d] = 0;
    }
    return points;
}

/// The square (cubic) lattice: one point in the middle of each cell of volume spacing^Dim. In the
/// interior 2·Dim nearest neighbours at `spacing` [m].
/// Throws as cell_centres does.
template <int Dim> Points<Dim> lattice(const Box<Dim>& box, double spacing) {
    return cell_centres<Dim>(box, Vec<Dim>::Constant(spacing), [](const auto&) { return true; });
}

}  // namespace plumbline
