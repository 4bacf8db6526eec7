#pragma once

#include "solver/foundation/types.h"

#include <algorithm>

namespace verification {

/// Algorithm 1 to the letter: the median of one axis after the other, those strictly below it to the
/// left. Returns the depth at which it ends, or `guard` if it has not ended there: erratum 27.
template <int Dim>
int depth_of_algorithm_1(plumbline::Points<Dim> points, std::size_t leaf_size, int axis,
                         int guard) {
    using plumbline::Vec;
    if (points.size() <= leaf_size || guard == 0) return 0;
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
    const auto below = [axis](const Vec<Dim>& a, const Vec<Dim>& b) { return a[axis] < b[axis]; };
    std::nth_element(points.begin(), middle, points.end(), below);
    const Vec<Dim> split = *middle;
    const auto end_of_left = std::partition(
        points.begin(), points.end(), [&](const Vec<Dim>& x) { return x[axis] < split[axis]; });
    const int next = (axis + 1) % Dim;
    return 1 +
           std::max(
               depth_of_algorithm_1<Dim>({points.begin(), end_of_left}, leaf_size, next, guard - 1),
               depth_of_algorithm_1<Dim>({end_of_left, points.end()}, leaf_size, next, guard - 1));
}

}  // namespace verification
