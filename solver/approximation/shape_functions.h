#pragma once

#include "solver/approximation/samples.h"
#include "solver/approximation/shape_row.h"
#include "solver/foundation/errors.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/sum.h"

#include <optional>
#include <string>

namespace plumbline {

/// A method that writes the shape functions of one point: SphShape, MlsShape, MlsphShape, ….
template <class S>
concept ShapeMethod = requires(const S s, std::span<const Vec<S::dim>> x, Place<S::dim> at,
                               ShapeRow<S::dim> row) {
    { s(x, at, row) } -> std::same_as<std::optional<Fit>>;
};

/// The shape functions of q points in compressed rows: computed once, applied to any number of
/// fields by dot products, whatever the method (adams2009 Eq. 39, Sec. 4). Lagrangian use keeps
/// them for as long as the samples do not move in material coordinates; Eulerian use computes them
/// anew in every step.
/// Where a point has no fit, whatever is asked there is empty. `f` has one value per sample; throws
/// InvalidInput if it has another number.
template <int Dim> struct ShapeFunctions {
    std::size_t n_samples = 0;
    NeighbourLists neighbours;            // q rows
    std::vector<std::optional<Fit>> fit;  // q
    std::vector<double> phi;              // one per neighbour, like neighbours.indices
    std::vector<Vec<Dim>> grad_phi;       // likewise, or empty if not wanted
    std::vector<double> laplace_phi;      // likewise, or empty if not wanted

    std::size_t size() const { return neighbours.size(); }

    /// ⟨f⟩(xᵢ) = Σⱼ Φⱼ(xᵢ) fⱼ                                               adams2009 Eqs. 26, 39
    std::optional<double> value(std::span<const double> f, Index i) const {
        return dot<double>(phi, f, i);
    }
    /// ⟨∇f⟩(xᵢ) = Σⱼ fⱼ ∇Φⱼ(xᵢ)                                                 adams2009 Eq. 32
    std::optional<Vec<Dim>> gradient(std::span<const double> f, Index i) const {
        return dot<Vec<Dim>>(grad_phi, f, i);
    }
    /// ⟨∇·f⟩(xᵢ) = Σⱼ fⱼ · ∇Φⱼ(xᵢ)                                              adams2009 Eq. 33
    std::optional<double> divergence(std::span<const Vec<Dim>> f, Index i) const {
        return dot<double>(grad_phi, f, i);
    }
    /// ⟨Δf⟩(xᵢ) = Σⱼ ΔΦⱼ(xᵢ) fⱼ                                                 adams2009 Eq. 34
    std::optional<double> laplacian(std::span<const double> f, Index i) const {
        return dot<double>(laplace_phi, f, i);
    }

private:
    template <class T, class Weights, class Field>
    std::optional<T> dot(const std::vector<Weights>& weights, std::span<const Field> f,
                         Index i) const {
        if (f.size() != n_samples)
            throw InvalidInput("shape functions of " + std::to_string(n_samples) +
                               " samples: expected as many values, found " +
                               std::to_string(f.size()));
        if (weights.size() != neighbours.indices.size())
            throw InvalidInput("shape functions: this derivative was not computed");
        if (!fit[i]) return std::nullopt;
        T total = zero<T>();
        for (std::size_t k = neighbours.offsets[i]; k < neighbours.offsets[i + 1]; ++k)
            total += product(weights[k], f[neighbours.indices[k]]);
        return total;
    }
    static double product(double phi, double f) { return phi * f; }
    static Vec<Dim> product(const Vec<Dim>& grad_phi, double f) { return grad_phi * f; }
    static double product(const Vec<Dim>& grad_phi, const Vec<Dim>& f) { return grad_phi.dot(f); }
};

/// The shape functions of `method` at every point of `at`; row i of `neighbours` lists the samples
/// within the support of at[i]. Throws InvalidInput if there is not one row per point.
template <ShapeMethod Method>
ShapeFunctions<Method::dim> precompute(const Method& method,
                                       std::span<const Vec<Method::dim>> samples,
                                       std::span<const Vec<Method::dim>> at,
                                       NeighbourLists neighbours, Derivatives wanted) {
    if (neighbours.size() != at.size())
        throw InvalidInput("precompute: expected one row of neighbours for each of " +
                           std::to_string(at.size()) + " points, found " +
                           std::to_string(neighbours.size()));
    const std::size_t n = neighbours.indices.size();
    ShapeFunctions<Method::dim> shape;
    shape.n_samples = samples.size();
    shape.neighbours = std::move(neighbours);
    shape.fit.resize(at.size());
    shape.phi.resize(n);
    if (wanted >= Derivatives::gradient) shape.grad_phi.resize(n);
    if (wanted >= Derivatives::laplacian) shape.laplace_phi.resize(n);
    parallel_for(at.size(), [&](std::size_t i) {
        const std::size_t begin = shape.neighbours.offsets[i];
        const std::size_t count = shape.neighbours.offsets[i + 1] - begin;
        const auto part = [&]<class T>(std::vector<T>& all) {
            return all.empty() ? std::span<T>{} : std::span<T>(all).subspan(begin, count);
        };
        shape.fit[i] = method(samples, {at[i], shape.neighbours.of(static_cast<Index>(i))},
                              {part(shape.phi), part(shape.grad_phi), part(shape.laplace_phi)});
    });
    return shape;
}

}  // namespace plumbline
