#include "reports/charts/study_chart.h"

#include "benchmarks/framework/figures.h"
#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reports {

using namespace verification;

namespace {
std::string order_of(const SeriesResult& s) {
    if (s.verdict == Verdict::verified && s.expected_saturation) return "saturates";
    return "order " + order_in_words(s.fit.order);
}

/// What the study found, in a sentence: who is the most exact at the finest level, by how much.
std::string finding(const StudyResult& result) {
    const SeriesResult *best = nullptr, *worst = nullptr;
    for (const SeriesResult& s : result.series) {
        if (s.sabotaged || s.fit.error.empty()) continue;
        if (!best || s.fit.error.back() < best->fit.error.back()) best = &s;
        if (!worst || s.fit.error.back() > worst->fit.error.back()) worst = &s;
    }
    if (!best) return "No method gave an answer";
    if (best == worst) return fmt::format("{} converges: {}", best->name, order_of(*best));
    return fmt::format(
        "{} ({}) ends {} times below {} ({})", best->name, order_of(*best),
        benchmarks::factor_in_words(worst->fit.error.back() / best->fit.error.back()), worst->name,
        order_of(*worst));
}

Chart::Series series_of(const SeriesResult& s, const std::vector<double>& spacing) {
    Chart::Series drawn;
    drawn.name = fmt::format("{}{}: {}", s.name, s.sabotaged ? " (sabotaged)" : "", order_of(s));
    drawn.x = spacing;
    for (const auto& level : s.errors) {
        drawn.y.push_back(median(level));
        const auto [low, high] = std::ranges::minmax(level);
        drawn.y_range.push_back({low, high});
    }
    return drawn;
}

std::vector<double> expected_orders(const StudyResult& result) {
    std::vector<double> orders;
    for (const SeriesResult& s : result.series) {
        if (s.expected_saturation || s.sabotaged) continue;
        const double order = std::round(0.5 * (s.expected_order.low + s.expected_order.high));
        if (std::isfinite(order) && order >= 1.0 && std::ranges::count(orders, order) == 0)
            orders.push_back(order);
    }
    return orders;
}
}  // namespace

Chart chart_of(const StudyResult& result) {
    Chart chart;
    chart.finding = finding(result);
    chart.x = {"spacing", "m", true};
    chart.y = {result.study.quantity, "", true};
    for (const SeriesResult& s : result.series)
        chart.series.push_back(series_of(s, result.spacing));
    chart.slopes = expected_orders(result);
    chart.caption = fmt::format(
        "{} ({} {}). {}.", result.study.says, name_of(result.study.source.paper),
        result.study.source.place,
        result.seeds == 1
            ? "Nothing is random: one run per level"
            : fmt::format("Medians of {} seeds, bars from the least to the largest", result.seeds));
    chart.alt = fmt::format("{} over spacing, {} series. {}.", result.study.quantity,
                            result.series.size(), chart.finding);
    chart.command = "plumbline converge " + result.study.id;
    return chart;
}

std::string file_name_of(const Study& study) {
    std::string name = study.id;
    std::ranges::replace(name, '/', '_');
    return name;
}

}  // namespace reports
