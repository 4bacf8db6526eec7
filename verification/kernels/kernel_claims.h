#pragma once

#include "solver/kernels/kernel.h"
#include "verification/framework/claim.h"
#include "verification/framework/oracle.h"
#include "verification/kernels/radial.h"
#include "verification/kernels/under_test.h"

#include <concepts>

namespace verification {

/// A kernel as its publication prints it, with d = r and any number type: the truth that the solver's
/// own form of it is measured against. Independent of the solver's code.
template <class F>
concept KernelFormula = requires(Real50 d, Real50 h) {
    { F::value(d, h) } -> std::convertible_to<Real50>;
    { F::derivative(d, h) } -> std::convertible_to<Real50>;
    { F::second_derivative(d, h) } -> std::convertible_to<Real50>;
    { F::second_moment() } -> std::convertible_to<Real50>;  // ∫ ω x² dV of one axis, h = 1
    { F::rim_order } -> std::convertible_to<int>;           // ω ~ (h − r)^rim_order at the rim
    { F::singular } -> std::convertible_to<bool>;           // at r = 0
};

/// A kernel of one support, each function over the distance r.
struct KernelFunctions {
    std::function<double(double)> value, derivative, second_derivative, laplacian;
};

/// A KernelFormula, with functions of (d, h).
struct PrintedKernel {
    std::function<Real50(const Real50&, const Real50&)> value, derivative, second_derivative;
    std::function<double(double, double)> value_in_double;
    Real50 second_moment;
    /// What the error of ω is also measured against where its docstring admits that terms cancel;
    /// times h².
    Real50 size_of_cancelling_terms;
    int rim_order;
    bool singular;
    std::vector<double> knots;
};

/// The kernel of one dimension, as the solver has it and as it is printed.
struct TestedKernel {
    int dim;
    std::function<KernelFunctions(double h)> solver, of_another_dimension;
    PrintedKernel printed;
};

template <plumbline::RadialKernel K> KernelFunctions functions_of(const K& w) {
    return {[w](double r) { return w.value(r); }, [w](double r) { return w.derivative(r); },
            [w](double r) { return w.second_derivative(r); },
            [w](double r) { return laplacian(w, r); }};
}

template <KernelFormula F> PrintedKernel printed_kernel() {
    using Real = const Real50&;
    PrintedKernel printed{[](Real d, Real h) { return Real50(F::value(d, h)); },
                          [](Real d, Real h) { return Real50(F::derivative(d, h)); },
                          [](Real d, Real h) { return Real50(F::second_derivative(d, h)); },
                          [](double d, double h) { return double(F::value(d, h)); },
                          F::second_moment(),
                          0,
                          F::rim_order,
                          F::singular,
                          knots<F>()};
    if constexpr (requires { F::size_of_cancelling_terms(); })
        printed.size_of_cancelling_terms = F::size_of_cancelling_terms();
    return printed;
}

template <template <int> class Kernel, template <int> class Formula, int Dim>
TestedKernel tested_kernel() {
    constexpr int other = Dim == 3 ? 2 : 3;
    return {Dim, [](double h) { return functions_of(UnderTest<Kernel<Dim>>(h)); },
            [](double h) { return functions_of(Kernel<other>(h)); },
            printed_kernel<Formula<Dim>>()};
}

/// What every kernel has to fulfil, measured in every dimension where it exists; the worst counts.
std::vector<Claim> kernel_claims(const std::string& name, const Source& source,
                                 const std::vector<TestedKernel>& dimensions);

template <template <int> class Kernel, template <int> class Formula>
std::vector<Claim> kernel_claims(const Source& source) {
    std::vector<TestedKernel> dimensions{tested_kernel<Kernel, Formula, 2>(),
                                         tested_kernel<Kernel, Formula, 3>()};
    if constexpr (requires { typename Kernel<1>; })
        dimensions.insert(dimensions.begin(), tested_kernel<Kernel, Formula, 1>());
    return kernel_claims(std::string(Kernel<2>::name), source, dimensions);
}

}  // namespace verification
