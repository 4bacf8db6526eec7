#include "verification/framework/study.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <stdexcept>

namespace verification {

namespace {
/// A floor counts as reached when it makes up more than half of the finest error.
constexpr double saturated_share = 0.5;

Verdict judge(const Study::Series& series, const PowerLaw& fit, double finest_error) {
    const bool saturated = fit.floor > saturated_share * finest_error;
    if (saturated) return series.saturates ? Verdict::verified : Verdict::saturated;
    if (series.order.holds(fit.confidence.low) && series.order.holds(fit.confidence.high))
        return series.saturates ? Verdict::failed : Verdict::verified;
    const bool disjoint =
        fit.confidence.high < series.order.low || fit.confidence.low > series.order.high;
    return disjoint ? Verdict::failed : Verdict::inconclusive;
}
}  // namespace

StudyResult run(const Study& study, Effort effort) {
    const auto start = std::chrono::steady_clock::now();
    StudyResult result{study, study.spacing, study.seeds, {}, 0, {}};
    if (effort == Effort::quick)
        result.spacing.resize(
            std::min(result.spacing.size(), static_cast<std::size_t>(study.quick_levels)));
    std::vector<SeriesResult> all;
    for (const Study::Series& s : study.series)
        all.push_back({s.name, s.order, s.saturates, {}, {}, Verdict::failed});
    try {
        for (const double spacing : result.spacing) {
            for (SeriesResult& s : all) s.errors.emplace_back();
            for (int seed = 1; seed <= study.seeds; ++seed) {
                const auto errors = study.errors(spacing, static_cast<std::uint64_t>(seed));
                if (errors.size() != all.size())
                    throw std::logic_error(study.id + ": one error per series expected");
                for (std::size_t k = 0; k < all.size(); ++k)
                    all[k].errors.back().push_back(errors[k]);
            }
        }
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k].fit = fit_power_law(result.spacing, all[k].errors);
            all[k].verdict = judge(study.series[k], all[k].fit, median(all[k].errors.back()));
        }
        result.series = std::move(all);
    } catch (const std::exception& e) {
        result.error = e.what();
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace verification
