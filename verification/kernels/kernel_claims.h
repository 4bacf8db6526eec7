#pragma once

#include "solver/kernels/kernel.h"
#include "verification/framework/claim.h"
#include "verification/framework/oracle.h"
#include "verification/kernels/radial.h"
#include "verification/kernels/under_test.h"

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <concepts>

namespace verification {

/// A kernel as its publication prints it, with d = r and any number type: the truth that the solver's
/// own form of it is measured against. Independent of the solver's code.
template <class F>
concept KernelFormula = requires(Real50 d, Real50 h) {
    { F::value(d, h) } -> std::convertible_to<Real50>;
    { F::derivative(d, h) } -> std::convertible_to<Real50>;
    { F::second_derivative(d, h) } -> std::convertible_to<Real50>;
    { F::second_moment() } -> std::convertible_to<Real50>;  // ∫ ω x² dV of one axis, h = 1
    { F::rim_order } -> std::convertible_to<int>;           // ω ~ (h − r)^rim_order at the rim
    { F::singular } -> std::convertible_to<bool>;           // at r = 0
};

/// Two numbers of which one is compared with the other; `scale` turns the difference relative.
struct Comparison {
    double found;
    Real50 exact;
    Real50 scale;
};

namespace kernel_detail {

constexpr double support = 0.7;  // not a power of two, nor 1: a lost power of h shows
constexpr double epsilon = 0x1p-52;

/// Calls measure.operator()<K, F>() for every dimension where the kernel exists; the worst result.
template <template <int> class Kernel, template <int> class Formula, class Measure>
double worst_over_dimensions(Measure measure) {
    double worst = 0.0;
    const auto take = [&](double error) {
        if (!(error <= worst)) worst = error;  // NaN counts as the worst
    };
    if constexpr (requires { typename Kernel<1>; })
        take(measure.template operator()<UnderTest<Kernel<1>>, Formula<1>>());
    take(measure.template operator()<UnderTest<Kernel<2>>, Formula<2>>());
    take(measure.template operator()<UnderTest<Kernel<3>>, Formula<3>>());
    return worst;
}

/// The worst |found − exact| / scale, in units of 2⁻⁵², over 500 radii in the support.
template <class Compare> double worst_at_radii(Compare compare) {
    constexpr int n = 500;
    Real50 worst = 0;
    for (int k = 0; k < n; ++k) {
        const Comparison c = compare(support * (k + 0.5) / n);
        worst = std::max<Real50>(worst, abs((Real50(c.found) - c.exact) / c.scale));
    }
    return worst.convert_to<double>() / epsilon;
}

/// The scale that gives errors in last places of `number` instead of in units of 2⁻⁵².
inline Real50 in_last_places(const Real50& number) {
    const auto x = number.convert_to<double>();
    return Real50(std::nextafter(x, HUGE_VAL) - x) / epsilon;
}

template <class F> Real50 peak_of_second_derivative() {
    Real50 peak = 0;
    for (int k = 0; k < 100; ++k)
        peak = std::max<Real50>(
            peak, abs(F::second_derivative(Real50(support * (k + 0.5) / 100), Real50(support))));
    return peak;
}

/// What the error of ω is also measured against where its docstring admits that terms cancel.
template <class F> Real50 size_of_cancelling_terms() {
    if constexpr (requires { F::size_of_cancelling_terms(); })
        return F::size_of_cancelling_terms() / pow(Real50(support), 2);
    return 0;
}

/// The kernel of a dimension taken for another one: the σ of the wrong space.
template <template <int> class Kernel, class K> double integral_of_another_dimension() {
    constexpr int other = K::dim == 3 ? 2 : 3;
    const Kernel<other> w(support);
    return integrate_radially<K::dim>(support, [&](double r) { return w.value(r); });
}

/// 1 − ∫ ω(x) cos(k x₁) dV over its limit m₂ k² / 2, with k h = 0.1 and m₂ the exact moment.
template <class K, class F, class Value> double smoothing_error_over_limit(Value value) {
    constexpr double kh = 0.1, k = kh / support;
    const auto mean_cosine = [](double z) {  // of cos(z n₁) over all directions n
        if (K::dim == 1) return std::cos(z);
        if (K::dim == 2) return gsl_sf_bessel_J0(z);
        return gsl_sf_bessel_j0(z);
    };
    const double smoothed = integrate_radially<K::dim>(
        support, [&](double r) { return value(r) * mean_cosine(k * r); }, knots<F>());
    const double m2 = Real50(F::second_moment()).template convert_to<double>();
    return (1.0 - smoothed) / (m2 / 2 * kh * kh);
}

/// Radii where ω < 0 or ω grows, among 1000.
template <class Value> double violations(Value value) {
    int n = 0;
    for (int k = 1; k <= 1000; ++k) {
        const double inner = value(support * (k - 0.5) / 1000), outer = value(support * k / 1000);
        n += outer < 0.0 || outer > inner;
    }
    return n;
}

/// |ω| + |ω′| + |ω″| + |Δω| at and beyond `rim`.
template <class K> double sum_outside(const K& w, double rim) {
    double total = 0.0;
    for (const double r : {rim, std::nextafter(rim, 1e9), 1.5 * rim, 1e3 * rim, HUGE_VAL})
        total += std::abs(w.value(r)) + std::abs(w.derivative(r)) +
                 std::abs(w.second_derivative(r)) + std::abs(laplacian(w, r));
    return total;
}

/// ∫ g dV over the shell from h/10 to h, less the flux of ∇ω through its two surfaces (Gauss), both of
/// unit support.
template <class K, class G> double gauss_defect(const K& w, G g) {
    const double a = 0.1 * support, inside = std::nextafter(support, 0.0);
    const double flux =
        sphere<K::dim>(support) * w.derivative(inside) - sphere<K::dim>(a) * w.derivative(a);
    const double source = integrate([&](double r) { return g(r) * sphere<K::dim>(r); }, a, inside,
                                    {support / 3, support / 2, support * 2 / 3});
    return std::abs(source - flux) * support * support;
}

}  // namespace kernel_detail

/// What every kernel has to fulfil, measured in every dimension where it exists; the worst counts.
template <template <int> class Kernel, template <int> class Formula>
std::vector<Claim> kernel_claims(const Source& source) {
    using namespace kernel_detail;
    const std::string name(Kernel<2>::name);
    const auto everywhere = [](auto measure) {
        return [measure] { return worst_over_dimensions<Kernel, Formula>(measure); };
    };
    std::vector<Claim> claims;

    claims.push_back(
        {.id = name + ".integrates_to_one",
         .source = source,
         .says = "∫ ω dV = 1 (Eq. 8), in each dimension with its own σ",
         .bound = at_most(1e-12, "GSL's quadrature asked for 1e-13 in each of up to 4 panels"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             const auto value = [&](double r) { return w.value(r); };
             return std::abs(integrate_radially<K::dim>(support, value, knots<F>()) - 1.0);
         }),
         .sabotaged = everywhere([]<class K, class F>() {
             return std::abs(integral_of_another_dimension<Kernel, K>() - 1.0);
         })});

    claims.push_back(
        {.id = name + ".value_to_the_last_places",
         .source = source,
         .says = "ω(r) agrees with a 50-digit evaluation of the printed formula; in last places of "
                 "ω(r)",
         .bound =
             at_most(4,
                     "what is promised of every kernel. Roundings are 2⁻⁵³ each, a last place is "
                     "2⁻⁵³ to 2⁻⁵² of ω: 4 that are not made up for always keep it, 8 where "
                     "they do not all fall on the same side"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             return worst_at_radii([&](double r) {
                 const Real50 exact = F::value(Real50(r), Real50(support));
                 return Comparison{w.value(r), exact,
                                   in_last_places(exact + size_of_cancelling_terms<F>())};
             });
         }),
         .sabotaged = everywhere([]<class K, class F>() {  // the formula typed in as it is printed
             return worst_at_radii([](double r) {
                 const Real50 exact = F::value(Real50(r), Real50(support));
                 return Comparison{F::value(r, support), exact, in_last_places(exact)};
             });
         })});

    claims.push_back(
        {.id = name + ".derivative",
         .source = source,
         .says = "ω′(r) agrees with a 50-digit evaluation; in units of 2⁻⁵² ω′(r)",
         .bound =
             at_most(16, "at most 32 roundings of 2⁻⁵³, those of 1 − q in powers up to 7 included"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             return worst_at_radii([&](double r) {
                 const Real50 exact = F::derivative(Real50(r), Real50(support));
                 return Comparison{w.derivative(r), exact, exact};
             });
         }),
         .sabotaged = everywhere([]<class K, class F>() {  // dω/dq: the chain rule's 1/h is lost
             const K w(support);
             return worst_at_radii([&](double r) {
                 const Real50 exact = F::derivative(Real50(r), Real50(support));
                 return Comparison{w.derivative(r) * support, exact, exact};
             });
         })});

    claims.push_back(
        {.id = name + ".second_derivative",
         .source = source,
         .says = "ω″(r) agrees with a 50-digit evaluation; in units of 2⁻⁵² of its peak, or of "
                 "ω″(r) if "
                 "that has no peak",
         .bound = at_most(16, "at most 32 roundings of 2⁻⁵³ on terms no larger than the peak"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             const Real50 peak = peak_of_second_derivative<F>();
             return worst_at_radii([&](double r) {
                 const Real50 exact = F::second_derivative(Real50(r), Real50(support));
                 return Comparison{w.second_derivative(r), exact, F::singular ? exact : peak};
             });
         }),
         .sabotaged = everywhere([]<class K, class F>() {
             const K w(support);
             const Real50 peak = peak_of_second_derivative<F>();
             return worst_at_radii([&](double r) {
                 const Real50 exact = F::second_derivative(Real50(r), Real50(support));
                 return Comparison{w.second_derivative(r) * support * support, exact,
                                   F::singular ? exact : peak};
             });
         })});

    claims.push_back(
        {.id = name + ".zero_outside",
         .source = source,
         .says = "ω, ω′, ω″ and Δω are 0 for every r ≥ support(), infinity included",
         .bound = at_most(0, "exactly: the distance to the rim is clamped to 0"),
         .measure = everywhere([]<class K, class F>() { return sum_outside(K(support), support); }),
         .sabotaged = everywhere([]<class K, class F>() {  // h read as half the support
             return sum_outside(K(2 * support), support);
         })});

    claims.push_back(
        {.id = name + ".never_negative_and_falls",
         .source = source,
         .says = "ω ≥ 0 and ω falls with r; radii where that fails, among 1000",
         .bound = at_most(0, "a count"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             return violations([&](double r) { return w.value(r); });
         }),
         // A kernel of higher order, with no second moment: negative outside (Sec. 2.1 warns of it).
         .sabotaged = everywhere([]<class K, class F>() {
             const K w(support);
             const double m2 = moment(w, 2), m4 = moment(w, 4);
             return violations([&](double r) { return w.value(r) * (m4 / m2 - r * r); });
         })});

    claims.push_back(
        {.id = name + ".tends_to_delta",
         .source = source,
         .says = "smoothing f = cos(k x) at x = 0 (Eq. 2) errs by −(m₂ h² / 2) Δf with the exact "
                 "second "
                 "moment m₂; relative deviation at k h = 0.1",
         .bound =
             at_most(0.01 / 12, "alternating series: next term (k h)² / (4 (dim + 2)) at most"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             const auto value = [&](double r) { return w.value(r); };
             return std::abs(smoothing_error_over_limit<K, F>(value) - 1.0);
         }),
         .sabotaged = everywhere([]<class K, class F>() {  // σ known to two digits
             const K w(support);
             const auto value = [&](double r) { return 1.01 * w.value(r); };
             return std::abs(smoothing_error_over_limit<K, F>(value) - 1.0);
         })});

    claims.push_back(
        {.id = name + ".gradient_moment",
         .source = source,
         .says = "∫ x ∇ωᵀ dV = −I: by parts, less the surface term where ω jumps at the rim",
         .bound = at_most(1e-11, "quadrature 1e-13 in each of up to 4 panels, of terms up to 10"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             return std::abs(trace_of_gradient_moment(w, knots<F>()) / K::dim + 1.0);
         }),
         .sabotaged = everywhere([]<class K, class F>() {  // the moment of −ω′ x without its 1/r
             const K w(support);
             const auto integrand = [&](double r) { return w.derivative(r) * r * r; };
             return std::abs(integrate_radially<K::dim>(support, integrand) / K::dim + 1.0);
         })});

    claims.push_back(
        {.id = name + ".rim_order",
         .source = source,
         .says =
             "ω ~ (h − r)ⁿ at the rim, so n − 1 derivatives are continuous there; |measured n − n|",
         .bound =
             at_most(0.01, "two distances, 1e-4 h and 2e-4 h: the other factors change by < 0.3 %"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             const double step = 1e-4 * support;
             const double ratio = w.value(support - 2 * step) / w.value(support - step);
             return std::abs(std::log2(ratio) - F::rim_order);
         }),
         .sabotaged = everywhere([]<class K, class F>() {  // one power of 1 − q is lost
             const K w(support);
             const double step = 1e-4 * support;
             const double ratio = w.value(support - 2 * step) / w.value(support - step) / 2;
             return std::abs(std::log2(ratio) - F::rim_order);
         })});

    claims.push_back(
        {.id = name + ".laplacian_obeys_gauss",
         .source = source,
         .says =
             "∫ Δω dV over a shell is the flux of ∇ω through its surfaces, for the true Laplacian "
             "ω″ + (dim − 1) ω′/r; printed (Eq. 11): ω″",
         .bound = at_most(1e-10, "quadrature 1e-13 of terms up to 100 σ / h²"),
         .measure = everywhere([]<class K, class F>() {
             const K w(support);
             return gauss_defect(w, [&](double r) { return laplacian(w, r); });
         }),
         .sabotaged = everywhere([]<class K, class F>() {
             const K w(support);
             return gauss_defect(w, [&](double r) { return w.second_derivative(r); });
         }),
         .erratum = 17});
    return claims;
}

}  // namespace verification
