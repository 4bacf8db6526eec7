#pragma once

#include "solver/particles/clustered.h"
#include "solver/particles/graded.h"
#include "solver/particles/lattice.h"
#include "solver/particles/uniform_random.h"

#include <string>
#include <vector>

namespace verification {

/// Points and a radius at which they have some ten neighbours each.
template <int Dim> struct Cloud {
    std::string name;
    plumbline::Points<Dim> points;
    double radius;
};

/// The radius within which a point of an even random cloud has `neighbours` in expectation.
template <int Dim> double radius_for(double neighbours, double points_per_volume) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double ball = Dim == 1 ? 2.0 : Dim == 2 ? pi : 4.0 / 3.0 * pi;
    return std::pow(neighbours / (points_per_volume * ball), 1.0 / Dim);
}

/// Clouds on which searches have been known to fail, of about n points each.
template <int Dim> std::vector<Cloud<Dim>> hard_clouds(plumbline::Index n) {
    using plumbline::Vec;
    const auto box = plumbline::unit_box<Dim>();
    const double r = radius_for<Dim>(20.0, n);
    const plumbline::Points<Dim> even = plumbline::uniform_random(box, n, 1);
    const auto moved = [&](auto move) {
        plumbline::Points<Dim> points = even;
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = move(points[i], i);
        return points;
    };
    const auto on_multiples_of = [&](double step, double cells) {
        return moved([=](const Vec<Dim>& x, std::size_t) -> Vec<Dim> {
            return step * ((x.array() - 0.5) * cells).round().matrix();
        });
    };
    const double cells = std::round(std::pow(n, 1.0 / Dim) / 2.0);
    std::vector<Cloud<Dim>> clouds{
        {"even", even, r},
        {"negative", moved([](const auto& x, auto) { return Vec<Dim>(x.array() - 5.0); }), r},
        {"clustered", plumbline::clustered(box, n, {6, 0.05, 100.0}, 2), 0.3 * r},
        {"graded", plumbline::graded(box, n, 1000.0), 0.5 * r},
        {"coincident in fives", moved([&](const auto&, std::size_t i) { return even[i - i % 5]; }),
         r},
        {"all but a few coincident",
         moved([&](const auto& x, std::size_t i) { return i < 400 ? even[0] : x; }), r},
        {"on faces of cells of the radius", on_multiples_of(0.1, 2.0 * cells), 0.1},
        {"on faces of cells of twice the radius", on_multiples_of(0.1, cells), 0.05},
        {"lattice, ties at the radius", on_multiples_of(0x1p-4, cells), 0x1p-3},
        {"far from the origin",
         moved([r](const auto& x, auto) { return Vec<Dim>(x.array() + 1e9 * r); }), r},
        {"two clouds far apart", moved([r](const auto& x, std::size_t i) {
             return Vec<Dim>(x.array() + (i % 2 == 0 ? -1e9 : 1e9) * r);
         }),
         1.3 * r},
        {"on a line", moved([](const Vec<Dim>& x, auto) {
             return Vec<Dim>(Vec<Dim>::Constant(1.0 / 3.0) * x[0]);
         }),
         3.0 / n},
        {"along the last axis", moved([](const Vec<Dim>& x, auto) {
             Vec<Dim> y = Vec<Dim>::Constant(0.7);
             y[Dim - 1] = x[0];
             return y;
         }),
         5.0 / n},
    };
    if (Dim == 3)
        clouds.push_back({"planar", moved([](Vec<Dim> x, auto) {
                              x[Dim - 1] = 0.3;
                              return x;
                          }),
                          radius_for<2>(20.0, n)});
    return clouds;
}

}  // namespace verification
