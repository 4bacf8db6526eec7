#include "solver/approximation/shape_functions.h"

#include "solver/approximation/mls_shape.h"
#include "solver/kernels/poly6.h"
#include "solver/neighbours/brute_force.h"
#include "verification/approximation/mls_under_test.h"
#include "verification/framework/patch.h"
#include "verification/framework/registry.h"
#include "verification/kernels/under_test.h"

namespace shape_functions_claims {
namespace {
using namespace plumbline;
using namespace verification;
template <int Dim> using Poly6 = UnderTest<plumbline::Poly6<Dim>>;
template <int Order, class K> using MlsShape = MlsUnderTest<Order, K>;

using Mls = MlsShape<1, Poly6<2>>;

/// The middle of a disordered patch, the shape functions of order 1 at its samples, and a vector
/// field that a matrix makes of them.
struct Setting {
    Mls mls{Poly6<2>(2.5)};
    Patch<2> patch{1.0, 2.5, 0.3};
    Mat<2> A{{2.0, 3.0}, {5.0, 7.0}};
    std::vector<Vec<2>> v = patch.sample([this](const Vec<2>& x) { return Vec<2>(A * x); });

    ShapeFunctions<2> shape() const {
        return precompute<Mls>(mls, patch.x, patch.x, patch.neighbours, Derivatives::gradient);
    }
    std::vector<double> component(int d) const {
        return patch.sample([=, this](const Vec<2>& x) { return (A * x)[d]; });
    }
};

/// The largest |⟨∇·v⟩ − tr A| for v = A x over all samples whose support is not empty.
double error_of_divergence(bool trace) {
    const Setting s;
    const auto shape = s.shape();
    const double exact = trace ? s.A.trace() : s.A(0, 1) + s.A(1, 0);
    double worst = 0.0;
    for (Index i = 0; i < shape.size(); ++i)
        if (shape.fit[i]->complete())
            worst = std::max(worst,
                             std::abs(*shape.divergence(s.v, i) - exact) / shape.fit[i]->condition);
    return worst;
}

/// Samples moved by a rigid motion and a stretch: ⟨x′⟩ with shape functions of material coordinates, or
/// of the new positions, against ⟨x′⟩ at material coordinates computed afresh.
double difference_of_lagrangian_use(bool material) {
    const Setting s;
    const auto shape = s.shape();
    Patch<2> moved = s.patch;
    for (auto& x : moved.x) x = s.A * x;
    const auto fresh =
        precompute<Mls>(s.mls, material ? s.patch.x : moved.x, material ? s.patch.x : moved.x,
                        s.patch.neighbours, Derivatives::gradient);
    const Index i = s.patch.centre;
    double worst = 0.0;
    for (int d = 0; d < 2; ++d) {
        const auto f = s.component(d);
        worst = std::max(
            worst, (*shape.gradient(f, i) - fresh.gradient(f, i).value_or(Vec<2>::Zero())).norm());
    }
    return worst;
}

double difference_between_thread_counts(bool another_seed) {
    const Setting s;
    const int before = thread_count();
    set_thread_count(1);
    const auto one = s.shape();
    set_thread_count(2);
    Setting other;
    if (another_seed) other.patch.x[other.patch.centre][0] += 1e-9;
    const auto two = other.shape();
    set_thread_count(before);
    double different = 0;
    for (std::size_t k = 0; k < one.phi.size(); ++k)
        different += one.phi[k] != two.phi[k] || one.grad_phi[k] != two.grad_phi[k];
    return different;
}

double empty_answers_without_neighbours(bool far) {
    const Setting s;
    const std::array at{Vec<2>{far ? 100.0 : 0.0, 0.0}};
    BruteForce<2> search;
    search.build(s.patch.x, 2.5);
    const auto shape =
        precompute<Mls>(s.mls, s.patch.x, at, search.query(at), Derivatives::gradient);
    return !shape.value(s.component(0), 0) + !shape.gradient(s.component(0), 0);
}

const Register claims{
    Claim{.id = "shape_functions.divergence_of_a_linear_field_is_the_trace",
          .source = {Paper::adams2009, "Eq. 33; Table 1"},
          .says = "⟨∇·v⟩ = tr A for v = A x, with MLS of order 1, at every sample of a patch",
          .bound = at_most(1e-12, "relative to κ: v up to 60 with N² u = 1e-15, times h|∇ω|/ω = 5"),
          .measure = [] { return error_of_divergence(true); },
          .sabotaged = [] { return error_of_divergence(false); }},
    Claim{.id = "shape_functions.lagrangian_use_needs_no_update",
          .source = {Paper::adams2009, "Sec. 4"},
          .says =
              "samples that move: shape functions of the material coordinates, computed once, are "
              "those computed anew, bit for bit; of the current coordinates they are not",
          .bound = at_most(0, "the same code on the same numbers"),
          .measure = [] { return difference_of_lagrangian_use(true); },
          .sabotaged = [] { return difference_of_lagrangian_use(false); }},
    Claim{.id = "shape_functions.do_not_depend_on_the_number_of_threads",
          .source = {Paper::plumbline, "docstring of parallel_for"},
          .says = "1 and 2 threads give the same shape functions, bit for bit",
          .bound = at_most(0, "every row is computed by one thread, from the same numbers"),
          .measure = [] { return difference_between_thread_counts(false); },
          .sabotaged = [] { return difference_between_thread_counts(true); }},
    Claim{.id = "shape_functions.say_so_where_there_is_no_sample",
          .source = {Paper::plumbline, "docstring of ShapeFunctions"},
          .says = "far from all samples value and gradient are empty, not 0",
          .bound = between(2, 2, "two empty answers"),
          .measure = [] { return empty_answers_without_neighbours(true); },
          .sabotaged = [] { return empty_answers_without_neighbours(false); }},
};
}  // namespace
}  // namespace shape_functions_claims
