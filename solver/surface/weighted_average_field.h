#pragma once

#include "solver/surface/blobby_field.h"

namespace plumbline {

/// ‖x − x̄‖ − r with x̄ = Σⱼ kⱼ xⱼ / Σⱼ kⱼ, kⱼ = k(‖x − xⱼ‖ / R)                  Zhu and Bridson 2005; adams2009 Sec. 6.5
/// The distance from the mean of the particles around: exact for one particle alone, and flat where they are in
/// a plane. Without particles around it is what it tends to at their reach, R − r. In hollows, where the mean lies
/// outside of the fluid, it has surfaces that are not there.
template <int Dim> struct WeightedAverageField {
    double radius;  // R [m], two to four spacings
    double
        distance;  // r [m], from the outermost particles to the surface: half of a spacing to one

    double reach() const { return radius; }
    double far() const { return radius - distance; }
    double value(const Vec<Dim>& x, std::span<const Vec<Dim>> points,
                 std::span<const Index> near) const {
        double sum = 0.0;
        Vec<Dim> mean = Vec<Dim>::Zero();
        for (const Index j : near) {
            const double k = blob((x - points[j]).norm() / radius);
            sum += k;
            mean += k * (points[j] - x);
        }
        return sum > 0.0 ? mean.norm() / sum - distance : far();
    }
};

}  // namespace plumbline
