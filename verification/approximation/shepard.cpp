#include "solver/approximation/shepard.h"

#include "solver/approximation/sph_interpolation.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/singular.h"
#include "verification/approximation/shepard_under_test.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/invariances.h"
#include "verification/framework/poly6_field.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

namespace shepard_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;

/// max |error(fields, place)| over places between the disordered samples.
template <int Dim, class Error> double worst_in_disorder(int n_places, Error error) {
    const auto& d = disordered<Dim>();
    return worst_between_samples<Dim>(d.patch, d.w.support(), n_places,
                                      [&](const Place<Dim>& at) { return error(d, at); });
}

constexpr auto by_shepard = [](const auto& d, std::span<const double> f, const auto& at) {
    return shepard_under_test(d.w, d.samples(), f, at);
};
constexpr auto by_eq_3 = [](const auto& d, std::span<const double> f, const auto& at) {
    return interpolate(d.w, d.samples(), f, at);
};

/// max |⟨c⟩ / c − 1|, and the derivatives of a constant in units of h.
template <int Dim, class Value> double of_a_constant(Value value) {
    return worst_in_disorder<Dim>(100, [&](const auto& d, const auto& at) {
        const std::vector<double> f(d.size(), 7.0);
        return value(d, f, at) / 7.0 - 1.0;
    });
}
template <int Dim> double derivatives_of_a_constant(bool divided) {
    return worst_in_disorder<Dim>(100, [&](const auto& d, const auto& at) {
        const std::vector<double> f(d.size(), 7.0);
        const double h = d.w.support() / 7.0;
        const auto s = d.samples();
        const Vec<Dim> undivided = sum<Vec<Dim>>(at.neighbours, [&](Index j) -> Vec<Dim> {
            return f[j] * s.V[j] * gradient(d.w, Vec<Dim>(at.x - s.x[j]));
        });
        if (!divided) return undivided.norm() * h;
        return shepard_gradient(d.w, s, f, at).value().norm() * h +
               std::abs(shepard_laplacian(d.w, s, f, at).value()) * h * d.w.support();
    });
}

/// How far ⟨f⟩ lies outside of the range of the neighbours' f.
template <int Dim, class Value> double out_of_range(Value value) {
    return worst_in_disorder<Dim>(200, [&](const auto& d, const auto& at) {
        std::vector<double> f;
        for (const double value_j : d.f) f.push_back(1.0 + 1e-3 * value_j);
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (const Index j : at.neighbours) low = std::min(low, f[j]), high = std::max(high, f[j]);
        const double found = value(d, f, at);
        return std::max({0.0, found - high, low - found});
    });
}

/// Shepard's quotient with 50 digits, `of` being the fields whose quotient it is.
template <int Dim> auto quotient_to_50_digits(const Fields<Dim>& d) {
    return [&d](const Point50<Dim>& x) {
        const std::vector<double> one(d.size(), 1.0);
        const double h = d.w.support();
        return Real50(poly6_field(d.patch, d.f, h, x) / poly6_field(d.patch, one, h, x));
    };
}
template <int Dim> double gradient_error(bool with_quotient_rule) {
    return worst_in_disorder<Dim>(2, [&](const auto& d, const auto& at) {
        const auto s = d.samples();
        Vec<Dim> found = shepard_gradient(d.w, s, d.f, at).value();
        if (!with_quotient_rule) {  // (Σ fⱼ ∇ωⱼ Vⱼ) / Σ ωⱼ Vⱼ
            const Vec<Dim> slope = sum<Vec<Dim>>(at.neighbours, [&](Index j) -> Vec<Dim> {
                return d.f[j] * s.V[j] * gradient(d.w, Vec<Dim>(at.x - s.x[j]));
            });
            found = slope / weighted_mean(d.w, s, d.f, at)->weights;
        }
        return (found - gradient_to_20_digits<Dim>(quotient_to_50_digits(d), at.x)).norm() *
               d.w.support();
    });
}
template <int Dim> double laplacian_error(bool with_mixed_term) {
    return worst_in_disorder<Dim>(2, [&](const auto& d, const auto& at) {
        const auto s = d.samples();
        double found = shepard_laplacian(d.w, s, d.f, at).value();
        if (!with_mixed_term) {  // without −2 ∇⟨f⟩ · ∇W / W
            const Vec<Dim> slope = sum<Vec<Dim>>(at.neighbours, [&](Index j) -> Vec<Dim> {
                return s.V[j] * gradient(d.w, Vec<Dim>(at.x - s.x[j]));
            });
            found += 2.0 * shepard_gradient(d.w, s, d.f, at)->dot(slope) /
                     weighted_mean(d.w, s, d.f, at)->weights;
        }
        return (found - laplacian_to_20_digits<Dim>(quotient_to_50_digits(d), at.x)) *
               d.w.support() * d.w.support();
    });
}

/// |⟨f⟩ with volumes a thousand times larger − ⟨f⟩|.
template <int Dim, class Value> double change_with_volume(Value value) {
    return worst_in_disorder<Dim>(50, [&](const auto& d, const auto& at) {
        auto larger = d;
        for (double& V : larger.patch.V) V *= 1000.0;
        return value(larger, d.f, at) - value(d, d.f, at);
    });
}

/// |Eq. 3 − Shepard| at a sample, masses 1 and volumes by Eqs. 4, 5.
double difference_at_sample(double jitter) {
    Fields<2> d(2.5, {.support = 0, .jitter = jitter});
    std::ranges::fill(d.m, 1.0);
    d.patch.V = volumes<Poly6<2>>(d.w, d.patch.x, d.m, d.patch.neighbours);
    const auto at = d.samples().at(d.patch.centre);
    std::ranges::fill(d.f, 1.0);
    return std::abs(by_eq_3(d, d.f, at) - by_shepard(d, d.f, at));
}

/// max over the samples around the centre of |⟨f⟩(x) − fⱼ| at xⱼ and 1e-8 beside it.
template <class K, class Value> double distance_from_samples(Value value) {
    const K w(2.5);
    const Patch<K::dim> patch(cubic_lattice<K::dim>(1.0), {.support = 2.5, .jitter = 0.2});
    const auto s = patch.samples();
    const auto f = patch.sample([](const Vec<K::dim>& x) { return std::sin(x.sum()); });
    double worst = 0.0;
    for (const Index j : s.neighbours.of(patch.centre))
        for (const double beside : {0.0, 1e-8}) {
            const Vec<K::dim> x = s.x[j] + beside * Vec<K::dim>::Unit(0);
            const double error =
                std::abs(value(w, s, f, Place<K::dim>{x, s.neighbours.of(j)}) - f[j]);
            if (!(error <= worst)) worst = error;
        }
    return worst;
}

template <int Dim> double change_of_value(bool scale_support) {
    return change_under_similarity<Dim>(2.5, 0, [=](auto d, Index i) {
        if (!scale_support) d.w = Poly6<Dim>(2.5);
        return by_shepard(d, d.f, d.samples().at(i));
    });
}

const Register constants{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "shepard.keeps_constants",
                 .source = {Paper::adams2009, "Sec. 2"},
                 .says = "⟨c⟩ = c anywhere, on any samples; by Eq. 3 it is not",
                 .bound = at_most(220 * unit_roundoff, "two sums of up to 100 positive terms"),
                 .measure = [] { return of_a_constant<D>(by_shepard); },
                 .sabotaged = [] { return of_a_constant<D>(by_eq_3); }};
})};
const Register slopes_of_constants{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "shepard.derivatives_of_constants_vanish",
        .source = {Paper::plumbline, "docstrings of shepard_gradient, shepard_laplacian"},
        .says = "h ‖∇⟨c⟩‖ / c + h² |Δ⟨c⟩| / c = 0; it is not if only the numerator is derived",
        .bound = at_most(3e-12, "fⱼ − ⟨f⟩ < 220 · 1.1e-16 f times Σ V (h ‖∇ω‖ + h² |Δω|) < 100"),
        .measure = [] { return derivatives_of_a_constant<D>(true); },
        .sabotaged = [] { return derivatives_of_a_constant<D>(false); }};
})};
const Register range{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "shepard.stays_in_the_range_of_the_samples",
        .source = {Paper::literature, "Shepard 1968"},
        .says = "⟨f⟩ is never outside of the range of the neighbours' f; by Eq. 3 it can be",
        .bound = at_most(220 * unit_roundoff, "two sums of up to 100 positive terms, f ≈ 1"),
        .measure = [] { return out_of_range<D>(by_shepard); },
        .sabotaged = [] { return out_of_range<D>(by_eq_3); }};
})};
const Register gradients{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "shepard.gradient_is_the_derivative",
        .source = {Paper::plumbline, "docstring of shepard_gradient"},
        .says = "the quotient rule gives the derivative of ⟨f⟩ itself: difference of 50 digits",
        .bound = at_most(4e-13, "100 terms, Σ |terms| < 32 / h: 32 · 110 · 1.1e-16"),
        .measure = [] { return gradient_error<D>(true); },
        .sabotaged = [] { return gradient_error<D>(false); }};
})};
const Register laplacians{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "shepard.laplacian_is_the_laplacian",
        .source = {Paper::plumbline, "docstring of shepard_laplacian"},
        .says = "the quotient rule gives the Laplacian of ⟨f⟩ itself: difference of 50 digits",
        .bound = at_most(4e-12, "100 terms, Σ |terms| < 320 / h²: 320 · 110 · 1.1e-16"),
        .measure = [] { return laplacian_error<D>(true); },
        .sabotaged = [] { return laplacian_error<D>(false); }};
})};
const Register volumes_cancel{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{
        .id = "shepard.does_not_need_the_size_of_volumes",
        .source = {Paper::literature, "Shepard 1968"},
        .says = "a common factor of all volumes, or of the kernel, cancels; in Eq. 3 it does not",
        .bound = at_most(440 * unit_roundoff, "two quotients of sums of up to 100 terms, |f| < 1"),
        .measure = [] { return change_with_volume<D>(by_shepard); },
        .sabotaged = [] { return change_with_volume<D>(by_eq_3); }};
})};
const Register moves{in_dimensions<1, 2, 3>([]<int D>() {
    return Claim{.id = "shepard.scales_and_moves",
                 .source = {Paper::literature, "Shepard 1968"},
                 .says = "⟨f⟩ is the same for scaled, turned, shifted, reordered samples",
                 .bound = at_most(30 * position_rounding,
                                  "h ∫ |ω′| dV < 4.9 supports in either sum, volumes vary by 1.5"),
                 .measure = [] { return change_of_value<D>(true); },
                 .sabotaged = [] { return change_of_value<D>(false); }};
})};
const Register interpolation{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "shepard.interpolates_with_a_singular_kernel",
        .source = {Paper::adams2009, "Sec. 2.1"},
        .says =
            "with ω(0) = ∞ the value at, and 1e-8 beside, a sample is that of the sample; this "
            "is so for the quotient, not for the sum of Eq. 3, which tends to ∞",
        .bound = at_most(4e-6,
                         "the others weigh Σ (1 − q)³/q < 100 · 2.5 against 2.5e8, q > 1/5, "
                         "and |fⱼ − fᵢ| < 2"),
        .measure =
            [] {
                return distance_from_samples<Singular<D>>(
                    [](const auto& w, const auto& s, const auto& f, const auto& at) {
                        return shepard(w, s, f, at).value();
                    });
            },
        .sabotaged =
            [] {
                return distance_from_samples<Singular<D>>(
                    [](const auto& w, const auto& s, const auto& f, const auto& at) {
                        return interpolate(w, s, f, at);
                    });
            }};
})};
const Register on_lattices{Claim{
    .id = "shepard.equals_eq_3_on_lattices",
    .source = {Paper::adams2009, "Sec. 2"},
    .says = "at the points of a lattice, where ρ is the same for all, Eq. 3 with mⱼ = 1 is Shepard",
    .bound = at_most(60 * unit_roundoff, "two sums of 21 positive terms and their quotient"),
    .measure = [] { return difference_at_sample(0.0); },
    .sabotaged = [] { return difference_at_sample(0.2); }}};
}  // namespace
}  // namespace shepard_claims
