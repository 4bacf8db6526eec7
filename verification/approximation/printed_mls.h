#pragma once

#include "verification/approximation/mls_cloud.h"

#include <stdexcept>

namespace verification {

/// Moving least squares as adams2009 Eqs. 24 and 27 print it: monomials of the coordinates themselves,
/// neither centred nor scaled, and M⁻¹ by elimination; with poly6 weights, whose scale does not
/// matter. With Real50 it is the truth that the solver is compared with; with double it shows what
/// the centred and scaled basis of Eqs. 28 and 29 is good for.
template <class Real, int Dim> struct PrintedMls {
    using Point = std::array<Real, Dim>;
    std::vector<std::array<int, Dim>> exponents;  // of the basis
    std::vector<Point> x;
    Real support;

    /// All monomials of degree ≤ order; the samples near the cloud's point.
    PrintedMls(int order, const Cloud<Dim>& cloud) : support{cloud.support} {
        for (const auto& m : monomials<Dim>(order, {}, 1.0)) exponents.push_back(m.alpha);
        const auto near = cloud.near();
        for (const plumbline::Index j : near.indices) x.push_back(point(cloud.x[j]));
    }
    static Point point(const plumbline::Vec<Dim>& v) {
        Point p;
        for (int d = 0; d < Dim; ++d) p[d] = v[d];
        return p;
    }

    Real weight(const Point& at, const Point& xj) const {
        Real s = 1;
        for (int d = 0; d < Dim; ++d) s -= (at[d] - xj[d]) * (at[d] - xj[d]) / (support * support);
        return s > 0 ? Real(s * s * s) : Real(0);
    }
    std::vector<Real> basis(const Point& at) const {
        std::vector<Real> p;
        for (const auto& alpha : exponents) {
            p.push_back(1);
            for (int d = 0; d < Dim; ++d)
                for (int e = 0; e < alpha[d]; ++e) p.back() *= at[d];
        }
        return p;
    }

    /// M b = p(at), by elimination with pivots.
    std::vector<Real> coefficients(const Point& at) const {
        std::vector<Real> b = basis(at);
        const std::size_t n = b.size();
        std::vector<std::vector<Real>> M(n, std::vector<Real>(n, 0));
        for (const Point& xj : x) {
            const auto p = basis(xj);
            const Real w = weight(at, xj);
            for (std::size_t r = 0; r < n; ++r)
                for (std::size_t c = 0; c < n; ++c) M[r][c] += w * p[r] * p[c];
        }
        using std::abs;
        for (std::size_t k = 0; k < n; ++k) {
            std::size_t pivot = k;
            for (std::size_t r = k + 1; r < n; ++r)
                if (abs(M[r][k]) > abs(M[pivot][k])) pivot = r;
            std::swap(M[k], M[pivot]);
            std::swap(b[k], b[pivot]);
            if (M[k][k] == 0) throw std::domain_error("singular moment matrix");
            for (std::size_t r = k + 1; r < n; ++r) {
                const Real factor = M[r][k] / M[k][k];
                for (std::size_t c = k; c < n; ++c) M[r][c] -= factor * M[k][c];
                b[r] -= factor * b[k];
            }
        }
        for (std::size_t k = n; k-- > 0;) {
            for (std::size_t c = k + 1; c < n; ++c) b[k] -= M[k][c] * b[c];
            b[k] /= M[k][k];
        }
        return b;
    }

    /// Φⱼ(at) = ωⱼ p(at)ᵀ M⁻¹ p(xⱼ), of the samples in their order.
    std::vector<Real> shape(const Point& at) const {
        const auto b = coefficients(at);
        std::vector<Real> phi;
        for (const Point& xj : x) {
            const auto p = basis(xj);
            Real s = 0;
            for (std::size_t k = 0; k < p.size(); ++k) s += b[k] * p[k];
            phi.push_back(weight(at, xj) * s);
        }
        return phi;
    }

    /// ∂Φⱼ/∂x_d by central differences of step e, whose error is e² ∂³Φⱼ / 6.
    std::vector<Real> slope(Point at, int d, const Real& e) const {
        const Real middle = at[d];
        at[d] = middle + e;
        auto high = shape(at);
        at[d] = middle - e;
        const auto low = shape(at);
        for (std::size_t j = 0; j < high.size(); ++j) high[j] = (high[j] - low[j]) / (2 * e);
        return high;
    }
    /// ΔΦⱼ likewise.
    std::vector<Real> laplacian(const Point& at, const Real& e) const {
        const auto centre = shape(at);
        std::vector<Real> total(centre.size(), Real(0));
        for (int d = 0; d < Dim; ++d)
            for (const int sign : {-1, 1}) {
                Point moved = at;
                moved[d] += sign * e;
                const auto phi = shape(moved);
                for (std::size_t j = 0; j < phi.size(); ++j)
                    total[j] += (phi[j] - centre[j]) / (e * e);
            }
        return total;
    }
};

}  // namespace verification
