#include "solver/kernels/kernel.h"

#include "solver/kernels/all_kernels.h"
#include "verification/framework/property.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

#include <rapidcheck.h>

#include <Eigen/Geometry>

namespace kernel_concept_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Calls judge(kernel) with every kernel of every dimension.
template <class Judge> void for_every_kernel(double support, Judge judge) {
    AllKernels::for_each<1>(support, judge);
    AllKernels::for_each<2>(support, judge);
    AllKernels::for_each<3>(support, judge);
}
template <class K> constexpr bool singular_centre = K::name == "singular" || K::name == "viscosity";
template <class K> constexpr bool kink_at_centre = K::name == "spiky" || singular_centre<K>;

/// ω(λr; λh) = λ^−dim ω(r; h), bit for bit where λ is a power of two.
double scale_invariance(int lost_powers) {
    return counterexamples([lost_powers] {
        const double h = uniform(0.1, 10.0), q = uniform(0.0, 1.2);
        const double lambda = std::exp2(*rc::gen::inRange(-20, 21));
        for_every_kernel(h, [&]<class K>(const K& w) {
            const K scaled(lambda * h);
            const double power = std::pow(lambda, K::dim - lost_powers), r = q * h;
            RC_ASSERT(scaled.value(lambda * r) * power == w.value(r));
            RC_ASSERT(scaled.derivative(lambda * r) * power * lambda == w.derivative(r));
        });
    });
}

/// ∇ω(−x) = −∇ω(x), bit for bit: the forces of a pair cancel exactly.
template <class Gradient> double antisymmetry(Gradient gradient) {
    return counterexamples([gradient] {
        const double h = uniform(0.1, 10.0);
        const Vec<3> at = point<3>(-1.0, 1.0) * h;
        for_every_kernel(h, [&]<class K>(const K& w) {
            const Vec<K::dim> x = at.template head<K::dim>();
            RC_ASSERT(gradient(w, Vec<K::dim>(-x)) == Vec<K::dim>(-gradient(w, x)));
        });
    });
}

template <int Dim> Mat<Dim> rotation(double angle, const Vec<3>& axis) {
    if constexpr (Dim == 3)
        return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    else
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

/// ‖∇ω(Qx) − Q ∇ω(x)‖ against (|ω″| r + |ω′|) 2⁻⁵², the change that a last place of r makes.
template <int Dim, class Gradient> double equivariance(Gradient gradient) {
    return worst_error([gradient] {
        const double h = uniform(0.1, 10.0);
        const Vec<3> at = point<3>(-0.9, 0.9) * h, axis = point<3>(0.1, 1.0);
        const Mat<Dim> Q = rotation<Dim>(uniform(-3.0, 3.0), axis);
        const Vec<Dim> x = at.head<Dim>();
        double worst = 0.0;
        AllKernels::for_each<Dim>(h, [&](const auto& w) {
            const double r = x.norm();
            const double unit =
                0x1p-52 * (std::abs(w.second_derivative(r)) * r + std::abs(w.derivative(r)));
            const double error = (gradient(w, Vec<Dim>(Q * x)) - Q * gradient(w, x)).norm();
            // Within 1e-3 of the rim and of zeros of ω″, second order counts as well.
            if (r < 0.99 * h && r > 1e-3 * h) worst = std::max(worst, error / unit);
        });
        return worst;
    });
}

const auto as_in_solver = [](const auto& w, const auto& x) { return gradient(w, x); };
/// ω′ taken for the slope along every axis: x / r forgotten.
const auto without_direction = [](const auto& w, const auto& x) {
    using V = std::decay_t<decltype(x)>;
    return V(V::Ones() * w.derivative(x.norm()));
};

/// Kernels whose gradient at x = 0 is not exactly zero.
template <class Gradient> double gradients_at_centre(Gradient gradient) {
    double n = 0;
    for_every_kernel(0.7, [&]<class K>(const K& w) {
        n += !(gradient(w, Vec<K::dim>(Vec<K::dim>::Zero())).norm() == 0.0);
    });
    return n;
}

/// |Δω(0) − Δω(1e-9 h)| / |Δω(0)| of all kernels that are smooth at the centre.
template <class Laplacian> double jump_at_centre(Laplacian laplacian) {
    double worst = 0.0;
    for_every_kernel(0.7, [&]<class K>(const K& w) {
        if constexpr (!kink_at_centre<K>) {
            const double limit = plumbline::laplacian(w, 1e-9 * 0.7);
            const double jump = std::abs(laplacian(w) / limit - 1.0);
            if (!(jump <= worst)) worst = jump;
        }
    });
    return worst;
}

/// ‖∇∇ω(x) − ∂∇ω‖ / ‖∇∇ω‖ against central differences of the gradient with step 1e-5 h.
template <int Dim, class Hessian> double hessian_error(Hessian hessian) {
    double worst = 0.0;
    const double h = 0.7, step = 1e-5 * h;
    const Vec<Dim> x = Vec<3>(0.2, -0.3, 0.1).head<Dim>();
    AllKernels::for_each<Dim>(h, [&](const auto& w) {
        Mat<Dim> difference;
        for (int d = 0; d < Dim; ++d) {
            const Vec<Dim> e = step * Vec<Dim>::Unit(d);
            difference.col(d) =
                (gradient(w, Vec<Dim>(x + e)) - gradient(w, Vec<Dim>(x - e))) / (2 * step);
        }
        worst = std::max(worst, (hessian(w, x) - difference).norm() / difference.norm());
    });
    return worst;
}
const auto hessian_in_solver = [](const auto& w, const auto& x) { return hessian(w, x); };
/// ω″ x xᵀ / r²: the slope's share, ω′/r across x, left out.
const auto hessian_along_x = [](const auto& w, const auto& x) {
    const double r = x.norm();
    return (w.second_derivative(r) / (r * r) * x * x.transpose()).eval();
};

const Register claims_of_kernel{
    Erratum{.number = 17,
            .source = {Paper::adams2009, "Eqs. 11, 15"},
            .printed = "Δω = ω″",
            .corrected =
                "Δω = ω″ + (dim − 1) ω′/r; for second derivatives of data −2 ω′/r (Brookshaw)"},
    &eq_11_without_slope,
    Claim{.id = "kernel.scales_with_its_support",
          .source = {Paper::adams2009, "Eq. 8; Sec. 2.1"},
          .says = "ω(λr; λh) = λ^−dim ω(r; h), and ω′ with one power more, for every kernel",
          .bound = at_most(0, "bit for bit: lengths are kept in powers of two; counterexamples"),
          .measure = [] { return scale_invariance(0); },
          .sabotaged = [] { return scale_invariance(1); }},
    Claim{.id = "kernel.gradient_is_antisymmetric",
          .source = {Paper::adams2009, "Eq. 10"},
          .says = "∇ω(−x) = −∇ω(x) for every kernel",
          .bound = at_most(0, "bit for bit: only signs differ; counterexamples"),
          .measure = [] { return antisymmetry(as_in_solver); },
          .sabotaged = [] { return antisymmetry(without_direction); }},
    Claim{.id = "kernel.gradient_rotates_2d",
          .source = {Paper::adams2009, "Eq. 10"},
          .says = "∇ω(Qx) = Q ∇ω(x) for every kernel; in last places of r",
          .bound = at_most(32, "≤ 8 roundings in Q x and its norm, 24 in ω′, products and Q ∇ω"),
          .measure = [] { return equivariance<2>(as_in_solver); },
          .sabotaged = [] { return equivariance<2>(without_direction); }},
    Claim{.id = "kernel.gradient_rotates_3d",
          .source = {Paper::adams2009, "Eq. 10"},
          .says = "∇ω(Qx) = Q ∇ω(x) for every kernel; in last places of r",
          .bound = at_most(48, "as in 2D, with half as many products again"),
          .measure = [] { return equivariance<3>(as_in_solver); },
          .sabotaged = [] { return equivariance<3>(without_direction); }},
    Claim{.id = "kernel.gradient_vanishes_at_centre",
          .source = {Paper::plumbline, "docstring of gradient(RadialKernel)"},
          .says = "∇ω(0) = 0 for every kernel, also for those with a kink or a singularity",
          .bound = at_most(0, "a count"),
          .measure = [] { return gradients_at_centre(as_in_solver); },
          .sabotaged =
              [] {  // Eq. 10 as it stands: x / ‖x‖ is 0/0
                  return gradients_at_centre([](const auto& w, const auto& x) {
                      using V = std::decay_t<decltype(x)>;
                      return V(w.derivative(x.norm()) / x.norm() * x);
                  });
              }},
    Claim{.id = "kernel.laplacian_is_continuous_at_centre",
          .source = {Paper::adams2009, "Eq. 11"},
          .says = "Δω(0) = dim ω″(0) is the limit of ω″ + (dim − 1) ω′/r for every smooth kernel",
          .bound = at_most(1e-7, "terms linear in q = 1e-9 with coefficients up to 30"),
          .measure =
              [] {
                  return jump_at_centre(
                      []<class K>(const K& w) { return UnderTest<K>(w).laplacian(0.0); });
              },
          .sabotaged =
              [] { return jump_at_centre([](const auto& w) { return w.second_derivative(0.0); }); },
          .erratum = 17},
    Claim{.id = "kernel.hessian_is_the_slope_of_the_gradient",
          .source = {Paper::plumbline, "docstring of hessian(RadialKernel)"},
          .says = "∇∇ω = (ω″ − ω′/r) x xᵀ/r² + (ω′/r) I for every kernel; relative error",
          .bound = at_most(
              1e-7, "central differences: 1e-10 h³ |ω⁗| / 6 from truncation, 1e-11 from rounding"),
          .measure =
              [] {
                  return std::max(hessian_error<2>(hessian_in_solver),
                                  hessian_error<3>(hessian_in_solver));
              },
          .sabotaged = [] { return hessian_error<3>(hessian_along_x); }},
};
}  // namespace
}  // namespace kernel_concept_claims
