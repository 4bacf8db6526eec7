#include "verification/kernels/kernel_claims.h"

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>

namespace verification {

namespace {
using Function = std::function<double(double)>;

constexpr double support = 0.7;  // not a power of two, nor 1: a lost power of h shows
constexpr double epsilon = 0x1p-52;

/// Two numbers of which one is compared with the other; `scale` turns the difference relative.
struct Comparison {
    double found;
    Real50 exact;
    Real50 scale;
};

/// The worst of measure(k) over all dimensions.
double worst_over(const std::vector<TestedKernel>& dimensions,
                  const std::function<double(const TestedKernel&)>& measure) {
    double worst = 0.0;
    for (const TestedKernel& k : dimensions)
        if (const double error = measure(k); !(error <= worst)) worst = error;  // NaN is the worst
    return worst;
}

/// The worst |found − exact| / scale, in units of 2⁻⁵², over 500 radii in the support.
double worst_at_radii(const std::function<Comparison(double)>& compare) {
    constexpr int n = 500;
    Real50 worst = 0;
    for (int k = 0; k < n; ++k) {
        const Comparison c = compare(support * (k + 0.5) / n);
        worst = std::max<Real50>(worst, abs((Real50(c.found) - c.exact) / c.scale));
    }
    return worst.convert_to<double>() / epsilon;
}

/// The scale that gives errors in last places of `number` instead of in units of 2⁻⁵².
Real50 in_last_places(const Real50& number) {
    const auto x = number.convert_to<double>();
    return Real50(std::nextafter(x, HUGE_VAL) - x) / epsilon;
}

Real50 peak_of_second_derivative(const PrintedKernel& printed) {
    Real50 peak = 0;
    for (int k = 0; k < 100; ++k)
        peak = std::max<Real50>(peak,
                                abs(printed.second_derivative(support * (k + 0.5) / 100, support)));
    return peak;
}

Real50 size_of_cancelling_terms(const TestedKernel& k) {
    return k.printed.size_of_cancelling_terms / pow(Real50(support), 2);
}

/// 1 − ∫ ω(x) cos(k x₁) dV over its limit m₂ k² / 2, with k h = 0.1 and m₂ the exact moment.
double smoothing_error_over_limit(const TestedKernel& tested, const Function& value) {
    constexpr double kh = 0.1, k = kh / support;
    const auto mean_cosine = [&](double z) {  // of cos(z n₁) over all directions n
        if (tested.dim == 1) return std::cos(z);
        if (tested.dim == 2) return gsl_sf_bessel_J0(z);
        return gsl_sf_bessel_j0(z);
    };
    const double smoothed = integrate_radially(
        tested.dim, support, [&](double r) { return value(r) * mean_cosine(k * r); },
        tested.printed.knots);
    const auto m2 = tested.printed.second_moment.convert_to<double>();
    return (1.0 - smoothed) / (m2 / 2 * kh * kh);
}

/// Radii where ω < 0 or ω grows, among 1000.
double violations(const Function& value) {
    int n = 0;
    for (int k = 1; k <= 1000; ++k) {
        const double inner = value(support * (k - 0.5) / 1000), outer = value(support * k / 1000);
        n += outer < 0.0 || outer > inner;
    }
    return n;
}

/// |ω| + |ω′| + |ω″| + |Δω| at and beyond `rim`.
double sum_outside(const KernelFunctions& w, double rim) {
    double total = 0.0;
    for (const double r : {rim, std::nextafter(rim, 1e9), 1.5 * rim, 1e3 * rim, HUGE_VAL})
        total += std::abs(w.value(r)) + std::abs(w.derivative(r)) +
                 std::abs(w.second_derivative(r)) + std::abs(w.laplacian(r));
    return total;
}

/// Trace of ∫ x ∇ωᵀ dV over all space: where ω jumps at the rim, ∇ω has a surface part there.
double trace_of_gradient_moment(const TestedKernel& k, const KernelFunctions& w) {
    const auto integrand = [&](double r) { return w.derivative(r) * r; };
    const double inside = integrate_radially(k.dim, support, integrand, k.printed.knots);
    return inside - w.value(std::nextafter(support, 0.0)) * support * sphere(k.dim, support);
}

/// ∫ g dV over the shell from h/10 to h, less the flux of ∇ω through its two surfaces (Gauss), both of
/// unit support.
double gauss_defect(int dim, const KernelFunctions& w, const Function& g) {
    const double a = 0.1 * support, inside = std::nextafter(support, 0.0);
    const double flux =
        sphere(dim, support) * w.derivative(inside) - sphere(dim, a) * w.derivative(a);
    const double source = integrate([&](double r) { return g(r) * sphere(dim, r); }, a, inside,
                                    {support / 3, support / 2, support * 2 / 3});
    return std::abs(source - flux) * support * support;
}
}  // namespace

std::vector<Claim> kernel_claims(const std::string& name, const Source& source,
                                 const std::vector<TestedKernel>& dimensions) {
    const auto everywhere = [&](std::function<double(const TestedKernel&)> measure) {
        return [dimensions, measure] { return worst_over(dimensions, measure); };
    };
    std::vector<Claim> claims;

    claims.push_back(
        {.id = name + ".integrates_to_one",
         .source = source,
         .says = "∫ ω dV = 1 (Eq. 8), in each dimension with its own σ",
         .bound = at_most(1e-12, "GSL's quadrature asked for 1e-13 in each of up to 4 panels"),
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return std::abs(integrate_radially(k.dim, support, w.value, k.printed.knots) - 1.0);
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {
             return std::abs(
                 integrate_radially(k.dim, support, k.of_another_dimension(support).value) - 1.0);
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
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return worst_at_radii([&](double r) {
                 const Real50 exact = k.printed.value(r, support);
                 return Comparison{w.value(r), exact,
                                   in_last_places(exact + size_of_cancelling_terms(k))};
             });
         }),
         .sabotaged =
             everywhere([](const TestedKernel& k) {  // the formula typed in as it is printed
                 return worst_at_radii([&](double r) {
                     const Real50 exact = k.printed.value(r, support);
                     return Comparison{k.printed.value_in_double(r, support), exact,
                                       in_last_places(exact)};
                 });
             })});

    claims.push_back(
        {.id = name + ".derivative",
         .source = source,
         .says = "ω′(r) agrees with a 50-digit evaluation; in units of 2⁻⁵² ω′(r)",
         .bound =
             at_most(16, "at most 32 roundings of 2⁻⁵³, those of 1 − q in powers up to 7 included"),
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return worst_at_radii([&](double r) {
                 const Real50 exact = k.printed.derivative(r, support);
                 return Comparison{w.derivative(r), exact, exact};
             });
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {  // dω/dq: the chain rule's 1/h is lost
             const KernelFunctions w = k.solver(support);
             return worst_at_radii([&](double r) {
                 const Real50 exact = k.printed.derivative(r, support);
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
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             const Real50 peak = peak_of_second_derivative(k.printed);
             return worst_at_radii([&](double r) {
                 const Real50 exact = k.printed.second_derivative(r, support);
                 return Comparison{w.second_derivative(r), exact,
                                   k.printed.singular ? exact : peak};
             });
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             const Real50 peak = peak_of_second_derivative(k.printed);
             return worst_at_radii([&](double r) {
                 const Real50 exact = k.printed.second_derivative(r, support);
                 return Comparison{w.second_derivative(r) * support * support, exact,
                                   k.printed.singular ? exact : peak};
             });
         })});

    claims.push_back(
        {.id = name + ".zero_outside",
         .source = source,
         .says = "ω, ω′, ω″ and Δω are 0 for every r ≥ support(), infinity included",
         .bound = at_most(0, "exactly: the distance to the rim is clamped to 0"),
         .measure = everywhere(
             [](const TestedKernel& k) { return sum_outside(k.solver(support), support); }),
         .sabotaged = everywhere([](const TestedKernel& k) {  // h read as half the support
             return sum_outside(k.solver(2 * support), support);
         })});

    claims.push_back(
        {.id = name + ".never_negative_and_falls",
         .source = source,
         .says = "ω ≥ 0 and ω falls with r; radii where that fails, among 1000",
         .bound = at_most(0, "a count"),
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return violations(w.value);
         }),
         // A kernel of higher order, with no second moment: negative outside (Sec. 2.1 warns of it).
         .sabotaged = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             const auto moment = [&](int p) {
                 const auto integrand = [&](double r) { return w.value(r) * std::pow(r, p); };
                 return integrate_radially(k.dim, support, integrand);
             };
             const double m2 = moment(2), m4 = moment(4);
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
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return std::abs(smoothing_error_over_limit(k, w.value) - 1.0);
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {  // σ known to two digits
             const KernelFunctions w = k.solver(support);
             const auto value = [&](double r) { return 1.01 * w.value(r); };
             return std::abs(smoothing_error_over_limit(k, value) - 1.0);
         })});

    claims.push_back(
        {.id = name + ".gradient_moment",
         .source = source,
         .says = "∫ x ∇ωᵀ dV = −I: by parts, less the surface term where ω jumps at the rim",
         .bound = at_most(1e-11, "quadrature 1e-13 in each of up to 4 panels, of terms up to 10"),
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return std::abs(trace_of_gradient_moment(k, w) / k.dim + 1.0);
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {  // the moment of −ω′ x without its 1/r
             const KernelFunctions w = k.solver(support);
             const auto integrand = [&](double r) { return w.derivative(r) * r * r; };
             return std::abs(integrate_radially(k.dim, support, integrand) / k.dim + 1.0);
         })});

    claims.push_back(
        {.id = name + ".rim_order",
         .source = source,
         .says =
             "ω ~ (h − r)ⁿ at the rim, so n − 1 derivatives are continuous there; |measured n − n|",
         .bound =
             at_most(0.01, "two distances, 1e-4 h and 2e-4 h: the other factors change by < 0.3 %"),
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             const double step = 1e-4 * support;
             const double ratio = w.value(support - 2 * step) / w.value(support - step);
             return std::abs(std::log2(ratio) - k.printed.rim_order);
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {  // one power of 1 − q is lost
             const KernelFunctions w = k.solver(support);
             const double step = 1e-4 * support;
             const double ratio = w.value(support - 2 * step) / w.value(support - step) / 2;
             return std::abs(std::log2(ratio) - k.printed.rim_order);
         })});

    claims.push_back(
        {.id = name + ".laplacian_obeys_gauss",
         .source = source,
         .says =
             "∫ Δω dV over a shell is the flux of ∇ω through its surfaces, for the true Laplacian "
             "ω″ + (dim − 1) ω′/r; printed (Eq. 11): ω″",
         .bound = at_most(1e-10, "quadrature 1e-13 of terms up to 100 σ / h²"),
         .measure = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return gauss_defect(k.dim, w, w.laplacian);
         }),
         .sabotaged = everywhere([](const TestedKernel& k) {
             const KernelFunctions w = k.solver(support);
             return gauss_defect(k.dim, w, w.second_derivative);
         }),
         .erratum = 17});
    return claims;
}

}  // namespace verification
