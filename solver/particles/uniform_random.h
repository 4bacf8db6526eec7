#pragma once

#include "solver/foundation/random.h"
#include "solver/particles/box.h"

namespace plumbline {

/// A random point, every place in the box alike.
template <int Dim> Vec<Dim> random_point(const Box<Dim>& box, Random& random) {
    Vec<Dim> u;
    for (int d = 0; d < Dim; ++d) u[d] = random.uniform();
    return box.at(u);
}

/// `count` independent points, each uniform in the box; they clump: the number in a part of volume
/// fraction p varies by √(n p (1 − p)). The same points for the same seed.
/// Throws InvalidInput for a box without extent or no points.
template <int Dim>
Points<Dim> uniform_random(const Box<Dim>& box, Index count, std::uint64_t seed) {
    require_proper(box);
    require_count(count);
    Points<Dim> points(count);
    Random random(seed);
    for (Vec<Dim>& x : points) x = random_point(box, random);
    return points;
}

}  // namespace plumbline
