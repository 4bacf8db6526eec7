#pragma once

#include "solver/particles/lattice.h"
#include "solver/surface/isosurface.h"
#include "solver/surface/particle_field.h"

namespace verification {

/// Largest |distance from the particle − radius| of the surface around a particle alone [m].
template <int Dim, class Field>
double error_around_one(const Field& field, double radius, double cell) {
    using namespace plumbline;
    Points<Dim> x(1);
    for (int d = 0; d < Dim; ++d) x[0][d] = 0.3 + 0.01 * d;
    const auto s = isosurface(on_grid<Dim>(field, std::span<const Vec<Dim>>(x), cell), 0.0);
    double worst = s.vertices.empty() ? HUGE_VAL : 0.0;
    for (const Vec<Dim>& v : s.vertices)
        worst = std::max(worst, std::abs((v - x[0]).norm() - radius));
    return worst;
}

/// A block of 12 particles of spacing 1 along each axis, its outermost ones 0.5 below the plane 0 of the
/// last axis. Lowest and highest point of its surface above the middle of that plane.
struct Level {
    double low = HUGE_VAL, high = -HUGE_VAL;
};
template <int Dim, class MakeField> Level level_above_block(MakeField make, double cell) {
    using namespace plumbline;
    Vec<Dim> low = Vec<Dim>::Constant(-6.0), high = Vec<Dim>::Constant(6.0);
    low[Dim - 1] = -12.0, high[Dim - 1] = 0.0;
    const Points<Dim> x = lattice<Dim>({low, high}, 1.0);
    const std::vector<double> m(x.size(), 1.0);
    const auto s = isosurface(
        on_grid<Dim>(make(std::span<const double>(m)), std::span<const Vec<Dim>>(x), cell), 0.0);
    Level level;
    for (const Vec<Dim>& v : s.vertices) {
        if (v[Dim - 1] < -3.0 || v.template head<Dim - 1>().cwiseAbs().maxCoeff() > 1.5) continue;
        level.low = std::min(level.low, v[Dim - 1]), level.high = std::max(level.high, v[Dim - 1]);
    }
    return level;
}

}  // namespace verification
