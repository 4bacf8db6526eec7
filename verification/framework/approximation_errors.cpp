#include "verification/framework/approximation_errors.h"

#include "solver/foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

namespace verification {

namespace {
ErrorNorms norms_of(std::span<const double> errors) {
    double squares = 0, largest = 0;
    for (const double e : errors) {
        squares += e * e;
        largest = std::max(largest, e);
    }
    if (errors.empty() || std::isnan(squares))
        largest = squares = std::numeric_limits<double>::quiet_NaN();
    return {std::sqrt(squares / static_cast<double>(errors.size())), largest};
}

/// Not to be called by two threads at once. The sampled field of the last call is kept: methods are
/// measured one after the other.
template <int Dim> const SampledField<Dim>& field_of(const SampleSetup& setup) {
    static std::optional<std::pair<SampleSetup, SampledField<Dim>>> last;
    if (!last || last->first != setup) last.emplace(setup, SampledField<Dim>(setup));
    return last->second;
}

template <int Dim> const Method<Dim>& method_of(const Approximation& a) {
    for (const auto methods : {sph_methods<Dim>(), mls_methods<Dim>()})
        for (const Method<Dim>& method : methods)
            if (method.approximation == a) return method;
    throw std::logic_error("no method measures " + std::string(a.method));
}

template <int Dim> ErrorNorms measure(const SampleSetup& setup, const Approximation& a) {
    if (a.quantity != Quantity::value && setup.measured_at == MeasuredAt::between)
        throw std::logic_error("derivatives are measured at samples, not between them");
    const SampledField<Dim>& field = field_of<Dim>(setup);
    const Method<Dim>& method = method_of<Dim>(a);
    std::vector<double> errors(field.set.places.size());
    plumbline::parallel_for(errors.size(),
                            [&](std::size_t k) { errors[k] = method.error(Spot<Dim>(field, k)); });
    return norms_of(errors);
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

template <int Dim> ErrorNorms errors_of(const SampleSetup& setup, const Approximation& a) {
    static std::mutex mutex;
    static std::map<std::pair<SampleSetup, Approximation>, ErrorNorms> known;
    const std::lock_guard lock(mutex);
    const auto entry = known.find({setup, a});
    if (entry != known.end()) return entry->second;
    return known[{setup, a}] = measure<Dim>(setup, a);
}

template ErrorNorms errors_of<1>(const SampleSetup&, const Approximation&);
template ErrorNorms errors_of<2>(const SampleSetup&, const Approximation&);
template ErrorNorms errors_of<3>(const SampleSetup&, const Approximation&);

}  // namespace verification
