#include "solver/surface/particle_field.h"

#include "solver/foundation/parallel.h"
#include "solver/foundation/random.h"
#include "solver/surface/blobby_field.h"

#include <catch2/catch.hpp>

namespace particle_field_test {
namespace {
using namespace plumbline;

template <int Dim> Points<Dim> cloud() {
    Random random(3);
    Points<Dim> x(200);
    for (Vec<Dim>& x_i : x)
        for (int d = 0; d < Dim; ++d) x_i[d] = random.uniform();
    return x;
}
template <int Dim> ScalarGrid<Dim> field() {
    return on_grid<Dim>(BlobbyField<Dim>{0.2, 0.5}, std::span<const Vec<Dim>>(cloud<Dim>()), 0.06);
}

TEMPLATE_TEST_CASE_SIG("the field at a node is that of a sum over all particles", "",
                       ((int Dim), Dim), 2, 3) {
    const auto grid = field<Dim>();
    const auto x = cloud<Dim>();
    for (std::size_t node = 0; node < grid.nodes(); node += 7) {
        double sum = 0.5;
        for (const Vec<Dim>& x_i : x) sum -= blob((grid.position(node) - x_i).norm() / 0.2);
        CHECK(grid.values[node] == Approx(sum).margin(1e-13));
    }
}

TEST_CASE("the field does not depend on the number of threads") {
    const int threads = thread_count();
    set_thread_count(1);
    const auto one = field<3>().values;
    set_thread_count(2);
    CHECK(field<3>().values == one);
    set_thread_count(threads);
}
}  // namespace
}  // namespace particle_field_test
