#pragma once

#include "verification/approximation/disordered.h"
#include "verification/framework/property.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>

namespace verification {

/// How far positions move by rounding when samples are shifted by up to 10 and scaled by down to 1/8, in
/// units of the support, which is then 0.31: two positions, each off by a few 1.1e-16 · 10.6.
/// An operator Σⱼ g(x − xⱼ) Vⱼ fⱼ of order p changes by that times hᵖ⁺¹ ∫ ‖∇g‖ dV max |f|.
constexpr double position_rounding = 2e-14;

/// x → λ R x + t, and the order in which the samples are stored changed.
template <int Dim> struct Similarity {
    plumbline::Mat<Dim> R;
    plumbline::Vec<Dim> t;
    double scale;
    std::vector<plumbline::Index> order;  // new sample i is the old sample order[i]
};

template <int Dim> plumbline::Mat<Dim> any_rotation() {
    plumbline::Mat<Dim> R = plumbline::Mat<Dim>::Identity();
    if (Dim == 1 && *uniform(-1.0, 1.0) < 0.0) R = -R;  // the line has no rotation but a reflection
    for (int a = 0; a < Dim; ++a)
        for (int b = a + 1; b < Dim; ++b) {
            const double angle = *uniform(0.0, 2.0 * std::numbers::pi);
            plumbline::Mat<Dim> turn = plumbline::Mat<Dim>::Identity();
            turn(a, a) = turn(b, b) = std::cos(angle);
            turn(a, b) = -(turn(b, a) = std::sin(angle));
            R = turn * R;
        }
    return R;
}

/// Scales between 1/8 and 8, shifts up to 10, all rotations, all orders. To be called in a property.
template <int Dim> Similarity<Dim> any_similarity(std::size_t n) {
    Similarity<Dim> s{any_rotation<Dim>(), *point<Dim>(-10.0, 10.0), std::exp2(*uniform(-3.0, 3.0)),
                      std::vector<plumbline::Index>(n)};
    std::iota(s.order.begin(), s.order.end(), plumbline::Index{0});
    plumbline::Random random(static_cast<std::uint64_t>(*uniform(0.0, 1e9)));
    for (std::size_t i = n; i > 1; --i) std::swap(s.order[i - 1], s.order[random.bits() % i]);
    return s;
}

/// Disordered samples with a scalar field f and a vector field u on them, both random.
template <class K> struct Fields : Disordered<K> {
    std::vector<double> f;
    plumbline::Points<K::dim> u;

    explicit Fields(double support, PatchShape shape = {.support = 0, .jitter = 0.3})
        : Disordered<K>(support, shape) {
        plumbline::Random random(shape.seed + 2);
        for (std::size_t i = 0; i < this->size(); ++i) {
            f.push_back(random.uniform(-1.0, 1.0));
            u.push_back(
                plumbline::Vec<K::dim>::NullaryExpr([&] { return random.uniform(-1.0, 1.0); }));
        }
    }

    /// The same matter elsewhere, turned and larger; the same f, and u turned along.
    Fields moved(const Similarity<K::dim>& by) const {
        Fields other = *this;
        const double volume = std::pow(by.scale, K::dim);
        other.w = K(by.scale * this->w.support());
        for (std::size_t i = 0; i < this->size(); ++i) {
            const plumbline::Index k = by.order[i];
            other.patch.x[i] = by.scale * (by.R * this->patch.x[k]) + by.t;
            other.patch.V[i] = volume * this->patch.V[k];
            other.m[i] = this->m[k];
            other.rho[i] = this->rho[k] / volume;
            other.f[i] = f[k];
            other.u[i] = by.R * u[k];
            if (k == this->patch.centre) other.patch.centre = static_cast<plumbline::Index>(i);
        }
        other.patch.neighbours = reordered(by.order);
        return other;
    }

private:
    plumbline::NeighbourLists reordered(const std::vector<plumbline::Index>& order) const {
        std::vector<plumbline::Index> new_of(order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            new_of[order[i]] = static_cast<plumbline::Index>(i);
        plumbline::NeighbourLists lists{{0}, {}};
        for (const plumbline::Index k : order) {
            for (const plumbline::Index j : this->patch.neighbours.of(k))
                lists.indices.push_back(new_of[j]);
            std::sort(lists.indices.begin() + static_cast<std::ptrdiff_t>(lists.offsets.back()),
                      lists.indices.end());
            lists.offsets.push_back(lists.indices.size());
        }
        return lists;
    }
};

/// The order in the spacing of an error that lengths alone decide, h/spacing fixed: log₂ of what it is,
/// over what it is when all lengths are halved. `error(fields)`.
template <class K, class Error>
double order_under_refinement(double support, double jitter, Error error) {
    const Fields<K> coarse(support, {.support = 0, .jitter = jitter});
    Similarity<K::dim> halving{plumbline::Mat<K::dim>::Identity(), plumbline::Vec<K::dim>::Zero(),
                               0.5, std::vector<plumbline::Index>(coarse.size())};
    std::iota(halving.order.begin(), halving.order.end(), plumbline::Index{0});
    return std::log2(error(coarse) / error(coarse.moved(halving)));
}

inline double turned(const auto&, double value) { return value; }
template <int Dim>
plumbline::Vec<Dim> turned(const Similarity<Dim>& by, const plumbline::Vec<Dim>& v) {
    return by.R * v;
}
inline double size_of(double value) { return std::abs(value); }
inline double size_of(const auto& v) { return v.norm(); }

/// max ‖λ^power op(moved) − R op(here)‖ over 40 similarities, at the centre, in units of h^-power.
/// `op(fields, i)` gives a number or a vector of unit [m^-power].
template <class K, class Op> double change_under_similarity(double support, int power, Op op) {
    const Fields<K> here(support);
    const auto value = op(here, here.patch.centre);
    return worst_error(
        [&] {
            const auto by = any_similarity<K::dim>(here.size());
            const Fields<K> there = here.moved(by);
            const auto expected = turned(by, value);
            const auto found = op(there, there.patch.centre);
            return size_of(decltype(value)(std::pow(by.scale, power) * found - expected)) *
                   std::pow(support, power);
        },
        {.number = 40});
}

}  // namespace verification
