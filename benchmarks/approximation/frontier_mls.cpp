#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/approximation/shape_method.h"
#include "solver/approximation/mlsph_shape.h"

namespace benchmarks {

namespace {
using namespace plumbline;
using verification::Quantity;

/// `falls_back`: a lower rank is what the method is for, and no failure.
template <class Shape>
PreparedMethod method_of(std::string name, const Shape& shape, bool falls_back,
                         const Situation<Shape::dim>& s, Quantity quantity) {
    constexpr int Dim = Shape::dim;
    const std::size_t width = components_of<Dim>(quantity);
    const Derivatives wanted = derivatives_for(quantity);
    PreparedMethod method{std::move(name), false, [=, &s](std::span<double> out) {
                              RowBuffer<Dim> buffer;
                              std::size_t failures = 0;
                              for (Index k = 0; k < s.places.size(); ++k) {
                                  const auto js = s.rows.of(k);
                                  const auto row = buffer.row(js.size(), wanted);
                                  const auto fit = shape(s.x, Place<Dim>{s.places[k], js}, row);
                                  write_sum(row, js, s.f, quantity, &out[k * width]);
                                  failures += !fit || !(falls_back || fit->complete());
                              }
                              return failures;
                          }};
    add_shape_functions(method, shape, s, quantity);
    return method;
}
}  // namespace

template <int Dim>
std::vector<PreparedMethod> mls_methods(const Situation<Dim>& s, Quantity quantity) {
    std::vector<PreparedMethod> all;
    FrontierKernels::with<Dim>(s.kernel, s.support, [&]<class K>(const K& w) {
        if (quantity != Quantity::laplacian)
            all.push_back(method_of("MLS 1", MlsShape<1, K>(w), false, s, quantity));
        all.push_back(method_of("MLS 2", MlsShape<2, K>(w), false, s, quantity));
        all.push_back(method_of("MLS 3", MlsShape<3, K>(w), false, s, quantity));
        all.push_back(method_of("MLSPH", MlsphShape<2, K>(w), true, s, quantity));
    });
    return all;
}
template std::vector<PreparedMethod> mls_methods(const Situation<2>&, Quantity);
template std::vector<PreparedMethod> mls_methods(const Situation<3>&, Quantity);

}  // namespace benchmarks
