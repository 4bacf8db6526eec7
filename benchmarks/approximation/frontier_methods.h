#pragma once

#include "solver/kernels/cubic_spline.h"
#include "solver/kernels/kernel_list.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/wendland_c4.h"
#include "solver/neighbours/neighbour_lists.h"
#include "verification/framework/approximation_errors.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace benchmarks {

/// The kernels that the frontier compares; a few, since every method is compiled for each.
using FrontierKernels =
    plumbline::KernelList<plumbline::Poly6, plumbline::CubicSpline, plumbline::WendlandC4>;

/// Franke's function on jittered samples, and the places where it is approximated, in the unit square,
/// far from the boundary of the samples. Derivatives are taken at samples, since some forms exist
/// nowhere else; values in between, at Halton points: at a sample with few neighbours every method
/// that can hardly do anything but return the sample would look accurate.
struct Situation {
    std::string kernel;
    double spacing, support;  // [m]
    plumbline::Points<2> x;
    std::vector<double> m, rho, V, f;
    plumbline::NeighbourLists neighbours;  // of all samples
    plumbline::Points<2> places;
    plumbline::NeighbourLists rows;          // of the places
    std::vector<plumbline::Index> measured;  // the places as samples; empty if they are none

    Situation(verification::Quantity quantity, std::string kernel, double support_in_spacings,
              int samples_per_metre, std::size_t most_places);
    plumbline::Samples<2> samples() const { return {x, V, neighbours}; }
};

/// Doubles per place: 2 for a gradient, 1 otherwise.
int components_of(verification::Quantity quantity);

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

std::vector<PreparedMethod> sph_methods(const Situation& s, verification::Quantity quantity);
std::vector<PreparedMethod> mls_methods(const Situation& s, verification::Quantity quantity);

/// A plain double or vector, or an optional one; returns 1 if it is empty.
template <class T> std::size_t write(const T& answer, double* to) {
    if constexpr (requires { answer.has_value(); }) {
        if (answer) return write(*answer, to);
        using Value = typename T::value_type;
        if constexpr (std::is_same_v<Value, double>)
            *to = std::numeric_limits<double>::quiet_NaN();
        else
            to[0] = to[1] = std::numeric_limits<double>::quiet_NaN();
        return 1;
    } else if constexpr (std::is_same_v<T, double>) {
        *to = answer;
        return 0;
    } else {
        to[0] = answer[0];
        to[1] = answer[1];
        return 0;
    }
}

}  // namespace benchmarks
