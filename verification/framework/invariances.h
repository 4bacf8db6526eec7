#pragma once

#include "verification/framework/disordered.h"
#include "verification/framework/property.h"

#include <cmath>
#include <concepts>
#include <functional>
#include <vector>

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

/// Scales between 1/8 and 8, shifts up to 10, all rotations, all orders. To be called in a property.
template <int Dim> Similarity<Dim> any_similarity(std::size_t n);

/// Disordered samples with a scalar field f and a vector field u on them, both random.
template <int Dim> struct Fields : Disordered<Dim> {
    std::vector<double> f;
    plumbline::Points<Dim> u;

    explicit Fields(double support, PatchShape shape = {.support = 0, .jitter = 0.3});
    /// The same matter elsewhere, turned and larger; the same f, and u turned along.
    Fields moved(const Similarity<Dim>& by) const;
};

/// Fields with 2.5 spacings per support, always the same.
template <int Dim> const Fields<Dim>& disordered();

/// max ‖form(fields, f, i)‖ hᵖ / |f| over the samples of disordered() for constant f; the form gives a
/// gradient (p = 1) or a Laplacian (p = 2).
template <int Dim, class Form> double of_a_constant(Form form) {
    const auto& d = disordered<Dim>();
    const std::vector<double> f(d.size(), 7.0);
    double worst = 0.0;
    for (plumbline::Index i = 0; i < d.size(); ++i) {
        const double h = d.w.support();
        const auto operated = form(d, f, i);
        if constexpr (std::floating_point<std::remove_cvref_t<decltype(operated)>>)
            worst = std::max(worst, std::abs(operated) * h * h / 7.0);
        else
            worst = std::max(worst, operated.norm() * h / 7.0);
    }
    return worst;
}

/// The order in the spacing of an error that lengths alone decide, h/spacing fixed: log₂ of what it is,
/// over what it is when all lengths are halved.
template <int Dim>
double order_under_refinement(double support, double jitter,
                              const std::function<double(const Fields<Dim>&)>& error);

/// max ‖λ^power op(moved) − R op(here)‖ over 40 similarities, at the centre, in units of h^-power.
/// `op(fields, i)` gives a number or a vector of unit [m^-power].
template <int Dim>
double change_under_similarity(
    double support, int power,
    const std::function<double(const Fields<Dim>&, plumbline::Index)>& op);
template <int Dim>
double change_under_similarity(
    double support, int power,
    const std::function<plumbline::Vec<Dim>(const Fields<Dim>&, plumbline::Index)>& op);

/// That of a gradient form(fields, f, i); wrong on purpose if it is not turned along, but its components
/// taken without their signs.
template <int Dim, class Form> double change_of_gradient(Form form, bool turn) {
    return change_under_similarity<Dim>(2.5, 1, [=](const auto& d, plumbline::Index i) {
        const plumbline::Vec<Dim> g = form(d, d.f, i);
        return turn ? g : plumbline::Vec<Dim>(g.cwiseAbs());
    });
}

}  // namespace verification
