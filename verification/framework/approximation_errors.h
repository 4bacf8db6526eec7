#pragma once

#include "verification/framework/sample_set.h"
#include "verification/framework/test_functions.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace verification {

enum class Quantity { value, gradient, laplacian };
enum class Norm { l2, max };

std::string_view name_of(Quantity quantity);
std::string_view unit_of(Quantity quantity);
std::string_view name_of(Norm norm);

/// A method for one quantity: {Quantity::gradient, "SPH Eq. 13"}.
struct Approximation {
    Quantity quantity;
    std::string_view method;
    auto operator<=>(const Approximation&) const = default;
};

/// A sample set with the test function sampled on it.
template <int Dim> struct SampledField {
    SampleSet<Dim> set;
    std::vector<double> f;

    explicit SampledField(const SampleSetup& setup) : set(setup) {
        for (const auto& x : set.x) f.push_back(TestFunction<Dim>::value(x));
    }
};

/// Methods that are measured together, because they share work.
template <int Dim> struct Family {
    std::span<const Approximation> approximations;
    /// Writes |approximated − exact| at sample i, one per approximation; NaN without an answer.
    void (*errors)(const SampledField<Dim>& field, plumbline::Index i, std::span<double> errors);
};
/// SPH Eqs. 3, 9, 11, 13, 15, 17, 19, Brookshaw's Laplacian, Shepard, Müller's gradient; and
/// "printed Eq. 15", whose ω″ is wrong on purpose (erratum 17).
template <int Dim> const Family<Dim>& sph_family();
/// MLS 0 to 3, MLSPH; and "printed Eqs. 29, 30", which is wrong on purpose (erratum 25).
template <int Dim> const Family<Dim>& mls_family();

/// Root mean square and maximum over the samples of `SampleSet::measured`; NaN if any is NaN.
struct ErrorNorms {
    double l2, max;
};
using ErrorTable = std::map<Approximation, ErrorNorms>;

/// Computed once per setup and family, and then kept: studies share it.
template <int Dim> const ErrorTable& errors_of(const SampleSetup& setup, const Family<Dim>& family);

}  // namespace verification
