#include "benchmarks/approximation/shape_method.h"

#include <memory>

namespace benchmarks {

using namespace plumbline;
using verification::Quantity;

namespace {
Derivatives derivatives_for(Quantity quantity) { return static_cast<Derivatives>(quantity); }

/// Storage for the shape functions of one place at a time.
template <int Dim> struct RowBuffer {
    std::vector<double> phi, laplace_phi;
    std::vector<Vec<Dim>> grad_phi;

    ShapeRow<Dim> row(std::size_t n, Derivatives wanted) {
        phi.resize(n);
        grad_phi.resize(wanted >= Derivatives::gradient ? n : 0);
        laplace_phi.resize(wanted >= Derivatives::laplacian ? n : 0);
        return {phi, grad_phi, laplace_phi};
    }
};

/// Σⱼ Φⱼ fⱼ, Σⱼ ∇Φⱼ fⱼ or Σⱼ ΔΦⱼ fⱼ.
template <int Dim>
void write_sum(const ShapeRow<Dim>& row, std::span<const Index> js, std::span<const double> f,
               Quantity quantity, double* to) {
    if (quantity == Quantity::gradient) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (std::size_t k = 0; k < js.size(); ++k) sum += row.grad_phi[k] * f[js[k]];
        write(sum, to);
        return;
    }
    const auto weights = quantity == Quantity::value ? row.phi : row.laplace_phi;
    double sum = 0;
    for (std::size_t k = 0; k < js.size(); ++k) sum += weights[k] * f[js[k]];
    write(sum, to);
}

template <int Dim>
void write_applied(const ShapeFunctions<Dim>& stored, std::span<const double> f, Quantity quantity,
                   Index k, double* to) {
    switch (quantity) {
        case Quantity::value:
            write(stored.value(f, k), to);
            break;
        case Quantity::gradient:
            write(stored.gradient(f, k), to);
            break;
        case Quantity::laplacian:
            write(stored.laplacian(f, k), to);
            break;
    }
}
}  // namespace

template <int Dim>
PreparedMethod at_places(std::string name, bool reads_volumes, const Situation<Dim>& s,
                         Quantity quantity, Answer answer) {
    const std::size_t width = components_of<Dim>(quantity);
    return {std::move(name), reads_volumes,
            [&s, answer = std::move(answer), width](std::span<double> out) {
                std::size_t failures = 0;
                for (Index k = 0; k < s.places.size(); ++k) failures += answer(k, &out[k * width]);
                return failures;
            }};
}

template <int Dim>
void add_shape_functions(PreparedMethod& method, AnyShape<Dim> shape, const Situation<Dim>& s,
                         Quantity quantity) {
    const auto stored = std::make_shared<ShapeFunctions<Dim>>();
    method.precompute = [stored, shape = std::move(shape), &s, quantity] {
        *stored =
            precompute(shape, std::span<const Vec<Dim>>(s.x), std::span<const Vec<Dim>>(s.places),
                       s.rows, derivatives_for(quantity));
    };
    method.apply = [stored, &s, quantity](std::span<double> out) {
        for (Index k = 0; k < stored->size(); ++k)
            write_applied(*stored, s.f, quantity, k, &out[k * components_of<Dim>(quantity)]);
    };
}

template <int Dim>
PreparedMethod by_shape_functions(std::string name, AnyShape<Dim> shape, bool falls_back,
                                  const Situation<Dim>& s, Quantity quantity) {
    const Derivatives wanted = derivatives_for(quantity);
    const auto buffer = std::make_shared<RowBuffer<Dim>>();
    const auto answer = [=, &s](Index k, double* to) -> std::size_t {
        const auto at = place(s, k);
        const auto row = buffer->row(at.neighbours.size(), wanted);
        const auto fit = shape(s.x, at, row);
        write_sum(row, at.neighbours, s.f, quantity, to);
        return !fit || !(falls_back || fit->complete());
    };
    PreparedMethod method = at_places<Dim>(std::move(name), false, s, quantity, answer);
    add_shape_functions(method, std::move(shape), s, quantity);
    return method;
}

#define PLUMBLINE_INSTANTIATE(Dim)                                                                 \
    template PreparedMethod at_places(std::string, bool, const Situation<Dim>&, Quantity, Answer); \
    template void add_shape_functions(PreparedMethod&, AnyShape<Dim>, const Situation<Dim>&,       \
                                      Quantity);                                                   \
    template PreparedMethod by_shape_functions(std::string, AnyShape<Dim>, bool,                   \
                                               const Situation<Dim>&, Quantity);
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace benchmarks
