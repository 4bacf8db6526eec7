#include "solver/approximation/mls_shape.h"

#include "solver/kernels/poly6.h"
#include "verification/approximation/mls_cloud.h"
#include "verification/framework/registry.h"

#include <fmt/format.h>

namespace {
using namespace plumbline;
using namespace verification;

enum class Quantity { value, gradient, laplacian };

/// The support in spacings; order 3 has more to determine.
constexpr double support(int order) { return order < 3 ? 2.8 : 3.6; }

/// The largest error of ⟨q⟩, h ∇⟨q⟩ or h² Δ⟨q⟩ over the monomials q of degree ≤ `degree` about a
/// point that is a support away, in units of the condition number; over 10 jittered clouds.
template <int Dim, int Order> double inconsistency(Quantity quantity, int degree) {
    constexpr double h = support(Order);
    const MlsShape<Order, Poly6<Dim>> mls{Poly6<Dim>(h)};
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const auto cloud = jittered_cloud<Dim>(h, seed);
        const auto shape = shape_at(mls, cloud);
        for (const auto& q : monomials<Dim>(degree, Vec<Dim>::Constant(h), h)) {
            const auto f = sampled(cloud, [&](const Vec<Dim>& x) { return q.value(x); });
            double error = 0.0;
            if (quantity == Quantity::value)
                error = *shape.value(f, 0) - q.value(cloud.at);
            else if (quantity == Quantity::gradient)
                error = h * (*shape.gradient(f, 0) - q.gradient(cloud.at)).norm();
            else
                error = h * h * (*shape.laplacian(f, 0) - q.laplacian(cloud.at));
            worst = std::max(worst, std::abs(error) / shape.fit[0]->condition);
        }
    }
    return worst;
}

struct Row {
    Quantity quantity;
    const char *name, *source, *says;
};
constexpr Row rows[] = {
    {Quantity::value, "value", "Eqs. 25, 26, 27; Sec. 3.2", "⟨q⟩ = q"},
    {Quantity::gradient, "gradient", "Eqs. 30-32; Sec. 3.2", "∇⟨q⟩ = ∇q"},
    {Quantity::laplacian, "laplacian", "Eq. 34; Sec. 3.2", "Δ⟨q⟩ = Δq"},
};

template <int Dim, int Order> void add_consistency(std::vector<Claim>& claims) {
    for (const Row& row : rows)
        claims.push_back(
            {.id = fmt::format("mls_shape.{}_of_order_{}_is_consistent_{}d", row.name, Order, Dim),
             .source = {Paper::adams2009, row.source},
             .says = fmt::format("{} for every polynomial q of degree ≤ {} in {}D, on irregular "
                                 "samples",
                                 row.says, Order, Dim),
             .bound = at_most(1e-12,
                              "error / condition number of M: k ≤ 200 terms rounded to ε = 1.1e-16 "
                              "in each sum, times |ωᵢ″| h² / ωᵢ ≤ 50 of the derivatives: k ε 50"),
             .measure = [q = row.quantity] { return inconsistency<Dim, Order>(q, Order); },
             .sabotaged = [q = row.quantity] { return inconsistency<Dim, Order>(q, Order + 1); }});
}

std::vector<Claim> consistency() {
    std::vector<Claim> claims;
    [&]<int... Order>(std::integer_sequence<int, Order...>) {
        (add_consistency<2, Order>(claims), ...);
        (add_consistency<3, Order>(claims), ...);
    }
    (std::make_integer_sequence<int, 4>{});
    return claims;
}

const Register claims_of_consistency{consistency()};
}  // namespace
