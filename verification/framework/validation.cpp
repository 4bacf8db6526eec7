#include "verification/framework/validation.h"

#include "solver/foundation/errors.h"

#include <algorithm>
#include <stdexcept>

namespace verification {

namespace {
std::vector<Validation>& registered() {
    static std::vector<Validation> all;
    return all;
}

/// y of the curve at x, between its samples; NaN outside of it.
double at(const Curve& curve, double x) {
    const auto above = std::ranges::lower_bound(curve.x, x);
    if (above == curve.x.end()) return NAN;
    const auto k = static_cast<std::size_t>(above - curve.x.begin());
    if (*above == x) return curve.y[k];
    if (k == 0) return NAN;
    return std::lerp(curve.y[k - 1], curve.y[k],
                     (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]));
}

/// The order p of three values, the finest first: with e₂₁ = S₂ − S₁ and e₃₂ = S₃ − S₂ of one sign, the ratio
/// e₃₂/e₂₁ grows with p.
double order_of(double e21, double e32, double r21, double r32) {
    const auto ratio = [&](double p) {
        return std::pow(r21, p) * (std::pow(r32, p) - 1.0) / (std::pow(r21, p) - 1.0);
    };
    double low = 1e-3, high = 20.0;
    while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (ratio(middle) < e32 / e21 ? low : high) = middle;
    }
    return low;
}

QuantityResult judge(const Validation& v, std::size_t q, const std::vector<double>& spacing,
                     const std::vector<Validation::Observation>& observed) {
    QuantityResult r{v.quantities[q], {}, NAN, NAN, NAN, Agreement::inconclusive, false};
    for (const auto& o : observed) r.simulated.push_back(o.quantities.at(q));
    const double measured = r.quantity.measured;
    r.error = r.simulated.back() - measured;
    r.u_num = numerical_uncertainty(spacing, r.simulated, v.formal_order);
    r.u_val = std::hypot(r.u_num, r.quantity.u_input, r.quantity.u_data);
    r.reaches_goal = r.quantity.goal.holds(r.error / std::abs(measured));
    if (std::isfinite(r.error) && r.u_val <= std::abs(measured))
        r.agreement = std::abs(r.error) <= r.u_val ? Agreement::agrees : Agreement::differs;
    return r;
}

PanelResult judge(const Validation::Panel& panel, std::vector<Curve> curves) {
    PanelResult r{panel, std::move(curves), NAN, {}, false};
    const Curve& data = panel.measured;
    double squares = 0.0;
    std::size_t samples = 0, inside = 0;
    for (std::size_t k = 0; k < data.x.size(); ++k) {
        const double simulated = at(r.curves.back(), data.x[k]);
        if (std::isnan(simulated)) continue;
        ++samples;
        squares += (simulated - data.y[k]) * (simulated - data.y[k]);
        if (!panel.low.empty())
            inside += simulated >= panel.low[k] && simulated <= panel.high[k] ? 1 : 0;
    }
    if (samples == 0) return r;
    const auto [least, most] = std::ranges::minmax(data.y);
    r.deviation = std::sqrt(squares / static_cast<double>(samples)) / (most - least);
    if (!panel.low.empty())
        r.inside_band = static_cast<double>(inside) / static_cast<double>(samples);
    r.reaches_goal = !r.inside_band || panel.goal.holds(*r.inside_band);
    return r;
}

void check(const Validation& v, const std::vector<double>& spacing,
           const std::vector<Validation::Observation>& observed) {
    bool fits = observed.size() == spacing.size() && !observed.empty();
    for (const auto& o : observed)
        fits = fits && o.quantities.size() == v.quantities.size() &&
               o.curves.size() == v.panels.size();
    if (!fits)
        throw plumbline::InvalidInput("validation " + v.id +
                                      ": expected for each level one number per quantity and one "
                                      "curve per panel");
}
}  // namespace

std::string_view name_of(Agreement agreement) {
    switch (agreement) {
        case Agreement::agrees:
            return "agrees";
        case Agreement::differs:
            return "differs";
        case Agreement::inconclusive:
            return "inconclusive";
    }
    return "";
}

double numerical_uncertainty(const std::vector<double>& spacing, const std::vector<double>& values,
                             double formal_order) {
    const bool whole = std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
    if (values.size() < 3 || !whole) return NAN;
    const std::size_t n = values.size();
    const double e21 = values[n - 2] - values[n - 1], e32 = values[n - 3] - values[n - 2];
    if (e21 == 0.0 && e32 == 0.0) return 0.0;
    if (e21 * e32 <= 0.0) {
        const auto [low, high] = std::ranges::minmax(values);
        return 3.0 * 0.5 * (high - low);
    }
    const double r21 = spacing[n - 2] / spacing[n - 1], r32 = spacing[n - 3] / spacing[n - 2];
    const double p = order_of(e21, e32, r21, r32);
    const double safety = p >= 0.5 && p <= 2.0 * formal_order ? 1.25 : 3.0;
    return safety * std::abs(e21) / (std::pow(r21, std::clamp(p, 0.5, formal_order)) - 1.0);
}

std::vector<double> levels_of(const Validation& v, Effort effort) {
    const auto levels = effort == Effort::quick ? v.quick_levels : std::ssize(v.spacing);
    return {v.spacing.begin(), v.spacing.begin() + levels};
}

ValidationResult judge(const Validation& v, const std::vector<double>& spacing,
                       const std::vector<Validation::Observation>& observed) {
    check(v, spacing, observed);
    ValidationResult result{v, spacing, {}, {}};
    for (std::size_t q = 0; q < v.quantities.size(); ++q)
        result.quantities.push_back(judge(v, q, spacing, observed));
    for (std::size_t p = 0; p < v.panels.size(); ++p) {
        std::vector<Curve> curves;
        for (const auto& o : observed) curves.push_back(o.curves[p]);
        result.panels.push_back(judge(v.panels[p], std::move(curves)));
    }
    return result;
}

const std::vector<Validation>& validations() {
    static const std::vector<Validation> all = [] {
        std::vector<Validation> sorted = registered();
        std::ranges::stable_sort(sorted, {}, &Validation::id);
        const auto twice = std::ranges::adjacent_find(sorted, {}, &Validation::id);
        if (twice != sorted.end()) throw std::logic_error("registered twice: " + twice->id);
        return sorted;
    }();
    return all;
}
RegisterValidation::RegisterValidation(Validation validation) {
    registered().push_back(std::move(validation));
}

}  // namespace verification
