#pragma once

#include "solver/neighbours/neighbour_lists.h"
#include "verification/framework/approximation_errors.h"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace benchmarks {

/// What an Eulerian step costs beside the method [s per sample].
struct SampleCosts {
    double search_s, volumes_s;
};

/// The test function of the dimension (Franke's in the plane, plane waves in space) on jittered samples,
/// and the places where it is approximated, in the unit box, far from the boundary of the samples. Derivatives are taken at samples, since some forms exist
/// nowhere else; values in between, at Halton points: at a sample with few neighbours every method
/// that can hardly do anything but return the sample would look accurate.
template <int Dim> struct Situation {
    std::string kernel;
    double support_in_spacings;
    double spacing, support;  // [m]
    plumbline::Points<Dim> x;
    std::vector<double> m, f;
    /// NaN farther than a support from the unit box, where no place feels it, and of a kernel that is infinite
    /// at 0, which has no density.
    std::vector<double> rho, V;
    plumbline::NeighbourLists neighbours;  // a row for each sample, empty unless it is measured
    plumbline::Points<Dim> places;
    plumbline::NeighbourLists rows;          // of the places
    std::vector<plumbline::Index> measured;  // the places as samples; empty if they are none

    Situation(verification::Quantity quantity, std::string kernel_name, double h_over_spacing,
              int samples_per_metre, std::size_t most_places);
    /// Medians of `rounds`, of finding neighbours and of summing densities anew, for so many of the samples
    /// around the centre that their lists fit into memory.
    SampleCosts sample_costs(int rounds) const;
    plumbline::Samples<Dim> samples() const { return {x, V, neighbours}; }
};

/// Doubles per place: those of a vector for a gradient, 1 otherwise.
template <int Dim> constexpr std::size_t components_of(verification::Quantity quantity) {
    return quantity == verification::Quantity::gradient ? Dim : 1;
}

/// One method on one situation, which must outlive it. What is wanted is written place by place, NaN
/// where there is no answer.
struct PreparedMethod {
    std::string name;
    bool reads_volumes;
    /// Eulerian use: everything anew. Returns at how many places the method failed: no answer, or a
    /// singular moment matrix, unless falling back is what the method does.
    std::function<std::size_t(std::span<double>)> evaluate;
    /// Lagrangian use: shape functions once, then dot products; empty where the form has none.
    std::function<void()> precompute = {};
    std::function<void(std::span<double>)> apply = {};
};

template <int Dim>
std::vector<PreparedMethod> sph_methods(const Situation<Dim>& s, verification::Quantity quantity);
/// Those of sph_methods for the gradient, and Müller's.
template <int Dim> std::vector<PreparedMethod> sph_gradients(const Situation<Dim>& s);
template <int Dim>
std::vector<PreparedMethod> mls_methods(const Situation<Dim>& s, verification::Quantity quantity);

// One answer, to where it belongs; returns how many are missing: 1 if it is empty, NaN then.
inline std::size_t write(double answer, double* to) {
    *to = answer;
    return 0;
}
template <int Dim> std::size_t write(const plumbline::Vec<Dim>& answer, double* to) {
    for (int d = 0; d < Dim; ++d) to[d] = answer[d];
    return 0;
}
template <class T> std::size_t write(const std::optional<T>& answer, double* to) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (answer) return write(*answer, to);
    if constexpr (std::is_same_v<T, double>)
        write(none, to);
    else
        write(T(T::Constant(none)), to);
    return 1;
}

}  // namespace benchmarks
