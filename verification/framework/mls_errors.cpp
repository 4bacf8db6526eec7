#include "solver/approximation/mlsph_shape.h"
#include "verification/framework/approximation_errors.h"

namespace verification {

namespace {
using namespace plumbline;
using enum Quantity;

/// Shape functions and as many of their derivatives as are wanted, applied to the samples of f.
template <class Shape> struct Applied {
    static constexpr int Dim = Shape::dim;
    const Spot<Dim>& p;
    std::vector<double> phi, laplace_phi;
    std::vector<Vec<Dim>> grad_phi;
    bool answered;

    Applied(const Shape& shape, const Spot<Dim>& spot, Quantity wanted)
        : p{spot},
          phi(spot.at.neighbours.size()),
          laplace_phi(wanted == laplacian ? phi.size() : 0),
          grad_phi(wanted == value ? 0 : phi.size()),
          answered{shape(p.s.x, p.at, ShapeRow<Dim>{phi, grad_phi, laplace_phi}).has_value()} {}

    template <class T> std::optional<T> sum(const std::vector<T>& weights, T total) const {
        if (!answered) return std::nullopt;
        for (std::size_t k = 0; k < weights.size(); ++k)
            total += weights[k] * p.f[p.at.neighbours[k]];
        return total;
    }
};

template <class Shape>
std::optional<double> value_by(const Shape& shape, const Spot<Shape::dim>& p) {
    const Applied row(shape, p, value);
    return row.sum(row.phi, 0.0);
}
template <class Shape>
std::optional<Vec<Shape::dim>> gradient_by(const Shape& shape, const Spot<Shape::dim>& p) {
    const Applied row(shape, p, gradient);
    return row.sum(row.grad_phi, Vec<Shape::dim>(Vec<Shape::dim>::Zero()));
}
template <class Shape>
std::optional<double> laplacian_by(const Shape& shape, const Spot<Shape::dim>& p) {
    const Applied row(shape, p, laplacian);
    return row.sum(row.laplace_phi, 0.0);
}

/// Erratum 25: Eq. 30 applied to the centred basis of Eq. 29 as if p(0) did not depend on x. What is
/// lost then is exactly the diffuse derivative, the part in which only p is differentiated.
template <int Dim> std::optional<Vec<Dim>> printed_gradient(const Spot<Dim>& p) {
    using Shape = MlsShape<2, AnyKernel<Dim>>;
    const auto full = gradient_by(Shape(p.w), p);
    const auto diffuse = gradient_by(Shape(p.w, MlsDerivative::diffuse), p);
    if (!full || !diffuse) return std::nullopt;
    return Vec<Dim>(*full - *diffuse);
}

template <int Dim> std::vector<Method<Dim>> all_methods() {
    using K = AnyKernel<Dim>;
    using P = const Spot<Dim>&;
    return {
        {{value, "MLS 0"}, [](P p) { return p.value_error(value_by(MlsShape<0, K>(p.w), p)); }},
        {{value, "MLS 1"}, [](P p) { return p.value_error(value_by(MlsShape<1, K>(p.w), p)); }},
        {{value, "MLS 2"}, [](P p) { return p.value_error(value_by(MlsShape<2, K>(p.w), p)); }},
        {{value, "MLS 3"}, [](P p) { return p.value_error(value_by(MlsShape<3, K>(p.w), p)); }},
        {{value, "MLSPH"}, [](P p) { return p.value_error(value_by(MlsphShape<2, K>(p.w), p)); }},
        {{gradient, "MLS 1"},
         [](P p) { return p.gradient_error(gradient_by(MlsShape<1, K>(p.w), p)); }},
        {{gradient, "MLS 2"},
         [](P p) { return p.gradient_error(gradient_by(MlsShape<2, K>(p.w), p)); }},
        {{gradient, "MLS 3"},
         [](P p) { return p.gradient_error(gradient_by(MlsShape<3, K>(p.w), p)); }},
        {{gradient, "MLSPH"},
         [](P p) { return p.gradient_error(gradient_by(MlsphShape<2, K>(p.w), p)); }},
        {{laplacian, "MLS 2"},
         [](P p) { return p.laplacian_error(laplacian_by(MlsShape<2, K>(p.w), p)); }},
        {{laplacian, "MLS 3"},
         [](P p) { return p.laplacian_error(laplacian_by(MlsShape<3, K>(p.w), p)); }},
        {{laplacian, "MLSPH"},
         [](P p) { return p.laplacian_error(laplacian_by(MlsphShape<2, K>(p.w), p)); }},
        {{gradient, "printed Eqs. 29, 30"},
         [](P p) { return p.gradient_error(printed_gradient(p)); },
         true}};
}
}  // namespace

template <int Dim> std::span<const Method<Dim>> mls_methods() {
    static const std::vector<Method<Dim>> all = all_methods<Dim>();
    return all;
}
template std::span<const Method<1>> mls_methods();
template std::span<const Method<2>> mls_methods();
template std::span<const Method<3>> mls_methods();

}  // namespace verification
