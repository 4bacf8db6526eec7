#include "solver/approximation/mls_shape.h"

#include "solver/approximation/moment_inverse.h"

namespace plumbline {

namespace {

/// The neighbours of one point as the basis sees them: pⱼ = p((xⱼ − x) / h), with their weights.
template <int Dim, int Order> struct Neighbourhood {
    using Basis = PolynomialBasis<Dim, Order>;
    using Vector = typename Basis::Vector;
    using Matrix = typename Basis::Matrix;
    using Gradient = Eigen::Matrix<double, Basis::size, Dim>;  // column k: derivative along x_k

    std::span<const Vec<Dim>> x;
    const Place<Dim>& at;
    double h;
    ShapeRow<Dim> row;

    std::size_t size() const { return at.neighbours.size(); }
    Vector p(std::size_t j) const { return Basis::at((x[at.neighbours[j]] - at.x) / h); }

    /// M = Σⱼ ωⱼ pⱼ pⱼᵀ                                                                  Eq. 28
    Matrix moments() const {
        Matrix M = Matrix::Zero();
        for (std::size_t j = 0; j < size(); ++j) {
            const Vector pj = p(j), weighted = row.phi[j] * pj;
            for (int c = 0; c < Basis::size; ++c) M.col(c) += pj[c] * weighted;
        }
        return M;
    }

    // Eqs. 30, 31 with the centre of the basis frozen: Φⱼ(y) = ωⱼ(y) p((y − x)/h)ᵀ M(y)⁻¹ pⱼ is
    // differentiated in y at y = x, where pⱼ is constant but p((y − x)/h) is not. With b = M⁻¹ p,
    //     M ∂ₖb = ∂ₖp − ∂ₖM b,   M Δb = Δp − ΔM b − 2 Σₖ ∂ₖM ∂ₖb.

    Gradient moments_times_gradient_of(const Vector& b) const {
        Gradient right = Gradient::Zero();
        if constexpr (Order >= 1)
            for (int k = 0; k < Dim; ++k) right(Basis::linear(k), k) = 1.0 / h;
        for (std::size_t j = 0; j < size(); ++j) {
            const Vector pj = p(j), scaled = b.dot(pj) * pj;
            for (int k = 0; k < Dim; ++k) right.col(k) -= row.grad_phi[j][k] * scaled;
        }
        return right;
    }
    Vector moments_times_laplacian_of(const Vector& b, const Gradient& grad_b) const {
        Vector right = Vector::Zero();
        if constexpr (Order >= 2)
            for (int k = 0; k < Dim; ++k) right[Basis::square(k)] = 2.0 / (h * h);
        for (std::size_t j = 0; j < size(); ++j) {
            const Vector pj = p(j);
            const Vec<Dim> grad_s = grad_b.transpose() * pj;
            right -= (row.laplace_phi[j] * b.dot(pj) + 2.0 * row.grad_phi[j].dot(grad_s)) * pj;
        }
        return right;
    }

    /// Φⱼ = ωⱼ sⱼ with sⱼ = b·pⱼ, and its derivatives by the product rule.
    void turn_weights_into_shape_functions(const Matrix& inverse) const {
        const bool first = !row.grad_phi.empty(), second = !row.laplace_phi.empty();
        const Vector b = inverse.col(0);  // p(0) = e₀
        Gradient grad_b = Gradient::Zero();
        if (first) grad_b.noalias() = inverse.lazyProduct(moments_times_gradient_of(b));
        Vector laplace_b = Vector::Zero();
        if (second)
            laplace_b.noalias() = inverse.lazyProduct(moments_times_laplacian_of(b, grad_b));
        for (std::size_t j = 0; j < size(); ++j) {
            const Vector pj = p(j);
            const double s = b.dot(pj), w = row.phi[j];
            row.phi[j] = w * s;
            if (!first) continue;
            const Vec<Dim> grad_s = grad_b.transpose() * pj, grad_w = row.grad_phi[j];
            row.grad_phi[j] = s * grad_w + w * grad_s;
            if (second)
                row.laplace_phi[j] =
                    row.laplace_phi[j] * s + 2.0 * grad_w.dot(grad_s) + w * laplace_b.dot(pj);
        }
    }
};

}  // namespace

template <int Dim, int Order>
std::optional<Fit> mls_from_weights(std::span<const Vec<Dim>> x, const Place<Dim>& at, double h,
                                    ShapeRow<Dim> row) {
    using Basis = PolynomialBasis<Dim, Order>;
    const Neighbourhood<Dim, Order> neighbourhood{x, at, h, row};
    const auto G = moment_inverse<Basis::size>(neighbourhood.moments(), Basis::degree_ends);
    if (!G) return std::nullopt;
    neighbourhood.turn_weights_into_shape_functions(G->inverse);
    return Fit{Order, G->rank, Basis::size, G->condition};
}

#define PLUMBLINE_INSTANTIATE(Dim, Order)                     \
    template std::optional<Fit> mls_from_weights<Dim, Order>( \
        std::span<const Vec<Dim>>, const Place<Dim>&, double, ShapeRow<Dim>);
#define PLUMBLINE_INSTANTIATE_ORDERS(Dim) \
    PLUMBLINE_INSTANTIATE(Dim, 0)         \
    PLUMBLINE_INSTANTIATE(Dim, 1)         \
    PLUMBLINE_INSTANTIATE(Dim, 2)         \
    PLUMBLINE_INSTANTIATE(Dim, 3)
PLUMBLINE_INSTANTIATE_ORDERS(1)
PLUMBLINE_INSTANTIATE_ORDERS(2)
PLUMBLINE_INSTANTIATE_ORDERS(3)
#undef PLUMBLINE_INSTANTIATE_ORDERS
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumbline
