#include "solver/approximation/product_rule_gradient.h"

#include "solver/approximation/sph_gradient.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/invariances.h"
#include "verification/framework/poly6_field.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

namespace product_rule_gradient_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

constexpr auto mass_weighted = [](const auto& d, std::span<const double> f, Index i) {
    return gradient_mass_weighted(d.w, d.samples(), d.m, d.rho, f, i);
};

/// Eq. 19 with another sign between the quotients, or other weights than mⱼ.
template <int Dim>
Vec<Dim> symmetric_misread(const Fields<Dim>& d, std::span<const double> f, Index i, double sign,
                           std::span<const double> weights) {
    using V = Vec<Dim>;
    const auto per_density_squared = [&](Index j) { return f[j] / (d.rho[j] * d.rho[j]); };
    return d.rho[i] * sum<V>(d.patch.neighbours.of(i), [&](Index j) -> V {
               return weights[j] * (per_density_squared(j) + sign * per_density_squared(i)) *
                      gradient(d.w, V(d.patch.x[i] - d.patch.x[j]));
           });
}
constexpr auto with_minus = [](const auto& d, std::span<const double> f, Index i) {
    return symmetric_misread(d, f, i, -1.0, d.m);
};
constexpr auto with_volumes = [](const auto& d, std::span<const double> f, Index i) {
    return symmetric_misread(d, f, i, 1.0, d.patch.V);
};

constinit Mutant eq_19_with_minus{38, "Eq. 19 with −", "symmetric gradient"};
constinit Mutant eq_19_with_volumes{38, "Table 1: Eq. 19 with Vⱼ for mⱼ", "symmetric gradient"};
constexpr auto symmetric = [](const auto& d, std::span<const double> f, Index i) {
    if (eq_19_with_minus.applied()) return with_minus(d, f, i);
    if (eq_19_with_volumes.applied()) return with_volumes(d, f, i);
    return gradient_symmetric(d.w, d.samples(), d.m, d.rho, f, i);
};
const Register mutants_of_eq_19{&eq_19_with_minus, &eq_19_with_volumes};

template <class A, class B> std::vector<double> times(const A& a, const B& b, double power = 1.0) {
    std::vector<double> product;
    for (std::size_t j = 0; j < a.size(); ++j) product.push_back(a[j] * std::pow(b[j], power));
    return product;
}

/// max ‖Eq. 17 − (⟨∇(ρf)⟩ ∓ f ⟨∇ρ⟩) / ρ‖ h, with the sums of Eq. 9.
template <int Dim> double error_of_product_rule(double sign) {
    const auto& d = disordered<Dim>();
    const auto s = d.samples();
    const std::vector<double> rho_f = times(d.f, d.rho);
    double worst = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        const Vec<Dim> composed = (gradient_summation(d.w, s, rho_f, s.at(i)) -
                                   sign * d.f[i] * gradient_summation(d.w, s, d.rho, s.at(i))) /
                                  d.rho[i];
        worst = std::max(worst, (composed - mass_weighted(d, d.f, i)).norm());
    }
    return worst * d.w.support();
}

/// max ‖form − ρ (⟨∇(f/ρ)⟩ + f/ρ² ⟨∇ρ⟩)‖ h, with the sums of Eq. 9.
template <int Dim, class Form> double error_of_quotient_rule(Form form) {
    const auto& d = disordered<Dim>();
    const auto s = d.samples();
    const std::vector<double> quotient = times(d.f, d.rho, -1.0);
    double worst = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        const Vec<Dim> composed = d.rho[i] * (gradient_summation(d.w, s, quotient, s.at(i)) +
                                              d.f[i] / (d.rho[i] * d.rho[i]) *
                                                  gradient_summation(d.w, s, d.rho, s.at(i)));
        worst = std::max(worst, (composed - form(d, d.f, i)).norm());
    }
    return worst * d.w.support();
}

/// The product and quotient rules for smooth f and ρ of the plane, differences of 50 digits.
Real50 smooth_f(const Point50<2>& x) { return sin(2 * x[0]) * exp(x[1]); }
Real50 smooth_rho(const Point50<2>& x) { return 2 + cos(x[0] + 3 * x[1]); }
template <class Rule> double error_of_rule(Rule rule) {
    return worst_error([&] { return rule(point<2>(-1.0, 1.0)); }, {.number = 50});
}
double product_rule(const Vec<2>& x, double sign) {  // Eq. 16
    const auto rho_f = [](const Point50<2>& p) { return Real50(smooth_rho(p) * smooth_f(p)); };
    const Point50<2> x_50 = x.cast<Real50>();
    const auto f = static_cast<double>(smooth_f(x_50)), rho = static_cast<double>(smooth_rho(x_50));
    const Vec<2> composed =
        (gradient_to_20_digits<2>(rho_f, x) - sign * f * gradient_to_20_digits<2>(smooth_rho, x)) /
        rho;
    return (composed - gradient_to_20_digits<2>(smooth_f, x)).norm();
}
double quotient_rule(const Vec<2>& x, double sign) {  // Eq. 18
    const auto quotient = [](const Point50<2>& p) { return Real50(smooth_f(p) / smooth_rho(p)); };
    const Point50<2> x_50 = x.cast<Real50>();
    const auto f = static_cast<double>(smooth_f(x_50)), rho = static_cast<double>(smooth_rho(x_50));
    const Vec<2> composed = (rho * gradient_to_20_digits<2>(smooth_f, x) -
                             sign * f * gradient_to_20_digits<2>(smooth_rho, x)) /
                            (rho * rho);
    return (composed - gradient_to_20_digits<2>(quotient, x)).norm();
}

/// ‖Σ mᵢ aᵢ‖ / Σ ‖mᵢ aᵢ‖ with aᵢ = ∇f / ρᵢ, f being a pressure.
template <int Dim, class Form> double momentum_residual(Form form) {
    const auto& d = disordered<Dim>();
    Vec<Dim> total = Vec<Dim>::Zero();
    double size = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        const Vec<Dim> force = d.m[i] / d.rho[i] * form(d, d.f, i);
        total += force;
        size += force.norm();
    }
    return total.norm() / size;
}
/// |Σ xᵢ × mᵢ aᵢ| / Σ ‖xᵢ‖ ‖mᵢ aᵢ‖, in the plane of the first two coordinates.
template <int Dim, class Form> double angular_momentum_residual(Form form) {
    const auto& d = disordered<Dim>();
    double total = 0.0, size = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        const Vec<Dim> force = d.m[i] / d.rho[i] * form(d, d.f, i), x = d.patch.x[i];
        total += x[0] * force[1] - x[1] * force[0];
        size += x.norm() * force.norm();
    }
    return std::abs(total) / size;
}

/// How much ∇f changes when all masses, and so densities, are a thousand times larger: relatively.
template <int Dim, class Form> double change_with_unit_of_mass(Form form) {
    const auto& d = disordered<Dim>();
    Fields<Dim> in_grams = d;
    for (double& m : in_grams.m) m *= 1000.0;
    for (double& rho : in_grams.rho) rho *= 1000.0;
    const Vec<Dim> g = form(d, d.f, d.patch.centre);
    return (form(in_grams, d.f, d.patch.centre) - g).norm() / g.norm();
}

/// ‖Eq. 17 − Eq. 13‖ / ‖Eq. 13‖ at the centre; `uniform` has the same density everywhere.
template <int Dim> double difference_from_eq_13(bool uniform) {
    Fields<Dim> d = disordered<Dim>();
    if (uniform) {
        std::ranges::fill(d.rho, 3.0);
        d.patch.V = times(d.m, d.rho, -1.0);
    }
    const Vec<Dim> g = gradient_difference(d.w, d.samples(), d.f, d.patch.centre);
    return (mass_weighted(d, d.f, d.patch.centre) - g).norm() / g.norm();
}

const Register rules{
    Claim{.id = "product_rule_gradient.product_rule",
          .source = {Paper::adams2009, "Eq. 16"},
          .says = "∇f = (∇(ρ f) − f ∇ρ) / ρ for smooth functions, by differences of 50 digits",
          .bound = at_most(1e-13, "10 roundings of gradients below 50"),
          .measure =
              [] { return error_of_rule([](const Vec<2>& x) { return product_rule(x, 1.0); }); },
          .sabotaged =
              [] { return error_of_rule([](const Vec<2>& x) { return product_rule(x, -1.0); }); }},
    Claim{
        .id = "product_rule_gradient.quotient_rule",
        .source = {Paper::adams2009, "Eq. 18"},
        .says = "∇(f/ρ) = (ρ ∇f − f ∇ρ) / ρ² for smooth functions, by differences of 50 digits",
        .bound = at_most(1e-13, "10 roundings of gradients below 50"),
        .measure =
            [] { return error_of_rule([](const Vec<2>& x) { return quotient_rule(x, 1.0); }); },
        .sabotaged =
            [] { return error_of_rule([](const Vec<2>& x) { return quotient_rule(x, -1.0); }); }}};

const Register of_constants{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "product_rule_gradient.mass_weighted_kills_constants",
                 .source = {Paper::adams2009, "Eq. 17"},
                 .says = "Eq. 17 also gives zero gradients for constant functions, on any samples",
                 .bound = at_most(0.0, "every term has the factor fⱼ − fᵢ, which is 0 exactly"),
                 .measure = [] { return of_a_constant<D>(mass_weighted); },
                 .sabotaged = [] { return of_a_constant<D>(symmetric); }};
})};
const Register of_constants_symmetric{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "product_rule_gradient.symmetric_does_not_kill_constants",
                 .source = {Paper::adams2009, "Eq. 19"},
                 .says = "the price of symmetry: h ‖∇1‖ of Eq. 19 at the rim of the samples",
                 .bound = at_least(0.1,
                                   "one side of the support is empty and all terms have one sign: "
                                   "of order 1, not of rounding"),
                 .measure = [] { return of_a_constant<D>(symmetric); },
                 .sabotaged = [] { return of_a_constant<D>(mass_weighted); }};
})};
const Register from_the_product_rule{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "product_rule_gradient.is_the_product_rule",
        .source = {Paper::adams2009, "Eqs. 16, 17"},
        .says = "Eq. 17 is (⟨∇(ρf)⟩ − f ⟨∇ρ⟩) / ρ with the sums of Eq. 9",
        .bound = at_most(4e-13, "100 terms twice, Σ |terms| < 16 / h each: 32 · 110 · 1.1e-16"),
        .measure = [] { return error_of_product_rule<D>(1.0); },
        .sabotaged = [] { return error_of_product_rule<D>(-1.0); }};
})};
const Register from_the_quotient_rule{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "product_rule_gradient.is_the_quotient_rule",
        .source = {Paper::adams2009, "Eqs. 18, 19"},
        .says = "Eq. 19 is ρ (⟨∇(f/ρ)⟩ + f/ρ² ⟨∇ρ⟩) with the sums of Eq. 9: the sign is +",
        .bound = at_most(4e-13, "100 terms twice, Σ |terms| < 16 / h each: 32 · 110 · 1.1e-16"),
        .measure = [] { return error_of_quotient_rule<D>(symmetric); },
        .sabotaged = [] { return error_of_quotient_rule<D>(with_minus); },
        .erratum = 38};
})};
const Register linear_momentum{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "product_rule_gradient.symmetric_conserves_momentum",
                 .source = {Paper::adams2009, "Eq. 19; Sec. 6.1"},
                 .says = "‖Σ mᵢ ∇fᵢ/ρᵢ‖ / Σ ‖mᵢ ∇fᵢ/ρᵢ‖ = 0: what one sample gives, another takes",
                 .bound = at_most(2e-14,
                                  "100 terms per sample and 1000 samples whose errors are random: "
                                  "110 · 1.1e-16, and a surplus"),
                 .measure = [] { return momentum_residual<D>(symmetric); },
                 .sabotaged = [] { return momentum_residual<D>(with_minus); },
                 .erratum = 38};
})};
const Register angular_momentum{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "product_rule_gradient.symmetric_conserves_angular_momentum",
        .source = {Paper::adams2009, "Eq. 19; Sec. 6.1"},
        .says = "|Σ xᵢ × mᵢ ∇fᵢ/ρᵢ| / Σ ‖xᵢ‖ ‖mᵢ ∇fᵢ/ρᵢ‖ = 0: the pairs pull along their line",
        .bound = at_most(2e-14, "as for the momentum"),
        .measure = [] { return angular_momentum_residual<D>(symmetric); },
        .sabotaged = [] { return angular_momentum_residual<D>(mass_weighted); }};
})};
const Register mass_units{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "product_rule_gradient.symmetric_has_no_unit_of_mass",
        .source = {Paper::adams2009, "Eq. 19; Table 1"},
        .says =
            "∇f is the same in kilograms and in grams; with Vⱼ for mⱼ, as in Table 1, it is not",
        .bound = at_most(5e-14, "100 terms, Σ |terms| < 4 ‖∇f‖: 4 · 110 · 1.1e-16"),
        .measure = [] { return change_with_unit_of_mass<D>(symmetric); },
        .sabotaged = [] { return change_with_unit_of_mass<D>(with_volumes); },
        .erratum = 38};
})};
const Register subtle_difference{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "product_rule_gradient.differs_subtly_from_eq_13",
        .source = {Paper::adams2009, "Eqs. 13, 17"},
        .says = "Eq. 17 weighs with mⱼ/ρᵢ, Eq. 13 with mⱼ/ρⱼ: not the same unless ρ is uniform",
        .bound = at_least(1e-3, "densities vary by several percent from sample to sample"),
        .measure = [] { return difference_from_eq_13<D>(false); },
        .sabotaged = [] { return difference_from_eq_13<D>(true); }};
})};
const Register moves{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "product_rule_gradient.mass_weighted_turns_with_the_samples",
                 .source = {Paper::adams2009, "Eq. 17"},
                 .says = "∇f of scaled, turned, shifted, reordered samples is R ∇f / λ",
                 .bound = at_most(150 * position_rounding,
                                  "h² ∫ ‖∇∇ω‖ dV max |fⱼ − fᵢ| < 42, mⱼ/ρᵢ varies by 3"),
                 .measure = [] { return change_of_gradient<D>(mass_weighted, true); },
                 .sabotaged = [] { return change_of_gradient<D>(mass_weighted, false); }};
})};
const Register symmetric_moves{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "product_rule_gradient.symmetric_turns_with_the_samples",
                 .source = {Paper::adams2009, "Eq. 19"},
                 .says = "∇f of scaled, turned, shifted, reordered samples is R ∇f / λ",
                 .bound = at_most(150 * position_rounding,
                                  "h² ∫ ‖∇∇ω‖ dV max |fⱼ + fᵢ| < 42, mⱼ ρᵢ/ρⱼ² varies by 3"),
                 .measure = [] { return change_of_gradient<D>(symmetric, true); },
                 .sabotaged = [] { return change_of_gradient<D>(symmetric, false); }};
})};
}  // namespace
}  // namespace product_rule_gradient_claims
