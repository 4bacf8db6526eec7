#pragma once

#include "solver/particles/halton.h"

namespace plumbline {

/// Halton points, squeezed along x: the number density grows exponentially, n(u) ∝ contrastᵘ at the
/// fraction u of the edge, so at the high end it is `contrast` times that at the low end. A share
/// (contrastᵘ − 1)/(contrast − 1) of the points lies below u.
/// Throws InvalidInput unless contrast is finite and positive, and as `halton` does.
template <int Dim> Points<Dim> graded(const Box<Dim>& box, Index count, double contrast) {
    require_positive(contrast, "contrast");
    Points<Dim> points = halton(unit_box<Dim>(), count);
    require_proper(box);
    for (Vec<Dim>& u : points) {
        if (contrast != 1.0) u[0] = std::log1p(u[0] * (contrast - 1.0)) / std::log(contrast);
        u = box.at(u);
    }
    return points;
}

}  // namespace plumbline
