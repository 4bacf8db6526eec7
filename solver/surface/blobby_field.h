#pragma once

#include "solver/surface/particle_field.h"

namespace plumbline {

/// k(s) = (1 − s²)³ for s < 1, 0 beyond.                                          Zhu and Bridson 2005
inline double blob(double s) {
    const double t = s < 1.0 ? 1.0 - s * s : 0.0;
    return t * t * t;
}

/// level − Σⱼ k(‖x − xⱼ‖ / R): each particle is a blob, and blobs that are near each other
/// flow together.                                                              adams2009 Sec. 6.5
/// The sphere of a particle alone has the radius R √(1 − level^⅓).
template <int Dim> struct BlobbyField {
    double radius;  // R [m]
    double level;   // 0 < level < 1

    double reach() const { return radius; }
    double far() const { return level; }
    double value(const Vec<Dim>& x, std::span<const Vec<Dim>> points,
                 std::span<const Index> near) const {
        double sum = 0.0;
        for (const Index j : near) sum += blob((x - points[j]).norm() / radius);
        return level - sum;
    }
};

}  // namespace plumbline
