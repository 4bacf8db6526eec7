#pragma once

#include "solver/foundation/types.h"

#include <array>

namespace plumbline {

/// Number of monomials of degree ≤ order in dim variables: (order + dim)! / (order! dim!).
constexpr int basis_size(int dim, int order) {
    int n = 1;
    for (int k = 1; k <= dim; ++k) n = n * (order + k) / k;
    return n;
}

/// The complete polynomial basis p of adams2009 Sec. 3.1, by ascending degree:
/// 1, x, y, z, x², xy, y², xz, yz, z², … Order 0..3; size 1..4 in 1D, 1, 3, 6, 10 in 2D and
/// 1, 4, 10, 20 in 3D. p(0) = e₀, which is what makes a centred basis (Eq. 29) cheap.
template <int Dim, int Order>
requires(1 <= Dim && Dim <= 3 && 0 <= Order && Order <= 3) struct PolynomialBasis {
    static constexpr int dim = Dim;
    static constexpr int order = Order;
    static constexpr int size = basis_size(Dim, Order);
    using Vector = Eigen::Matrix<double, size, 1>;
    using Matrix = Eigen::Matrix<double, size, size>;

    /// p(y).
    static Vector at(const Vec<Dim>& y) {
        Vector p;
        p[0] = 1.0;
        for (int m = 1; m < size; ++m) p[m] = p[factors[m].parent] * y[factors[m].axis];
        return p;
    }

    /// The monomials of degree g are the entries before degree_ends[g] that no lower degree has.
    static constexpr std::array<int, Order + 1> degree_ends = [] {
        std::array<int, Order + 1> ends{};
        for (int g = 0; g <= Order; ++g) ends[g] = basis_size(Dim, g);
        return ends;
    }();
    /// Entry of y_k (for order ≥ 1) and of y_k² (for order ≥ 2).
    static constexpr int linear(int k) { return 1 + k; }
    static constexpr int square(int k) { return basis_size(Dim, 1) + (k + 1) * (k + 2) / 2 - 1; }

private:
    /// Monomial m is monomial `parent` times coordinate `axis`, its last one.
    struct Factors {
        int parent, axis;
    };
    static constexpr std::array<Factors, size> factors = [] {
        std::array<Factors, size> all{};
        int m = 1;
        for (int degree = 1, begin = 0; degree <= Order; begin = degree_ends[degree++ - 1])
            for (int axis = 0; axis < Dim; ++axis)
                for (int parent = begin; parent < degree_ends[degree - 1]; ++parent)
                    if (all[parent].axis <= axis) all[m++] = {parent, axis};
        return all;
    }();
};

}  // namespace plumbline
