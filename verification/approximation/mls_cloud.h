#pragma once

#include "solver/approximation/shape_functions.h"
#include "solver/foundation/random.h"

#include <array>
#include <cmath>

namespace verification {

/// Samples and a point among them, where shape functions are examined.
template <int Dim> struct Cloud {
    plumbline::Points<Dim> x;
    plumbline::Vec<Dim> at;
    double support;

    plumbline::NeighbourLists near() const {
        plumbline::NeighbourLists lists{{0}, {}};
        for (plumbline::Index j = 0; j < x.size(); ++j)
            if ((x[j] - at).squaredNorm() < support * support) lists.indices.push_back(j);
        lists.offsets.push_back(lists.indices.size());
        return lists;
    }
};

/// The shape functions of `method` at the cloud's point: row 0.
template <plumbline::ShapeMethod Method>
plumbline::ShapeFunctions<Method::dim> shape_at(
    const Method& method, const Cloud<Method::dim>& cloud,
    plumbline::Derivatives wanted = plumbline::Derivatives::laplacian) {
    const std::array at{cloud.at};
    return plumbline::precompute<Method>(method, cloud.x, at, cloud.near(), wanted);
}

/// A cubic lattice of spacing 1, each sample moved by up to `jitter` along each axis, and a random
/// point in the middle cell; the support of the point is full.
template <int Dim>
Cloud<Dim> jittered_cloud(double support, std::uint64_t seed, double jitter = 0.3) {
    plumbline::Random random(seed);
    Cloud<Dim> cloud{{}, {}, support};
    const int half = static_cast<int>(std::ceil(support)) + 1, side = 2 * half + 1;
    const int n = static_cast<int>(std::lround(std::pow(side, Dim)));
    for (int code = 0; code < n; ++code) {
        plumbline::Vec<Dim> p;
        for (int d = 0, k = code; d < Dim; ++d, k /= side)
            p[d] = k % side - half + jitter * random.uniform(-1.0, 1.0);
        cloud.x.push_back(p);
    }
    for (int d = 0; d < Dim; ++d) cloud.at[d] = random.uniform(-0.5, 0.5);
    return cloud;
}

/// ∏ₖ (xₖ − cₖ)^{αₖ} / h^{|α|}, with its derivatives by hand, for use as an exactly known field.
template <int Dim> struct Monomial {
    std::array<int, Dim> alpha;
    plumbline::Vec<Dim> centre;
    double h;

    double value(const plumbline::Vec<Dim>& x) const { return derivative(x, {}); }
    plumbline::Vec<Dim> gradient(const plumbline::Vec<Dim>& x) const {
        plumbline::Vec<Dim> g;
        for (int k = 0; k < Dim; ++k) g[k] = derivative(x, unit(k, 1));
        return g;
    }
    double laplacian(const plumbline::Vec<Dim>& x) const {
        double total = 0.0;
        for (int k = 0; k < Dim; ++k) total += derivative(x, unit(k, 2));
        return total;
    }

private:
    static std::array<int, Dim> unit(int k, int times) {
        std::array<int, Dim> d{};
        d[k] = times;
        return d;
    }
    double derivative(const plumbline::Vec<Dim>& x, const std::array<int, Dim>& times) const {
        double product = 1.0;
        for (int k = 0; k < Dim; ++k) {
            int exponent = alpha[k];
            for (int t = 0; t < times[k]; ++t) product *= exponent-- / h;
            if (product != 0.0) product *= std::pow((x[k] - centre[k]) / h, exponent);
        }
        return product;
    }
};

/// All monomials of total degree ≤ order, about the given centre.
template <int Dim>
std::vector<Monomial<Dim>> monomials(int order, const plumbline::Vec<Dim>& centre, double h) {
    std::vector<Monomial<Dim>> all;
    const int base = order + 1, n = static_cast<int>(std::lround(std::pow(base, Dim)));
    for (int code = 0; code < n; ++code) {
        Monomial<Dim> m{{}, centre, h};
        int degree = 0;
        for (int d = 0, k = code; d < Dim; ++d, k /= base) degree += m.alpha[d] = k % base;
        if (degree <= order) all.push_back(m);
    }
    return all;
}

/// f at every sample.
template <int Dim, class F> std::vector<double> sampled(const Cloud<Dim>& cloud, F f) {
    std::vector<double> values;
    for (const auto& x : cloud.x) values.push_back(f(x));
    return values;
}

}  // namespace verification
