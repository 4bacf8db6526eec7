#include "solver/scene/algorithm_5.h"

#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace algorithm_5_claims {
namespace {
using namespace plumbline;
using namespace verification;

enum class Slip { none, no_tension_scaling, old_velocities_move, half_of_the_cells };

/// Algorithm 5 once more, in plain loops over all pairs, with a slip of the pen if asked for.
template <int Dim> struct PlainLoops {
    Drop<Dim> drop;
    SphParameters<Dim> p;
    WendlandC2<Dim> w{Drop<Dim>::support};
    Slip slip;

    void step(double dt) {
        auto& [x, v, m] = drop;
        const std::size_t n = x.size();
        std::vector<double> rho(n, 0.0), pressure(n);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                if (feels(x[i], x[j])) rho[i] += m[j] * w.value((x[i] - x[j]).norm());
            pressure[i] = p.equation.pressure(rho[i]);
            if (pressure[i] < 0.0 && slip != Slip::no_tension_scaling) pressure[i] *= p.zeta;
        }
        Points<Dim> a(n, p.gravity), towards(n, Vec<Dim>::Zero());
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                if (!feels(x[i], x[j])) continue;
                const Vec<Dim> d = x[i] - x[j];
                const double P = pressure[i] / (rho[i] * rho[i]) + pressure[j] / (rho[j] * rho[j]);
                a[i] -= m[j] * P * gradient(w, d);
                towards[i] += 2.0 * m[j] / (rho[i] + rho[j]) * w.value(d.norm()) * (v[j] - v[i]);
            }
        const Points<Dim> old = v;
        for (std::size_t i = 0; i < n; ++i) {
            v[i] += p.xsph.of(dt) * towards[i] + dt * a[i];
            x[i] += dt * (slip == Slip::old_velocities_move ? old[i] : v[i]);
        }
    }
    /// All neighbours; or, as Algorithms 4 and 5 have it printed, those in 2^dim cells of the size of the
    /// support, on the sides on which the particle lies in its own cell.
    bool feels(const Vec<Dim>& x_i, const Vec<Dim>& x_j) const {
        if (slip != Slip::half_of_the_cells) return true;
        for (int d = 0; d < Dim; ++d) {
            const double own = std::floor(x_i[d] / w.support());
            const double side = x_i[d] / w.support() - own < 0.5 ? -1.0 : 1.0;
            const double other = std::floor(x_j[d] / w.support()) - own;
            if (other != 0.0 && other != side) return false;
        }
        return true;
    }
};
template <int Dim> SphParameters<Dim> parameters() {
    return {TaitEquation(1.0, 10.0, 7.0), 0.25, {0.05, 1e-2}, -9.81 * Vec<Dim>::Unit(Dim - 1)};
}
/// max ‖x − x′‖ after ten steps, over the spacing.
template <int Dim> double difference(Slip slip) {
    auto scene = algorithm_5(WendlandC2<Dim>(Drop<Dim>::support), parameters<Dim>());
    fill(scene, Drop<Dim>{});
    PlainLoops<Dim> loops{.drop = Drop<Dim>{}, .p = parameters<Dim>(), .slip = slip};
    for (int n = 0; n < 10; ++n) scene.step(1e-2), loops.step(1e-2);
    double worst = 0.0;
    for (std::size_t i = 0; i < loops.drop.x.size(); ++i)
        worst = std::max(worst, (scene.template get<Positions<Dim>>()[i] - loops.drop.x[i]).norm());
    return worst;
}
constexpr const char* ten_steps =
    "ten steps of sums of 70 terms, to 1e-14 of accelerations up to 1e3, Δt² = 1e-4: 1e-14 · 1e3 · "
    "1e-4 · "
    "55, doubled by each of ten steps at most";

template <int Dim> Claim as_loops(std::string_view id, std::string_view says, Slip slip) {
    return {.id = "algorithm_5." + std::string(id),
            .source = {Paper::adams2009, "Alg. 5"},
            .says = std::string(says),
            .bound = at_most(1e-10, ten_steps),
            .measure = [] { return difference<Dim>(Slip::none); },
            .sabotaged = [slip] { return difference<Dim>(slip); }};
}
const Register composition{in_dimensions<2, 3>([]<int D>() {
    return as_loops<D>("is_the_printed_loop",
                       "positions after ten steps are those of plain loops over all pairs; not if "
                       "positions move with old velocities",
                       Slip::old_velocities_move);
})};
const Register tension{in_dimensions<2, 3>([]<int D>() {
    return as_loops<D>(
        "scales_tension",
        "positions after ten steps are those of plain loops; not if negative pressures "
        "stay as they are",
        Slip::no_tension_scaling);
})};
const Register neighbours{in_dimensions<2, 3>([]<int D>() {
    Claim claim =
        as_loops<D>("finds_all_neighbours",
                    "positions after ten steps are those of plain loops; not of a grid of cells "
                    "as large as the support, of which Algorithm 4 visits 2^dim",
                    Slip::half_of_the_cells);
    claim.erratum = 16;
    return claim;
})};
}  // namespace
}  // namespace algorithm_5_claims
