#pragma once

#include "solver/kernels/kernel.h"
#include "solver/kernels/poly6.h"
#include "solver/kernels/spiky.h"
#include "verification/framework/mutant.h"

#include <numbers>

namespace verification {

inline constinit Mutant eq_11_without_slope{17, "Eqs. 11, 15: Δω = ω″", "Laplacian of a kernel"};
inline constinit Mutant eq_90_without_coefficient{38, "Eq. 90 without its coefficient",
                                                  "poly6, ω′ in 2D"};
inline constinit Mutant eq_91_without_coefficient{38, "Eq. 91 without its coefficient",
                                                  "poly6, ω″ in 2D"};
inline constinit Mutant eq_92_without_exponent{38, "Eq. 92 without its exponent", "spiky, ω in 3D"};
inline constinit Mutant eq_97_without_condition{38, "Eq. 97 without its condition d < h",
                                                "spiky, ω″ in 2D"};

/// The seam of kernels: the solver's kernel K, but for the forms that are printed wrongly.
template <plumbline::RadialKernel K> class UnderTest : public K {
public:
    using K::K;
    explicit UnderTest(const K& kernel) : K(kernel) {}

    double value(double r) const {
        if constexpr (std::is_same_v<K, plumbline::Spiky<3>>)
            if (eq_92_without_exponent.applied())
                return r < h() ? 15 / (pi * h() * h() * h()) * (1 - r / h()) : 0.0;
        return K::value(r);
    }
    double derivative(double r) const {
        if constexpr (std::is_same_v<K, plumbline::Poly6<2>>)
            if (eq_90_without_coefficient.applied())
                return -r / (h() * h()) * one_minus_q_squared(r) * one_minus_q_squared(r);
        return K::derivative(r);
    }
    double second_derivative(double r) const {
        if constexpr (std::is_same_v<K, plumbline::Poly6<2>>)
            if (eq_91_without_coefficient.applied())
                return one_minus_q_squared(r) * (4 - 5 * one_minus_q_squared(r)) / (h() * h());
        if constexpr (std::is_same_v<K, plumbline::Spiky<2>>)
            if (eq_97_without_condition.applied())
                return 60 / (pi * h() * h() * h() * h()) * (1 - r / h());
        return K::second_derivative(r);
    }
    double laplacian(double r) const {
        if (K::dim > 1 && eq_11_without_slope.applied()) return second_derivative(r);
        if constexpr (requires(const K w) { w.laplacian(r); })
            return K::laplacian(r);
        else
            return plumbline::laplacian(Derivatives{*this}, r);
    }

private:
    /// The same without a Laplacian of its own, so that the solver's is called for it.
    struct Derivatives {
        static constexpr std::string_view name = K::name;
        static constexpr int dim = K::dim;
        const UnderTest& w;
        double support() const { return w.support(); }
        double value(double r) const { return w.value(r); }
        double derivative(double r) const { return w.derivative(r); }
        double second_derivative(double r) const { return w.second_derivative(r); }
    };

    static constexpr double pi = std::numbers::pi;
    double h() const { return K::support(); }
    double one_minus_q_squared(double r) const { return r < h() ? 1 - (r / h()) * (r / h()) : 0.0; }
};

}  // namespace verification
