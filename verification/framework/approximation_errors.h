#pragma once

#include "verification/framework/sample_set.h"
#include "verification/framework/test_functions.h"

#include <limits>
#include <optional>
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
    auto operator<=>(const Approximation&) const = default;  // NOLINT(modernize-use-nullptr): its 0
};

/// A sample set with the test function sampled on it.
template <int Dim> struct SampledField {
    SampleSet<Dim> set;
    std::vector<double> f;

    explicit SampledField(const SampleSetup& setup) : set(setup) {
        for (const auto& x : set.x) f.push_back(TestFunction<Dim>::value(x));
    }
};

/// The k-th place of a field as the methods want it, and how far what they find is from the truth: NaN
/// if they find nothing.
template <int Dim> struct Spot {
    using Vec = plumbline::Vec<Dim>;
    const AnyKernel<Dim>& w;
    plumbline::Samples<Dim> s;
    std::span<const double> f, m, rho;
    plumbline::Place<Dim> at;
    plumbline::Index i;  // the sample that the place is, if it is one

    Spot(const SampledField<Dim>& field, std::size_t k)
        : w{field.set.kernel},
          s{field.set.samples()},
          f{field.f},
          m{field.set.m},
          rho{field.set.rho},
          at{field.set.place(k)},
          i{field.set.measured.empty() ? std::numeric_limits<plumbline::Index>::max()
                                       : field.set.measured[k]} {}

    double value_error(const std::optional<double>& found) const {
        return found ? std::abs(*found - TestFunction<Dim>::value(at.x)) : no_answer;
    }
    double gradient_error(const std::optional<Vec>& found) const {
        return found ? (*found - TestFunction<Dim>::gradient(at.x)).norm() : no_answer;
    }
    double laplacian_error(const std::optional<double>& found) const {
        return found ? std::abs(*found - TestFunction<Dim>::laplacian(at.x)) : no_answer;
    }

private:
    static constexpr double no_answer = std::numeric_limits<double>::quiet_NaN();
};

/// Values are found at any place, derivatives at samples.
template <int Dim> struct Method {
    Approximation approximation;
    double (*error)(const Spot<Dim>& spot);
    bool wrong_on_purpose = false;
};
/// SPH Eqs. 3, 9, 11, 13, 15, 17, 19, Brookshaw's Laplacian, Shepard, Müller's gradient. Wrong on purpose:
/// "printed Eq. 15" with ω″ for Δω (erratum 17); "Mueller, A a number", whose A is tr A / Dim.
template <int Dim> std::span<const Method<Dim>> sph_methods();
/// MLS 0 to 3, MLSPH. Wrong on purpose: "printed Eqs. 29, 30" (erratum 25).
template <int Dim> std::span<const Method<Dim>> mls_methods();

/// Root mean square and maximum over the places; NaN if any is NaN.
struct ErrorNorms {
    double l2, max;
};

/// Computed once per setup and approximation, and then kept: studies share it. Throws std::logic_error
/// if there is no such method, and for a derivative between samples.
template <int Dim> ErrorNorms errors_of(const SampleSetup& setup, const Approximation& a);

}  // namespace verification
