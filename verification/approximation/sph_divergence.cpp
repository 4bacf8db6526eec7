#include "solver/approximation/sph_divergence.h"

#include "solver/approximation/sph_gradient.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/invariances.h"
#include "verification/framework/lattice_sums.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

namespace sph_divergence_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

template <int Dim> using Vectors = std::span<const Vec<Dim>>;
template <class D> using VectorsOf = Vectors<decltype(D::w)::dim>;

constexpr auto summation = [](const auto& d, const auto& u, Index i) {
    return divergence_summation(d.w, d.samples(), VectorsOf<std::decay_t<decltype(d)>>(u),
                                d.samples().at(i));
};
constexpr auto difference = [](const auto& d, const auto& u, Index i) {
    return divergence_difference(d.w, d.samples(), VectorsOf<std::decay_t<decltype(d)>>(u), i);
};

template <int Dim, class Form> double of_a_constant(Form form) {
    const auto& d = disordered<Dim>();
    const Points<Dim> u(d.size(), Vec<Dim>::LinSpaced(3.0, 5.0));
    double worst = 0.0;
    for (Index i = 0; i < d.size(); ++i) worst = std::max(worst, std::abs(form(d, u, i)));
    return worst * d.w.support() / u[0].norm();
}

/// max |∇·u − Σ_d ∂u_d/∂x_d| h with the gradient of the same form, times `sign`.
template <int Dim, class Divergence, class Gradient>
double distance_from_trace(Divergence divergence, Gradient gradient_of) {
    const auto& d = disordered<Dim>();
    std::vector<std::vector<double>> components(Dim);
    for (const Vec<Dim>& u : d.u)
        for (int k = 0; k < Dim; ++k) components[static_cast<std::size_t>(k)].push_back(u[k]);
    double worst = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        double trace = 0.0;
        for (int k = 0; k < Dim; ++k)
            trace += gradient_of(d, components[static_cast<std::size_t>(k)], i)[k];
        worst = std::max(worst, std::abs(divergence(d, d.u, i) - trace));
    }
    return worst * d.w.support();
}
constexpr auto gradient_by_summation = [](const auto& d, std::span<const double> f, Index i) {
    return gradient_summation(d.w, d.samples(), f, d.samples().at(i));
};
constexpr auto gradient_by_difference = [](const auto& d, std::span<const double> f, Index i) {
    return gradient_difference(d.w, d.samples(), f, i);
};

/// max |∇·u| / rate, u being the velocity of a rigid rotation around an axis off the centre.
template <int Dim, class Form> double of_a_rotation(Form form) {
    const auto& d = disordered<Dim>();
    const Points<Dim> u = d.patch.sample([](const Vec<Dim>& x) {
        Vec<Dim> v = Vec<Dim>::Zero();
        v[0] = -(x[1] - 4.0), v[1] = x[0] + 2.0;
        return v;
    });
    double worst = 0.0;
    for (Index i = 0; i < d.size(); ++i) worst = std::max(worst, std::abs(form(d, u, i)));
    return worst;
}

/// max |∇·x / dim − lattice sum| over lattices and supports.
template <int Dim>
double of_an_expansion(const std::vector<KnownLattice<Dim>>& lattices, double searched) {
    double worst = 0.0;
    for (const auto& known : lattices)
        for (const double h : {1.6, 2.2, 2.7, 3.3}) {
            const Patch<Dim> patch(known.lattice, {.support = searched * h, .reach = 1.0});
            const double found = divergence_difference<Poly6<Dim>>(Poly6<Dim>(h), patch.samples(),
                                                                   patch.x, patch.centre);
            const auto exact = static_cast<double>(lattice_sums(known, h).gradient);
            worst = std::max(worst, std::abs(found / Dim - exact));
        }
    return worst;
}

template <int Dim, class Form> double change_of_divergence(Form form, bool turn) {
    return change_under_similarity<Dim>(2.5, 1, [=](const auto& d, Index i) {
        auto u = d.u;
        if (!turn)
            for (Vec<Dim>& v : u) v = v.cwiseAbs().eval();
        return form(d, u, i);
    });
}

const Register of_constants{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_divergence.difference_kills_constants",
        .source = {Paper::adams2009, "Eq. 14"},
        .says =
            "the divergence of a constant vector vanishes on any samples; by Eq. 12 it does not",
        .bound = at_most(0.0, "every term has the factor fⱼ − fᵢ, which is 0 exactly"),
        .measure = [] { return of_a_constant<D>(difference); },
        .sabotaged = [] { return of_a_constant<D>(summation); }};
})};
const Register trace_of_summation{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_divergence.summation_is_a_trace",
        .source = {Paper::adams2009, "Eqs. 9, 12"},
        .says = "Eq. 12 is the trace of the gradients of the components by Eq. 9",
        .bound = at_most(6e-13, "dim sums of 100 terms, Σ |terms| < 16 / h: 48 · 110 · 1.1e-16"),
        .measure = [] { return distance_from_trace<D>(summation, gradient_by_summation); },
        .sabotaged = [] { return distance_from_trace<D>(summation, gradient_by_difference); }};
})};
const Register trace_of_difference{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_divergence.difference_is_a_trace",
        .source = {Paper::adams2009, "Eqs. 13, 14"},
        .says = "Eq. 14 is the trace of the gradients of the components by Eq. 13",
        .bound = at_most(12e-13, "dim sums of 100 terms, Σ |terms| < 32 / h: 96 · 110 · 1.1e-16"),
        .measure = [] { return distance_from_trace<D>(difference, gradient_by_difference); },
        .sabotaged = [] { return distance_from_trace<D>(difference, gradient_by_summation); }};
})};
const Register of_rotations{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "sph_divergence.rotations_have_none",
        .source = {Paper::adams2009, "Eq. 14"},
        .says =
            "a rigid rotation has no divergence by Eq. 14 on any samples: uⱼ − uᵢ is "
            "perpendicular to xⱼ − xᵢ, along which ∇ω points; by Eq. 12 it has",
        .bound = at_most(1e-13, "100 terms, Σ ‖uⱼ − uᵢ‖ ‖∇ω‖ V < 4 rates: 4 · 110 · 1.1e-16"),
        .measure = [] { return of_a_rotation<D>(difference); },
        .sabotaged = [] { return of_a_rotation<D>(summation); }};
})};
const Register of_expansions{
    Claim{.id = "sph_divergence.expansion_on_plane_lattices",
          .source = {Paper::adams2009, "Eq. 14"},
          .says = "∇·x / 2 on square and hexagonal lattices is the sum over their shells",
          .bound = at_most(1e-13, "up to 40 terms, Σ |terms| < 4: 4 · 50 · 1.1e-16"),
          .measure = [] { return of_an_expansion(plane_lattices(), 1.0); },
          .sabotaged = [] { return of_an_expansion(plane_lattices(), 0.8); }},
    Claim{.id = "sph_divergence.expansion_on_space_lattices",
          .source = {Paper::adams2009, "Eq. 14"},
          .says = "∇·x / 3 on simple, body-centred and face-centred cubic lattices is the sum over "
                  "shells",
          .bound = at_most(1e-13, "up to 250 terms, Σ |terms| < 3: 3 · 260 · 1.1e-16"),
          .measure = [] { return of_an_expansion(space_lattices(), 1.0); },
          .sabotaged = [] { return of_an_expansion(space_lattices(), 0.8); }}};
const Register moves{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_divergence.turns_with_the_samples",
        .source = {Paper::adams2009, "Eqs. 12, 14"},
        .says =
            "∇·u of scaled, turned, shifted, reordered samples, with u turned along, is ∇·u / λ",
        .bound = at_most(300 * position_rounding,
                         "h² ∫ ‖∇∇ω‖ dV max ‖uⱼ − uᵢ‖ < 73, volumes vary by 1.5, two forms"),
        .measure =
            [] {
                return change_of_divergence<D>(summation, true) +
                       change_of_divergence<D>(difference, true);
            },
        .sabotaged = [] { return change_of_divergence<D>(difference, false); }};
})};
}  // namespace
}  // namespace sph_divergence_claims
