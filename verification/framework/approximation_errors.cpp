#include "verification/framework/approximation_errors.h"

#include "solver/foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

namespace verification {

namespace {
ErrorNorms norms_of(std::span<const double> errors, std::size_t first, std::size_t stride) {
    double squares = 0, largest = 0;
    std::size_t n = 0;
    for (std::size_t k = first; k < errors.size(); k += stride, ++n) {
        squares += errors[k] * errors[k];
        largest = std::max(largest, errors[k]);
    }
    if (n == 0 || std::isnan(squares)) largest = squares = std::numeric_limits<double>::quiet_NaN();
    return {std::sqrt(squares / static_cast<double>(n)), largest};
}

/// Not to be called by two threads at once. The sampled field of the last call is kept: families are measured one after the other.
template <int Dim> const SampledField<Dim>& field_of(const SampleSetup& setup) {
    static std::optional<std::pair<SampleSetup, SampledField<Dim>>> last;
    if (!last || last->first != setup) last.emplace(setup, SampledField<Dim>(setup));
    return last->second;
}

template <int Dim> ErrorTable measure(const SampleSetup& setup, const Family<Dim>& family) {
    const SampledField<Dim>& field = field_of<Dim>(setup);
    const std::size_t width = family.approximations.size(), n = field.set.measured.size();
    std::vector<double> errors(n * width);
    plumbline::parallel_for(n, [&](std::size_t k) {
        family.errors(field, field.set.measured[k], std::span(errors).subspan(k * width, width));
    });
    ErrorTable table;
    for (std::size_t a = 0; a < width; ++a)
        table[family.approximations[a]] = norms_of(errors, a, width);
    return table;
}
}  // namespace

std::string_view name_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::value:
            return "value";
        case Quantity::gradient:
            return "gradient";
        case Quantity::laplacian:
            return "laplacian";
    }
    return "";
}
std::string_view unit_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::value:
            return "1";
        case Quantity::gradient:
            return "1/m";
        case Quantity::laplacian:
            return "1/m²";
    }
    return "";
}
std::string_view name_of(Norm norm) { return norm == Norm::l2 ? "L2" : "max"; }

template <int Dim>
const ErrorTable& errors_of(const SampleSetup& setup, const Family<Dim>& family) {
    static std::mutex mutex;
    static std::map<std::pair<SampleSetup, const void*>, ErrorTable> known;
    const std::lock_guard lock(mutex);
    const auto [entry, is_new] = known.try_emplace({setup, family.approximations.data()});
    if (is_new) entry->second = measure(setup, family);
    return entry->second;
}

template const ErrorTable& errors_of(const SampleSetup&, const Family<2>&);
template const ErrorTable& errors_of(const SampleSetup&, const Family<3>&);

}  // namespace verification
