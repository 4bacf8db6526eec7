#pragma once

#include "solver/particles/jittered.h"

namespace benchmarks {

/// A still of a dam break: water on a lattice with 20 % jitter under the free surface that Ritter's
/// solution of the shallow-water equations has at t = 0.3 s, and one layer of particles on the floor
/// and the walls of the open tank. The column was 2 m long, 1 m high and, in 3D, 0.5 m wide, the tank is
/// 5.366 m long and 2 m high; y is up in 2D, z in 3D. It has the shape and the emptiness of a dam break,
/// not the disorder of a simulated one: no particle was moved by a solver.
/// Surface height: H behind the wave, (2c − (x − L)/t)² / (9g) in it, 0 ahead, c = √(gH).  Ritter 1892
/// About `count` points. Throws InvalidInput as `lattice` does.
template <int Dim> plumbline::Points<Dim> dam_break(plumbline::Index count, std::uint64_t seed) {
    using namespace plumbline;
    constexpr double length = 2.0, height = 1.0, width = 0.5;
    constexpr double tank_length = 5.366, tank_height = 2.0, time = 0.3, gravity = 9.81;
    constexpr int up = Dim - 1;
    const double c = std::sqrt(gravity * height);
    const auto surface = [&](double x) {
        const double s = 2.0 * c - (x - length) / time;
        return s >= 3.0 * c ? height : s <= 0.0 ? 0.0 : s * s / (9.0 * gravity);
    };
    Vec<Dim> corner = Vec<Dim>::Constant(width);
    corner[0] = tank_length;
    corner[up] = tank_height;
    const auto points_at = [&](double spacing) {
        Points<Dim> points;
        for (const Vec<Dim>& x : jittered(Box<Dim>{Vec<Dim>::Zero(), corner}, spacing, 0.2, seed))
            if (x[up] < surface(x[0])) points.push_back(x);
        // The walls stand half a spacing outside, so that water and wall are one lattice.
        const Vec<Dim> margin = Vec<Dim>::Constant(spacing);
        for (const Vec<Dim>& x : lattice(Box<Dim>{-margin, corner + 2.0 * margin}, spacing)) {
            bool is_wall = x[up]<0.0, is_beyond = x[up]> corner[up];
            for (int axis = 0; axis < up; ++axis) {
                is_wall = is_wall || x[axis] < 0.0 || x[axis] > corner[axis];
                is_beyond = is_beyond || x[axis] > corner[axis] + spacing;
            }
            if (is_wall && !is_beyond) points.push_back(x);
        }
        return points;
    };
    // Water alone, whose volume is that of the column, would need this spacing; with the walls, wider.
    const double water = Dim == 2 ? length * height : length * height * width;
    double spacing = std::min(std::pow(water / count, 1.0 / Dim), 0.5 * width);
    Points<Dim> points = points_at(spacing);
    for (int correction = 0; correction < 3; ++correction) {
        spacing *= std::pow(static_cast<double>(points.size()) / count, 1.0 / Dim);
        spacing = std::min(spacing, 0.5 * width);
        points = points_at(spacing);
    }
    return points;
}

}  // namespace benchmarks
