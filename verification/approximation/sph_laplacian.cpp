#include "solver/approximation/sph_laplacian.h"

#include "solver/approximation/at_all.h"
#include "solver/approximation/density.h"
#include "solver/approximation/sph_divergence.h"
#include "solver/approximation/sph_gradient.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/invariances.h"
#include "verification/framework/poly6_field.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

namespace sph_laplacian_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

constexpr auto true_laplacian = [](const auto& w, double r) { return laplacian(w, r); };
/// Δω as it is printed below Eq. 11.
constexpr auto as_printed = [](const auto& w, double r) { return w.second_derivative(r); };

/// Σⱼ (fⱼ − subtracted) Δω Vⱼ at `at`: Eqs. 11 and 15 with any Δω.
template <class K, class LaplacianOfKernel>
double sum_with(const K& w, const Samples<K::dim>& s, std::span<const double> f,
                const Place<K::dim>& at, double subtracted, LaplacianOfKernel laplacian_of) {
    return sum<double>(at.neighbours, [&](Index j) {
        return (f[j] - subtracted) * laplacian_of(w, (at.x - s.x[j]).norm()) * s.V[j];
    });
}
constexpr auto summation = [](const auto& d, std::span<const double> f, const auto& at) {
    return laplacian_summation(d.w, d.samples(), f, at);
};
constexpr auto summation_as_printed = [](const auto& d, std::span<const double> f, const auto& at) {
    return sum_with(d.w, d.samples(), f, at, 0.0, as_printed);
};
constexpr auto difference = [](const auto& d, std::span<const double> f, Index i) {
    return laplacian_difference(d.w, d.samples(), f, i);
};
constexpr auto difference_as_printed = [](const auto& d, std::span<const double> f, Index i) {
    return sum_with(d.w, d.samples(), f, d.samples().at(i), f[i], as_printed);
};

constexpr auto summation_at_sample = [](const auto& d, std::span<const double> f, Index i) {
    return summation(d, f, d.samples().at(i));
};

/// |Δ⟨f⟩ − the Laplacian of the sum itself| h², at places between the samples.
template <int Dim, class Form> double error_of_derivative(Form form) {
    const auto& d = disordered<Dim>();
    const double h = d.w.support();
    const auto field = [&](const Point50<Dim>& p) { return poly6_field(d.patch, d.f, h, p); };
    return h * h *
           worst_between_samples<Dim>(d.patch, h, Dim == 3 ? 2 : 10, [&](const Place<Dim>& at) {
               return form(d, d.f, at) - laplacian_to_20_digits<Dim>(field, at.x);
           });
}

/// h^(2 − power) ∫ Δω ‖x‖^power dV over the support.
template <int Dim, class LaplacianOfKernel>
double moment(int power, LaplacianOfKernel laplacian_of) {
    const Poly6<Dim> w(0.8);
    const double surface = Dim == 2 ? 2.0 * std::numbers::pi : 4.0 * std::numbers::pi;
    const auto shell = [&](double r) {
        return laplacian_of(w, r) * surface * std::pow(r, Dim - 1 + power);
    };
    return std::pow(w.support(), 2 - power) * integrate(shell, 0.0, w.support());
}

/// max |Δf / 2 − lattice sum| of f = y² by Eq. 15 over supports.
template <int Dim, class LaplacianOfKernel>
double error_on_lattice(const KnownLattice<Dim>& known, LaplacianOfKernel laplacian_of) {
    double worst = 0.0;
    for (const double h : {1.6, 2.2, 2.7, 3.3}) {
        const Patch<Dim> patch(known.lattice, {.support = h, .reach = 1.0});
        const auto f = patch.sample([](const Vec<Dim>& p) { return p[1] * p[1]; });
        const auto s = patch.samples();
        const Poly6<Dim> w(h);
        const double found = sum_with(w, s, f, s.at(patch.centre), f[patch.centre], laplacian_of);
        worst = std::max(
            worst, std::abs(found / 2.0 - static_cast<double>(lattice_sums(known, h).laplacian)));
        const double by_solver = laplacian_difference(w, s, f, patch.centre);
        worst = std::max(worst, std::abs(by_solver - sum_with(w, s, f, s.at(patch.centre),
                                                              f[patch.centre], true_laplacian)));
    }
    return worst;
}

/// Δy² by Eq. 15 on a square lattice with the volumes of Eqs. 4, 5; 2 if it were exact.
double on_square_lattice(double h) {
    const auto sums = lattice_sums(plane_lattices()[0], h);
    return static_cast<double>(2 * sums.laplacian / sums.density);
}
double of_parabola(double h, bool printed) {
    const Poly6<2> w(h);
    Patch<2> patch(cubic_lattice<2>(1.0), {.support = h});
    const std::vector<double> m(patch.x.size(), 1.0);
    std::ranges::fill(patch.V, volumes<Poly6<2>>(w, patch.x, m, patch.neighbours)[patch.centre]);
    const auto f = patch.sample([](const Vec<2>& p) { return p[1] * p[1]; });
    const auto s = patch.samples();
    return printed ? sum_with(w, s, f, s.at(patch.centre), 0.0, as_printed)
                   : laplacian_difference(w, s, f, patch.centre);
}

/// Δf − ∇·∇f of f = y² at the centre of a square lattice, by Eqs. 13, 14, 15.
double laplacian_less_divergence_of_gradient() {
    const Poly6<2> w(2.5);
    const Patch<2> patch(cubic_lattice<2>(1.0), {.support = 2.5});
    const auto s = patch.samples();
    const auto f = patch.sample([](const Vec<2>& p) { return p[1] * p[1]; });
    const Points<2> grad =
        at_all(f.size(), [&](Index i) { return gradient_difference(w, s, f, i); });
    return laplacian_difference(w, s, f, patch.centre) -
           divergence_difference<Poly6<2>>(w, s, grad, patch.centre);
}
/// The same of the parabola itself, by differences of 50 digits.
double of_continuous_operators() {
    const auto f = [](const Point50<2>& p) { return Real50(p[1] * p[1]); };
    const auto slope = [](const Point50<2>& p) { return Real50(2 * p[1]); };
    const Vec<2> x(0.3, 0.4);
    return laplacian_to_20_digits<2>(f, x) - gradient_to_20_digits<2>(slope, x)[1];
}
/// By the shells: f = y² has the gradient 2 γ y and hence the divergence 2 γ², γ being the slope of y.
double expected_difference() {
    const auto sums = lattice_sums(plane_lattices()[0], 2.5);
    return static_cast<double>(2 * sums.laplacian - 2 * sums.gradient * sums.gradient);
}

/// The orders of |Δx| by Eq. 15, and of |Δ1| by Eq. 11, which are 0 in truth.
double order_for_linear_fields(double jitter) {
    return order_under_refinement<2>(2.5, jitter, [](const auto& d) {
        const auto x = d.patch.sample([](const Vec<2>& p) { return p[0]; });
        return std::abs(difference(d, x, d.patch.centre));
    });
}
double order_for_parabolas_on_lattice() {
    return order_under_refinement<2>(2.5, 0.0, [](const auto& d) {
        const auto y_squared = d.patch.sample([](const Vec<2>& p) { return p[1] * p[1]; });
        return std::abs(difference(d, y_squared, d.patch.centre) - 2.0);
    });
}
template <class Form> double order_for_constants(Form form) {
    return order_under_refinement<2>(2.5, 0.3, [form](const auto& d) {
        const std::vector<double> one(d.size(), 1.0);
        return form(d, one, d.patch.centre);
    });
}
constexpr auto size_of_summation = [](const auto& d, std::span<const double> f, Index i) {
    return std::abs(laplacian_summation(d.w, d.samples(), f, d.samples().at(i)));
};
constexpr auto size_of_gradient = [](const auto& d, std::span<const double> f, Index i) {
    return gradient_summation(d.w, d.samples(), f, d.samples().at(i)).norm();
};
const char* const why_whole_orders =
    "halving all lengths multiplies every term by a power of two, exactly but for the logarithm";
const Register orders{
    Erratum{48,
            {Paper::plumbline, "catalogue of formulas, Eqs. 11, 15 and Brookshaw's form"},
            "on disorder the error of Eq. 15 stays as it is, that of Eq. 11 grows as 1/h, and "
            "Brookshaw's form is of order 2 on lattices",
            "on disorder Eq. 15 and Brookshaw's form diverge as 1/h, Eq. 11 as 1/h²; on lattices, "
            "h/spacing fixed, all of them keep an error"},
    Claim{.id = "sph_laplacian.difference_diverges_on_disorder",
          .source = {Paper::adams2009, "Eq. 15"},
          .says = "the Laplacian of a linear field by Eq. 15 on disordered samples grows as 1/h; "
                  "only that of a parabola on a lattice stays",
          .bound = between(-1.0 - 1e-12, -1.0 + 1e-12, why_whole_orders),
          .measure = [] { return order_for_linear_fields(0.3); },
          .sabotaged = order_for_parabolas_on_lattice,
          .erratum = 48},
    Claim{.id = "sph_laplacian.summation_diverges_on_disorder",
          .source = {Paper::adams2009, "Eq. 11"},
          .says =
              "the Laplacian of a constant by Eq. 11 on disordered samples grows as 1/h², not as "
              "1/h like the gradient of Eq. 9",
          .bound = between(-2.0 - 1e-12, -2.0 + 1e-12, why_whole_orders),
          .measure = [] { return order_for_constants(size_of_summation); },
          .sabotaged = [] { return order_for_constants(size_of_gradient); },
          .erratum = 48}};

template <int Dim> double change_of_laplacian(bool scale_support) {
    return change_under_similarity<Dim>(2.5, 2, [=](auto d, Index i) {
        if (!scale_support) d.w = Poly6<Dim>(2.5);
        return Vec<2>(summation_at_sample(d, d.f, i), difference(d, d.f, i)).norm();
    });
}

template <int Dim>
std::vector<Claim> claims_on_lattices(const std::vector<KnownLattice<Dim>>& lattices) {
    std::vector<Claim> claims;
    for (const KnownLattice<Dim>& known : lattices)
        claims.push_back(
            {.id = "sph_laplacian.on_lattice_" + known.name,
             .source = {Paper::adams2009, "Eqs. 11, 15"},
             .says = "Δy² / 2 on the lattice is the sum over its shells, whose sizes number "
                     "theory gives; with ω″ for Δω it is another",
             .bound = at_most(3e-13, "up to 250 terms, Σ |terms| < 10: 10 · 260 · 1.1e-16"),
             .measure = [&known] { return error_on_lattice(known, true_laplacian); },
             .sabotaged = [&known] { return error_on_lattice(known, as_printed); },
             .erratum = 17});
    return claims;
}
const Register on_plane_lattices{claims_on_lattices(plane_lattices())};
const Register on_space_lattices{claims_on_lattices(space_lattices())};

const Register of_constants{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_laplacian.difference_kills_constants",
        .source = {Paper::adams2009, "Eq. 15"},
        .says = "subtracting fᵢ makes the Laplacian of a constant vanish; by Eq. 11 it does not",
        .bound = at_most(0.0, "every term has the factor fⱼ − fᵢ, which is 0 exactly"),
        .measure = [] { return of_a_constant<D>(difference); },
        .sabotaged = [] { return of_a_constant<D>(summation_at_sample); }};
})};
const Register derivative_of_the_sum{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "sph_laplacian.summation_is_the_laplacian_of_the_sum",
        .source = {Paper::adams2009, "Eqs. 3, 11"},
        .says =
            "Eq. 11 is the Laplacian of Eq. 3 if Δω = ω″ + (dim − 1) ω′/r: difference of 50 digits",
        .bound = at_most(2e-12, "100 terms, Σ |terms| < 160 / h²: 160 · 110 · 1.1e-16"),
        .measure = [] { return error_of_derivative<D>(summation); },
        .sabotaged = [] { return error_of_derivative<D>(summation_as_printed); },
        .erratum = 17};
})};
const Register reaction{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "sph_laplacian.adds_no_reaction",
        .source = {Paper::adams2009, "Eq. 11"},
        .says = "h² ∫ Δω dV = 0; printed, with ω″, constants react with 8 (plane), 18 (space)",
        .bound =
            between(-1e-12, 1e-12, "relative accuracy of the quadrature 1e-13, ∫ |Δω| dV < 10"),
        .measure = [] { return moment<D>(0, true_laplacian); },
        .sabotaged = [] { return moment<D>(0, as_printed); },
        .erratum = 17};
})};
const Register second_moment{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "sph_laplacian.of_a_paraboloid",
        .source = {Paper::adams2009, "Eqs. 11, 15"},
        .says = "∫ Δω ‖x‖² / (2 dim) dV = 1; printed, with ω″, it is (dim + 1) / 2",
        .bound = between(1.0 - 1e-12, 1.0 + 1e-12, "relative accuracy of the quadrature 1e-13"),
        .measure = [] { return moment<D>(2, true_laplacian) / (2 * D); },
        .sabotaged = [] { return moment<D>(2, as_printed) / (2 * D); },
        .erratum = 17};
})};
const Register moves{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "sph_laplacian.scales_and_moves",
        .source = {Paper::adams2009, "Eqs. 11, 15"},
        .says = "Δf of scaled, turned, shifted, reordered samples is Δf / λ²",
        .bound = at_most(700 * position_rounding,
                         "h³ ∫ ‖∇Δω‖ dV max |fⱼ − fᵢ| < 330, volumes vary by 1.5, two forms"),
        .measure = [] { return change_of_laplacian<D>(true); },
        .sabotaged = [] { return change_of_laplacian<D>(false); }};
})};
const Register of_the_parabola{
    Claim{.id = "sph_laplacian.parabola_on_square_lattice_narrow",
          .source = {Paper::adams2009, "Eq. 15"},
          .says = "Δy² = 2.86 instead of 2 on a square lattice with 2.5 spacings per support; 3.86 "
                  "as printed",
          .bound = between(on_square_lattice(2.5) - 1e-12, on_square_lattice(2.5) + 1e-12,
                           "sum over the shells; 21 terms, Σ |terms| < 10"),
          .measure = [] { return of_parabola(2.5, false); },
          .sabotaged = [] { return of_parabola(2.5, true); },
          .erratum = 17},
    Claim{.id = "sph_laplacian.parabola_on_square_lattice_wide",
          .source = {Paper::adams2009, "Eq. 15"},
          .says = "Δy² = 1.82 instead of 2 on a square lattice with 4 spacings per support; 2.82 "
                  "as printed",
          .bound = between(on_square_lattice(4.0) - 1e-12, on_square_lattice(4.0) + 1e-12,
                           "sum over the shells; 45 terms, Σ |terms| < 10"),
          .measure = [] { return of_parabola(4.0, false); },
          .sabotaged = [] { return of_parabola(4.0, true); },
          .erratum = 17},
    Claim{
        .id = "sph_laplacian.is_not_the_divergence_of_the_gradient",
        .source = {Paper::adams2009, "Eq. 20"},
        .says =
            "Δf − ∇·∇f of f = y² by Eqs. 13, 14, 15 on a square lattice; it is 0 in the continuum",
        .bound = between(expected_difference() - 1e-12, expected_difference() + 1e-12,
                         "2 λ − 2 γ² from the sums over shells; 21 terms twice, Σ |terms| < 10"),
        .measure = laplacian_less_divergence_of_gradient,
        .sabotaged = of_continuous_operators}};
}  // namespace
}  // namespace sph_laplacian_claims
