#include "benchmarks/approximation/frontier_methods.h"
#include "benchmarks/approximation/shape_method.h"
#include "solver/approximation/mlsph_shape.h"
#include "solver/kernels/all_kernels.h"

namespace benchmarks {

using namespace plumbline;
using verification::Quantity;

template <int Dim>
std::vector<PreparedMethod> mls_methods(const Situation<Dim>& s, Quantity quantity) {
    std::vector<PreparedMethod> all;
    const auto add = [&](std::string name, AnyShape<Dim> shape, bool falls_back) {
        all.push_back(
            by_shape_functions(std::move(name), std::move(shape), falls_back, s, quantity));
    };
    AllKernels::with<Dim>(s.kernel, s.support, [&]<class K>(const K& w) {
        if (quantity != Quantity::laplacian) add("MLS 1", {MlsShape<1, K>(w)}, false);
        add("MLS 2", {MlsShape<2, K>(w)}, false);
        add("MLS 3", {MlsShape<3, K>(w)}, false);
        add("MLSPH", {MlsphShape<2, K>(w)}, true);
    });
    return all;
}
template std::vector<PreparedMethod> mls_methods(const Situation<2>&, Quantity);
template std::vector<PreparedMethod> mls_methods(const Situation<3>&, Quantity);

}  // namespace benchmarks
