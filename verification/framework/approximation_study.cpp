#include "verification/framework/approximation_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verification {

namespace {
using Plan = ApproximationPlan;

bool grows(const Plan& plan) { return plan.conditions.support_exponent != 1.0; }

/// Spacings and supports. A cubic basis needs four samples in a row: one-sidedly, at the boundary of a
/// lattice, supports longer than three spacings, on a disordered line four, and not at half spacings,
/// where rounding decides what is near; in the interior less is enough, and leaves more of the error to
/// the disorder, which is asked for. At 2.8 spacings in the plane and 2.5 in space the lattice sums of
/// Eq. 13 are 3 % off, so that the floor they leave is seen. Boundaries need finer levels, where they can be had: the next term
/// of the error is one order of h below there, two inside. Growing supports start so long that the
/// largest basis has more than twice as many neighbours as it needs.
struct Levels {
    std::vector<double> per_metre;
    double support_in_spacings;  // at the first level
};
constexpr int quick_levels = 5;

Levels levels_of(const Plan& plan) {
    const int dim = plan.conditions.dim;
    const bool boundary = plan.conditions.region == Region::boundary;
    if (grows(plan)) {
        if (dim == 3) return {{8, 10, 13, 17, 22, 28}, 2.8};
        if (boundary) return {{80, 120, 180, 270, 400, 600}, 4.2};
        return {{40, 60, 85, 125, 180, 270}, 3.0};
    }
    if (dim == 3) return {{10, 13, 17, 22, 28, 36}, boundary ? 3.6 : 2.5};
    if (boundary) return {{60, 95, 150, 240, 380, 600}, dim == 1 ? 4.6 : 3.6};
    return {{50, 80, 130, 210, 340, 550}, 2.8};
}

/// One curve, and where its errors come from.
struct Curve {
    Study::Series series;
    Approximation data;
    bool fixed_support = false;  // instead of the plan's
    MeasuredAt measured_at;
    StudyKernel kernel = StudyKernel::poly6;
};

/// σ² = ∫ x₀² ω dV of a kernel in the plane with the support 1: h² σ² Δf / 2 is the smoothing error.
double variance(StudyKernel kernel) {
    const AnyKernel<2> w = kernel_of<2>(kernel, 1.0);
    constexpr int n = 1000;
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
        const double r = (k + 0.5) / n;
        sum += std::numbers::pi * r * r * r * w.value(r) / n;
    }
    return sum;
}

/// Kernels are compared at equal variance: equal smoothing, whatever their support.
double support_factor(StudyKernel kernel) {
    if (kernel == StudyKernel::poly6) return 1.0;
    return std::sqrt(variance(StudyKernel::poly6) / variance(kernel));
}

double support_of(const Plan& plan, const Curve& curve, double spacing) {
    const Levels levels = levels_of(plan);
    const double factor = levels.support_in_spacings * support_factor(curve.kernel);
    if (curve.fixed_support) return factor * spacing;
    const double coarsest = 1.0 / levels.per_metre.front();
    return factor * coarsest * std::pow(spacing / coarsest, plan.conditions.support_exponent);
}

/// What must fail: the printed forms, and other mistakes, under the bound of the method they spoil.
std::vector<Curve> sabotaged(const Plan& plan) {
    const Conditions& c = plan.conditions;
    const auto spoiled = [&](std::string name, std::string_view method, std::string_view data,
                             bool fixed_support = false) {
        Study::Series series = expected_order({plan.quantity, method}, c);
        series.name = std::move(name);
        series.sabotaged = true;
        return Curve{series, {plan.quantity, data}, fixed_support, c.measured_at};
    };
    const bool boundary = c.region == Region::boundary;
    const bool disordered = c.sampling != Sampling::lattice && !boundary;
    std::vector<Curve> curves;
    if (plan.quantity == Quantity::value) {
        if (grows(plan) && disordered)
            curves.push_back(spoiled("SPH Eq. 3, h/spacing fixed", "SPH Eq. 3", "SPH Eq. 3", true));
        curves.push_back(spoiled("MLS 2, M lumped to its diagonal", "MLS 2", "MLS 0"));
        if (!grows(plan)) {
            curves.push_back(spoiled("Shepard without its quotient", "Shepard", "SPH Eq. 3"));
            if (boundary) curves.push_back(spoiled("MLS 3 without cubics", "MLS 3", "MLS 2"));
        }
    }
    if (plan.quantity == Quantity::gradient) {
        if (grows(plan) && disordered)
            curves.push_back(spoiled("SPH Eq. 9, h/spacing fixed", "SPH Eq. 9", "SPH Eq. 9", true));
        curves.push_back(spoiled("MLS 2, Eqs. 29, 30 as printed", "MLS 2", "printed Eqs. 29, 30"));
        // In space the rim is nearly all of the box at first: its shrinking share hides the floor.
        const bool rim_is_thin = boundary && c.dim == 2;
        if (!grows(plan) && c.dim > 1 && (disordered || rim_is_thin))
            curves.push_back(spoiled("Mueller, A a number", "Mueller", "Mueller, A a number"));
    }
    if (plan.quantity == Quantity::laplacian) {
        if (grows(plan) && !boundary)
            curves.push_back(spoiled("SPH Eq. 15 as printed", "SPH Eq. 15", "printed Eq. 15"));
        curves.push_back(spoiled("MLS 2, for it Eq. 15 as printed", "MLS 2", "printed Eq. 15"));
    }
    return curves;
}

/// On a lattice Eq. 3 is of second order at its points only.
std::vector<Curve> at_samples(const Plan& plan) {
    Conditions c = plan.conditions;
    if (plan.quantity != Quantity::value || c.sampling != Sampling::lattice ||
        c.region == Region::boundary)
        return {};
    c.measured_at = MeasuredAt::samples;
    const Approximation eq_3{Quantity::value, "SPH Eq. 3"};
    Curve curve{expected_order(eq_3, c), eq_3, false, c.measured_at};
    curve.series.name += " at the samples";
    return {curve};
}

/// The floor of Eq. 3 between the points of a lattice in space, 1e-3 (lattice_floor.cpp), is below the
/// smoothing error of all levels here: neither of them would be seen alone.
bool is_below_smoothing(const Conditions& c, const Approximation& a) {
    return c.dim == 3 && c.sampling == Sampling::lattice && c.region == Region::interior &&
           c.measured_at == MeasuredAt::between && a.method == "SPH Eq. 3";
}

bool is_among_kernels(const Approximation& a) {
    static constexpr std::string_view chosen[] = {"SPH Eq. 3", "Shepard", "SPH Eq. 9", "SPH Eq. 13",
                                                  "Mueller",   "MLS 1",   "MLS 2"};
    return std::ranges::find(chosen, a.method) != std::end(chosen);
}

template <int Dim> std::vector<Curve> curves_of(const Plan& plan) {
    std::vector<Curve> curves;
    const auto add = [&](const Method<Dim>& method, StudyKernel kernel) {
        const Approximation& a = method.approximation;
        if (a.quantity != plan.quantity || method.wrong_on_purpose) return;
        if (is_below_smoothing(plan.conditions, a)) return;
        if (plan.all_kernels && !is_among_kernels(a)) return;
        Curve curve{expected_order(a, plan.conditions), a, false, plan.conditions.measured_at,
                    kernel};
        if (plan.all_kernels) curve.series.name += ", " + std::string(name_of(kernel));
        curves.push_back(std::move(curve));
    };
    for (const StudyKernel kernel :
         {StudyKernel::poly6, StudyKernel::wendland_c4, StudyKernel::quintic_spline}) {
        if (kernel != StudyKernel::poly6 && !plan.all_kernels) break;
        for (const auto methods : {sph_methods<Dim>(), mls_methods<Dim>()})
            for (const Method<Dim>& method : methods) add(method, kernel);
    }
    for (Curve& curve : sabotaged(plan)) curves.push_back(std::move(curve));
    for (Curve& curve : at_samples(plan)) curves.push_back(std::move(curve));
    return curves;
}

template <int Dim>
double error_of(const Plan& plan, const Curve& curve, double spacing, std::uint64_t seed) {
    const Conditions& c = plan.conditions;
    const SampleSetup setup{
        c.sampling, c.region,          spacing,     support_of(plan, curve, spacing),
        seed,       curve.measured_at, curve.kernel};
    const ErrorNorms norms = errors_of<Dim>(setup, curve.data);
    return c.norm == Norm::l2 ? norms.l2 : norms.max;
}

std::string text(std::string_view s) { return std::string(s); }

std::string id_of(const Plan& plan) {
    const Conditions& c = plan.conditions;
    const bool boundary = c.region == Region::boundary;
    std::string where = text(name_of(c.region));
    if (grows(plan)) where = boundary ? "boundary_growing_support" : "growing_support";
    return "convergence." + text(name_of(plan.quantity)) + "_" + std::to_string(c.dim) + "d_" +
           text(name_of(c.sampling)) + "_" + where + (c.norm == Norm::max ? "_max" : "") +
           (plan.all_kernels ? "_of_kernels" : "");
}

Source source_of(const Plan& plan) {
    switch (plan.quantity) {
        case Quantity::value:
            return {Paper::adams2009, "Eqs. 3, 26; Sec. 2.1, 3.1, 4"};
        case Quantity::gradient:
            return {Paper::adams2009, "Eqs. 9, 13, 17, 19, 32, 37; Sec. 2.2, 3.2, 4"};
        case Quantity::laplacian:
            return {Paper::adams2009, "Eqs. 11, 15, 34; Sec. 2.2, 3.2, 4"};
    }
    return {};
}

std::string says(const Plan& plan) {
    const Conditions& c = plan.conditions;
    const bool boundary = c.region == Region::boundary;
    const std::string where = boundary ? "at the boundary of " : "inside ";
    const std::string samples =
        text(name_of(plan.quantity)) +
        (c.measured_at == MeasuredAt::between ? " between samples, " : " at samples, ") + where +
        text(name_of(c.sampling)) + " samples, " + std::to_string(c.dim) + "D: ";
    if (plan.all_kernels)
        return samples +
               "the order follows from the method, not from the kernel; kernels of equal "
               "variance";
    if (grows(plan))
        return samples + "if the support grows against the spacing, h ~ spacing^" +
               (c.support_exponent == 0.5 ? "(1/2)" : "(1/3)") +
               (boundary ? ", MLS converges; SPH, whose sums are cut off, does not"
                         : ", SPH converges, and MLS no faster than h allows");
    return samples +
           "at fixed h/spacing the order of MLS follows from its degree; SPH, which "
           "reproduces none, keeps an error or diverges";
}

/// Seeds of the disordered samples: on a line, at its two ends above all, few places share one.
int seeds_of(const Conditions& c) {
    if (c.sampling == Sampling::lattice) return 1;
    return c.dim == 1 ? 20 : 5;
}

template <int Dim> Study study_in(const Plan& plan) {
    const std::vector<Curve> curves = curves_of<Dim>(plan);
    Study study{.id = id_of(plan),
                .source = source_of(plan),
                .says = says(plan),
                .quantity = text(name_of(plan.quantity)) + " error, " +
                            text(name_of(plan.conditions.norm)) + " [" +
                            text(unit_of(plan.quantity)) + "]",
                .spacing = {},
                .quick_levels = quick_levels,
                .seeds = seeds_of(plan.conditions),
                .series = {},
                .errors = [plan, curves](double spacing, std::uint64_t seed) {
                    std::vector<double> errors;
                    for (const Curve& curve : curves)
                        errors.push_back(error_of<Dim>(plan, curve, spacing, seed));
                    return errors;
                }};
    for (const double n : levels_of(plan).per_metre) study.spacing.push_back(1.0 / n);
    for (const Curve& curve : curves) study.series.push_back(curve.series);
    return study;
}
}  // namespace

Study study_of(ApproximationPlan plan) {
    if (plan.quantity == Quantity::value) plan.conditions.measured_at = MeasuredAt::between;
    switch (plan.conditions.dim) {
        case 1:
            return study_in<1>(plan);
        case 2:
            return study_in<2>(plan);
        default:
            return study_in<3>(plan);
    }
}

}  // namespace verification
