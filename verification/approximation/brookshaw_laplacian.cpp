#include "solver/approximation/brookshaw_laplacian.h"

#include "solver/approximation/density.h"
#include "solver/approximation/sph_laplacian.h"
#include "solver/kernels/poly6.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/invariances.h"
#include "verification/framework/lattice_sums.h"
#include "verification/framework/registry.h"

namespace brookshaw_laplacian_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

constexpr auto brookshaw = [](const auto& d, std::span<const double> f, Index i) {
    return laplacian_brookshaw(d.w, d.samples(), f, i);
};
constexpr auto by_eq_15 = [](const auto& d, std::span<const double> f, Index i) {
    return laplacian_difference(d.w, d.samples(), f, i);
};
constexpr auto by_eq_11 = [](const auto& d, std::span<const double> f, Index i) {
    return laplacian_summation(d.w, d.samples(), f, d.samples().at(i));
};

/// h² max Δf over all samples that are the maximum of f among their neighbours, f being random there.
template <int Dim, class Form> double largest_at_a_maximum(Form form) {
    const auto& d = disordered<Dim>();
    double largest = -HUGE_VAL;
    counterexamples(
        [&] {
            std::vector<double> f;
            for (std::size_t j = 0; j < d.size(); ++j) f.push_back(uniform(-1.0, 1.0));
            f[d.patch.centre] = 1.0;
            largest = std::max(largest, form(d, f, d.patch.centre));
        },
        {.number = 30});
    return largest * d.w.support() * d.w.support();
}

/// |Σ Vᵢ Δfᵢ| / Σ |Vᵢ Δfᵢ|; `weight` other than Vᵢ breaks the symmetry.
template <int Dim, class Weight> double source_of_heat(Weight weight) {
    const auto& d = disordered<Dim>();
    double total = 0.0, size = 0.0;
    for (Index i = 0; i < d.size(); ++i) {
        const double rate = weight(d, i) * brookshaw(d, d.f, i);
        total += rate, size += std::abs(rate);
    }
    return std::abs(total) / size;
}

/// max |Δf / 2 − lattice sum| of f = y² + 3 x y + x over supports; xy and x have no Laplacian.
template <int Dim> double error_on_lattice(const KnownLattice<Dim>& known, double factor) {
    double worst = 0.0;
    for (const double h : {1.6, 2.2, 2.7, 3.3}) {
        const Patch<Dim> patch(known.lattice, {.support = h, .reach = 1.0});
        const auto f =
            patch.sample([](const Vec<Dim>& p) { return p[1] * p[1] + 3.0 * p[0] * p[1] + p[0]; });
        const double found =
            factor * laplacian_brookshaw(Poly6<Dim>(h), patch.samples(), f, patch.centre);
        worst = std::max(
            worst, std::abs(found / 2.0 - static_cast<double>(lattice_sums(known, h).gradient)));
    }
    return worst;
}

/// Δy² on a square lattice with the volumes of Eqs. 4, 5.
double of_parabola(double h, double (*form)(const Poly6<2>&, const Samples<2>&,
                                            std::span<const double>, Index)) {
    const Poly6<2> w(h);
    Patch<2> patch(cubic_lattice<2>(1.0), {.support = h});
    const std::vector<double> m(patch.x.size(), 1.0);
    std::ranges::fill(patch.V, volumes<Poly6<2>>(w, patch.x, m, patch.neighbours)[patch.centre]);
    const auto f = patch.sample([](const Vec<2>& p) { return p[1] * p[1]; });
    return form(w, patch.samples(), f, patch.centre);
}
double on_square_lattice(double h) {
    const auto sums = lattice_sums(plane_lattices()[0], h);
    return static_cast<double>(2 * sums.gradient / sums.density);
}

/// −∫ 2 ω′/r ‖x‖² / (2 dim) dV: the Laplacian of the paraboloid ‖x‖² / (2 dim).
template <int Dim> double second_moment(double factor) {
    const Poly6<Dim> w(0.8);
    constexpr double pi = std::numbers::pi;
    constexpr double surface = Dim == 1 ? 2.0 : Dim == 2 ? 2.0 * pi : 4.0 * pi;
    return integrate(
        [&](double r) {
            return -factor * w.derivative(r) * r / (2 * Dim) * surface * std::pow(r, Dim - 1);
        },
        0.0, w.support());
}

/// The order of |Δf − exact|, h/spacing fixed: f = x on disordered samples, f = y² on a lattice.
double order_on_disorder() {
    return order_under_refinement<2>(2.5, 0.3, [](const auto& d) {
        const auto x = d.patch.sample([](const Vec<2>& p) { return p[0]; });
        return std::abs(brookshaw(d, x, d.patch.centre));
    });
}
double order_on_lattice() {
    return order_under_refinement<2>(2.5, 0.0, [](const auto& d) {
        const auto y_squared = d.patch.sample([](const Vec<2>& p) { return p[1] * p[1]; });
        return std::abs(brookshaw(d, y_squared, d.patch.centre) - 2.0);
    });
}
const char* const why_whole_orders =
    "halving all lengths multiplies every term by a power of two, exactly but for the logarithm";
const Register orders{
    Claim{.id = "brookshaw_laplacian.diverges_on_disorder",
          .source = {Paper::literature, "Brookshaw 1985"},
          .says = "the Laplacian of a linear field on disordered samples grows as 1/h",
          .bound = between(-1.0 - 1e-12, -1.0 + 1e-12, why_whole_orders),
          .measure = order_on_disorder,
          .sabotaged = order_on_lattice,
          .erratum = 48},
    Claim{.id = "brookshaw_laplacian.keeps_an_error_on_lattices",
          .source = {Paper::literature, "Brookshaw 1985"},
          .says = "on a square lattice, h/spacing fixed, the error for a parabola is of order 0",
          .bound = between(-1e-9, 1e-9,
                           "the error is 0.006 of sums of 10, known to 10 · 30 · 1.1e-16 / 0.006"),
          .measure = order_on_lattice,
          .sabotaged = order_on_disorder,
          .erratum = 48}};

template <int Dim> double change_of_laplacian(bool scale_support) {
    return change_under_similarity<Dim>(2.5, 2, [=](auto d, Index i) {
        if (!scale_support) d.w = Poly6<Dim>(2.5);
        return brookshaw(d, d.f, i);
    });
}

template <int Dim>
std::vector<Claim> claims_on_lattices(const std::vector<KnownLattice<Dim>>& lattices) {
    std::vector<Claim> claims;
    for (const KnownLattice<Dim>& known : lattices)
        claims.push_back(
            {.id = "brookshaw_laplacian.on_lattice_" + known.name,
             .source = {Paper::literature, "Brookshaw 1985"},
             .says = "Δy² / 2 on the lattice is the slope that Eq. 13 gives for y; xy and x add "
                     "nothing",
             .bound = at_most(3e-13, "up to 250 terms, Σ |terms| < 10: 10 · 260 · 1.1e-16"),
             .measure = [&known] { return error_on_lattice(known, 1.0); },
             .sabotaged = [&known] { return error_on_lattice(known, 0.5); }});
    return claims;
}
const Register on_plane_lattices{claims_on_lattices(plane_lattices())};
const Register on_space_lattices{claims_on_lattices(space_lattices())};

const Register of_constants{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "brookshaw_laplacian.kills_constants",
                 .source = {Paper::literature, "Brookshaw 1985"},
                 .says = "the Laplacian of a constant vanishes on any samples",
                 .bound = at_most(0.0, "every term has the factor fᵢ − fⱼ, which is 0 exactly"),
                 .measure = [] { return of_a_constant<D>(brookshaw); },
                 .sabotaged = [] { return of_a_constant<D>(by_eq_11); }};
})};
const Register maximum_principle{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "brookshaw_laplacian.obeys_the_maximum_principle",
        .source = {Paper::literature, "Brookshaw 1985"},
        .says =
            "Δf ≤ 0 where f is the largest of its neighbourhood; by Eq. 15 it can be > 0, as Δω "
            "changes its sign",
        .bound =
            at_most(0.0, "every term is (fᵢ − fⱼ) ω′/r V with fᵢ ≥ fⱼ, ω′ ≤ 0: none is positive"),
        .measure = [] { return largest_at_a_maximum<D>(brookshaw); },
        .sabotaged = [] { return largest_at_a_maximum<D>(by_eq_15); }};
})};
const Register conservation{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "brookshaw_laplacian.conserves",
        .source = {Paper::literature, "Brookshaw 1985"},
        .says = "|Σ Vᵢ Δfᵢ| / Σ |Vᵢ Δfᵢ| = 0: what one sample loses, another gains",
        .bound =
            at_most(2e-14, "100 terms per sample: 110 · 1.1e-16, and a surplus for the last sum"),
        .measure =
            [] { return source_of_heat<D>([](const auto& d, Index i) { return d.patch.V[i]; }); },
        .sabotaged =
            [] { return source_of_heat<D>([](const auto& d, Index i) { return d.m[i]; }); }};
})};
const Register paraboloid{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "brookshaw_laplacian.of_a_paraboloid",
        .source = {Paper::literature, "Brookshaw 1985"},
        .says =
            "−∫ 2 ω′/r ‖x‖² / (2 dim) dV = 1: exact for quadratic f where the sum is an integral",
        .bound = between(1.0 - 1e-12, 1.0 + 1e-12, "relative accuracy of the quadrature 1e-13"),
        .measure = [] { return second_moment<D>(2.0); },
        .sabotaged = [] { return second_moment<D>(1.0); }};
})};
const Register moves{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "brookshaw_laplacian.scales_and_moves",
        .source = {Paper::literature, "Brookshaw 1985"},
        .says = "Δf of scaled, turned, shifted, reordered samples is Δf / λ²",
        .bound = at_most(300 * position_rounding,
                         "h³ ∫ |d(2 ω′/r)/dr| dV max |fⱼ − fᵢ| < 200, volumes vary by 1.5"),
        .measure = [] { return change_of_laplacian<D>(true); },
        .sabotaged = [] { return change_of_laplacian<D>(false); }};
})};
const Register of_the_parabola{
    Claim{.id = "brookshaw_laplacian.parabola_on_square_lattice_narrow",
          .source = {Paper::literature, "Brookshaw 1985"},
          .says = "Δy² = 2.006 instead of 2 on a square lattice with 2.5 spacings per support",
          .bound = between(on_square_lattice(2.5) - 1e-12, on_square_lattice(2.5) + 1e-12,
                           "sum over the shells; 21 terms, Σ |terms| < 4"),
          .measure = [] { return of_parabola(2.5, laplacian_brookshaw<Poly6<2>>); },
          .sabotaged = [] { return of_parabola(2.5, laplacian_difference<Poly6<2>>); }},
    Claim{.id = "brookshaw_laplacian.parabola_on_square_lattice_wide",
          .source = {Paper::literature, "Brookshaw 1985"},
          .says = "Δy² = 2.009 instead of 2 on a square lattice with 4 spacings per support",
          .bound = between(on_square_lattice(4.0) - 1e-12, on_square_lattice(4.0) + 1e-12,
                           "sum over the shells; 45 terms, Σ |terms| < 4"),
          .measure = [] { return of_parabola(4.0, laplacian_brookshaw<Poly6<2>>); },
          .sabotaged = [] { return of_parabola(4.0, laplacian_difference<Poly6<2>>); }}};
}  // namespace
}  // namespace brookshaw_laplacian_claims
