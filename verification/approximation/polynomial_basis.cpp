#include "solver/approximation/polynomial_basis.h"

#include "verification/approximation/mls_cloud.h"
#include "verification/framework/registry.h"

#include <algorithm>

namespace polynomial_basis_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// Largest difference between p(y) of degree ≤ Order and all monomials of degree ≤ `degree` written as
/// powers, both sorted; infinite if their numbers differ.
template <int Dim, int Order> double difference_from_powers(int degree) {
    Vec<Dim> y;
    for (int d = 0; d < Dim; ++d) y[d] = std::array{0.7, -0.6, 0.9}[d];
    const auto p = PolynomialBasis<Dim, Order>::at(y);
    std::vector<double> ours(p.data(), p.data() + p.size()), powers;
    for (const auto& m : monomials<Dim>(degree, Vec<Dim>::Zero(), 1.0))
        powers.push_back(m.value(y));
    if (ours.size() != powers.size()) return HUGE_VAL;
    std::ranges::sort(ours);
    std::ranges::sort(powers);
    double worst = 0.0;
    for (std::size_t m = 0; m < ours.size(); ++m)
        worst = std::max(worst, std::abs(ours[m] - powers[m]));
    return worst;
}
template <int Dim> double difference_of_dimension(int missing) {
    return std::max({difference_from_powers<Dim, 0>(0), difference_from_powers<Dim, 1>(1),
                     difference_from_powers<Dim, 2>(2 - missing),
                     difference_from_powers<Dim, 3>(3)});
}

/// How many entries of p are not where `linear` and `square` say.
template <int Dim> double misplaced(int shift) {
    using Basis = PolynomialBasis<Dim, 2>;
    int wrong = 0;
    for (int k = 0; k < Dim; ++k) {
        const auto p = Basis::at(0.5 * Vec<Dim>::Unit(k));
        wrong += p[Basis::linear(k)] != 0.5;
        wrong += p[(Basis::square(k) + shift) % Basis::size] != 0.25;
    }
    return wrong;
}

const Register claims{
    Claim{
        .id = "polynomial_basis.is_complete",
        .source = {Paper::adams2009, "Sec. 3.1"},
        .says =
            "p of order 0 to 3 in 1D, 2D and 3D has all monomials, each once: 1, 2, 3, 4; 1, 3, 6, "
            "10; 1, 4, 10, 20 of them",
        .bound = at_most(4.5e-16, "three factors below 1: 3 u of products and 1 u of pow"),
        .measure =
            [] {
                return std::max({difference_of_dimension<1>(0), difference_of_dimension<2>(0),
                                 difference_of_dimension<3>(0)});
            },
        .sabotaged = [] { return difference_of_dimension<2>(1); }},
    Claim{.id = "polynomial_basis.entries_are_where_it_says",
          .source = {Paper::plumbline, "docstring of PolynomialBasis"},
          .says = "linear(k) and square(k) are the entries of y_k and y_k²",
          .bound = at_most(0, "powers of 1/2 are exact"),
          .measure = [] { return misplaced<1>(0) + misplaced<2>(0) + misplaced<3>(0); },
          .sabotaged = [] { return misplaced<3>(1); }},
};
}  // namespace
}  // namespace polynomial_basis_claims
