#pragma once

#include "solver/foundation/random.h"
#include "solver/particles/lattice.h"

namespace plumbline {

/// The square (cubic) lattice, each coordinate moved by a random amount, uniform within
/// ± jitter · spacing: still one point per cell of volume spacing^Dim, for no two are closer than
/// (1 − 2 jitter) spacing along some axis. The same points for the same seed.
/// Throws InvalidInput unless 0 ≤ jitter ≤ 1/2, and as `lattice` does.
template <int Dim>
Points<Dim> jittered(const Box<Dim>& box, double spacing, double jitter, std::uint64_t seed) {
    if (!(jitter >= 0.0 && jitter <= 0.5))
        throw InvalidInput("jitter: expected a fraction of the spacing in [0, 0.5], found " +
                           std::to_string(jitter));
    Points<Dim> points = lattice(box, spacing);
    Random random(seed);
    for (Vec<Dim>& x : points)
        for (int d = 0; d < Dim; ++d) {
            x[d] += random.uniform(-jitter, jitter) * spacing;
            if (x[d] < box.low[d]) x[d] = box.low[d];
            if (x[d] >= box.high[d]) x[d] = std::nextafter(box.high[d], box.low[d]);
        }
    return points;
}

}  // namespace plumbline
