#pragma once

#include "solver/fluid/sph_density.h"
#include "solver/foundation/random.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/brute_force.h"
#include "solver/particles/jittered.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "solver/scene/symplectic_euler.h"

#include <Eigen/Geometry>  // cross products

namespace verification {
namespace pl = plumbline;

/// A free drop of irregular particles of unequal masses and random velocities; 1 is the spacing.
template <int Dim> struct Drop {
    static constexpr double support = 2.6;  // of the kernel, in spacings
    pl::Points<Dim> x, v;
    std::vector<double> m;

    explicit Drop(double radius = Dim == 2 ? 4.0 : 2.6, std::uint64_t seed = 1) {
        const auto around = pl::Vec<Dim>::Constant(std::ceil(radius) + 0.5);
        pl::Random random(seed);
        const auto vector = [&] {
            return pl::Vec<Dim>::NullaryExpr([&] { return random.uniform(-1.0, 1.0); });
        };
        for (const auto& p : pl::jittered<Dim>({-around, around}, 1.0, 0.3, seed)) {
            if (p.norm() > radius) continue;
            x.push_back(p);
            v.push_back(vector());
            m.push_back(random.uniform(0.5, 1.5));
        }
    }
};

template <int Dim>
using StartOfDrop = pl::Given<pl::Positions<Dim>, pl::Velocities<Dim>, pl::Masses>;

template <int Dim, class Scene> void fill(Scene& scene, const Drop<Dim>& drop) {
    scene.template get<pl::Positions<Dim>>().assign(drop.x.begin(), drop.x.end());
    scene.template get<pl::Velocities<Dim>>().assign(drop.v.begin(), drop.v.end());
    scene.template get<pl::Masses>().assign(drop.m.begin(), drop.m.end());
}

/// The drop with neighbours, density and `passes`, before its first step.
template <int Dim, class... Passes> auto scene_of(const Drop<Dim>& drop, Passes... passes) {
    const double h = Drop<Dim>::support;
    pl::Scene scene{StartOfDrop<Dim>{}, pl::FindNeighbours<Dim, pl::BruteForce<Dim>>{h},
                    pl::SphDensity<pl::WendlandC2<Dim>>{pl::WendlandC2<Dim>(h)}, passes...};
    fill(scene, drop);
    return scene;
}

/// The same after one evaluation: nothing has moved.
template <int Dim, class... Passes> auto evaluated(const Drop<Dim>& drop, Passes... passes) {
    auto scene = scene_of(drop, passes...);
    scene.step(0.0);
    return scene;
}

template <int Dim> pl::Vec<3> in_space(const pl::Vec<Dim>& x) {
    pl::Vec<3> y = pl::Vec<3>::Zero();
    y.template head<Dim>() = x;
    return y;
}
template <int Dim> pl::Vec<3> cross(const pl::Vec<Dim>& a, const pl::Vec<Dim>& b) {
    return in_space<Dim>(a).cross(in_space<Dim>(b));
}

/// ‖Σ mᵢ aᵢ‖ / Σ mᵢ ‖aᵢ‖: 0 if forces come in opposite pairs.
template <int Dim, class Scene> double net_force(const Scene& scene) {
    const auto& m = scene.template get<pl::Masses>();
    const auto& a = scene.template get<pl::Accelerations<Dim>>();
    pl::Vec<Dim> total = pl::Vec<Dim>::Zero();
    double size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) total += m[i] * a[i], size += m[i] * a[i].norm();
    return total.norm() / size;
}
/// ‖Σ xᵢ × mᵢ aᵢ‖ / Σ ‖xᵢ‖ mᵢ ‖aᵢ‖: 0 if, besides, they act along the lines between the particles.
template <int Dim, class Scene> double net_torque(const Scene& scene) {
    const auto& x = scene.template get<pl::Positions<Dim>>();
    const auto& m = scene.template get<pl::Masses>();
    const auto& a = scene.template get<pl::Accelerations<Dim>>();
    pl::Vec<3> total = pl::Vec<3>::Zero();
    double size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        total += m[i] * cross<Dim>(x[i], a[i]);
        size += m[i] * x[i].norm() * a[i].norm();
    }
    return total.norm() / size;
}
/// Σ mᵢ aᵢ·vᵢ / Σ mᵢ ‖aᵢ‖ ‖vᵢ‖: the power of the forces; negative if they brake.
template <int Dim, class Scene> double power(const Scene& scene) {
    const auto& v = scene.template get<pl::Velocities<Dim>>();
    const auto& m = scene.template get<pl::Masses>();
    const auto& a = scene.template get<pl::Accelerations<Dim>>();
    double total = 0.0, size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        total += m[i] * a[i].dot(v[i]);
        size += m[i] * a[i].norm() * v[i].norm();
    }
    return total / size;
}
/// max ‖aᵢ − bᵢ‖ / max ‖bᵢ‖.
template <int Dim>
double largest_difference(const std::vector<pl::Vec<Dim>>& a, const std::vector<pl::Vec<Dim>>& b) {
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference = std::max(difference, (a[i] - b[i]).norm());
        size = std::max(size, b[i].norm());
    }
    return difference / size;
}

/// ‖P(n) − P(0)‖ / Σ mᵢ ‖vᵢ‖ after n steps, P = Σ mᵢ vᵢ, and the same of L = Σ mᵢ xᵢ × vᵢ.
struct Drift {
    double linear, angular;
};
template <int Dim, class Scene> Drift drift(Scene scene, int steps, double dt) {
    const auto momenta = [&] {
        const auto& x = scene.template get<pl::Positions<Dim>>();
        const auto& v = scene.template get<pl::Velocities<Dim>>();
        const auto& m = scene.template get<pl::Masses>();
        pl::Vec<Dim> P = pl::Vec<Dim>::Zero();
        pl::Vec<3> L = pl::Vec<3>::Zero();
        double p = 0.0, l = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            P += m[i] * v[i], p += m[i] * v[i].norm();
            L += m[i] * cross<Dim>(x[i], v[i]), l += m[i] * x[i].norm() * v[i].norm();
        }
        return std::tuple{P, L, p, l};
    };
    const auto [P, L, p, l] = momenta();
    for (int n = 0; n < steps; ++n) scene.step(dt);
    const auto [P_end, L_end, p_end, l_end] = momenta();
    return {(P_end - P).norm() / std::max(p, p_end), (L_end - L).norm() / std::max(l, l_end)};
}

inline constexpr const char* sums_of_pairs =
    "at most 70 terms per particle, summed one by one: 70 · 1.1e-16, times Σ |terms| / |sum|, "
    "which "
    "is below 10 in this drop";
inline constexpr double rounding_of_pairs = 1e-13;

}  // namespace verification
