#pragma once

#include "solver/particles/box.h"

#include <algorithm>
#include <initializer_list>

namespace verification {

/// Neighbours at one distance from a site of a lattice.
struct Shell {
    double radius;  // in units of the nearest distance of the lattice
    int count;
};

/// The point nearest to the middle of the box, whose neighbourhood the faces do not cut.
template <int Dim>
plumbline::Vec<Dim> middle_point(const plumbline::Points<Dim>& points,
                                 const plumbline::Box<Dim>& box) {
    const plumbline::Vec<Dim> middle = 0.5 * (box.low + box.high);
    return *std::ranges::min_element(points, {},
                                     [&](const auto& x) { return (x - middle).squaredNorm(); });
}

/// How many neighbours of the middle point are wrong: Σ |found − expected| over the shells, each
/// 1e-9 thick, plus those found between them, up to the outermost.
template <int Dim>
double misplaced_neighbours(const plumbline::Points<Dim>& points, const plumbline::Box<Dim>& box,
                            double nearest, std::initializer_list<Shell> shells) {
    const plumbline::Vec<Dim> centre = middle_point(points, box);
    const auto count_up_to = [&](double radius) {
        return std::ranges::count_if(
            points, [&](const auto& x) { return (x - centre).norm() < radius * nearest; });
    };
    auto seen = count_up_to(1e-9), wrong = std::abs(seen - 1);
    for (const Shell& shell : shells) {
        const auto before = count_up_to(shell.radius * (1 - 1e-9));
        const auto up_to = count_up_to(shell.radius * (1 + 1e-9));
        wrong += before - seen + std::abs(up_to - before - shell.count);
        seen = up_to;
    }
    return static_cast<double>(wrong);
}

/// |n v / V − 1| of n points with the volume v each in a box of volume V.
template <int Dim>
double volume_error(const plumbline::Points<Dim>& points, const plumbline::Box<Dim>& box,
                    double volume_per_point) {
    return std::abs(static_cast<double>(points.size()) * volume_per_point / box.volume() - 1.0);
}

}  // namespace verification
