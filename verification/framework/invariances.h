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

}  // namespace verification
