#include "solver/fluid/heat_conduction.h"

#include "verification/fluid/drop.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace heat_conduction_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// A drop with temperatures, conductivities and heat capacities between 1/2 and 3/2, at random.
template <int Dim> auto heated(bool one_temperature = false) {
    const Drop<Dim> drop;
    const double h = Drop<Dim>::support;
    Scene scene{
        Given<Positions<Dim>, Velocities<Dim>, Masses, Temperature, Conductivity, HeatCapacity>{},
        FindNeighbours<Dim, BruteForce<Dim>>{h}, SphDensity<WendlandC2<Dim>>{WendlandC2<Dim>(h)},
        HeatConduction<WendlandC2<Dim>>{WendlandC2<Dim>(h)}};
    fill(scene, drop);
    Random random(2);
    const auto fill_one = [&](auto& q) {
        for (std::size_t i = 0; i < drop.x.size(); ++i) q.push_back(random.uniform(0.5, 1.5));
    };
    fill_one(scene.template get<Temperature>());
    fill_one(scene.template get<Conductivity>());
    fill_one(scene.template get<HeatCapacity>());
    if (one_temperature) std::ranges::fill(scene.template get<Temperature>(), 0.7);
    scene.step(0.0);
    return scene;
}
/// |Σ m c dT/dt| / Σ |…|, or without c.
template <int Dim> double total(bool with_capacity) {
    const auto scene = heated<Dim>();
    const auto& m = scene.template get<Masses>();
    const auto& c = scene.template get<HeatCapacity>();
    double sum = 0.0, size = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        const double heat =
            m[i] * (with_capacity ? c[i] : 1.0) * scene.template get<Rate<Temperature>>()[i];
        sum += heat, size += std::abs(heat);
    }
    return std::abs(sum) / size;
}
/// sign · dT/dt where T is the greatest of its neighbourhood: the largest.
template <int Dim> double heating_of_the_hottest(double sign) {
    const auto scene = heated<Dim>();
    const auto& T = scene.template get<Temperature>();
    const auto& lists = scene.template get<Neighbourhood<Dim>>().lists;
    double largest = -HUGE_VAL;
    for (Index i = 0; i < T.size(); ++i)
        if (std::ranges::all_of(lists.of(i), [&](Index j) { return T[j] <= T[i]; }))
            largest = std::max(largest, sign * scene.template get<Rate<Temperature>>()[i]);
    return largest;
}
template <int Dim> double heating_at_one_temperature(bool one) {
    double largest = 0.0;
    const auto scene = heated<Dim>(one);
    for (const double rate : scene.template get<Rate<Temperature>>())
        largest = std::max(largest, std::abs(rate));
    return largest;
}

/// |dT/dt of one of two particles of conductivities 1 and 9 / expected − 1|, with this mean of both.
template <int Dim> double error_of_exchange(double mean) {
    const WendlandC2<Dim> w(1.0);
    Scene scene{Given<Positions<Dim>, Masses, Temperature, Conductivity, HeatCapacity>{},
                FindNeighbours<Dim, BruteForce<Dim>>{1.0}, SphDensity<WendlandC2<Dim>>{w},
                HeatConduction<WendlandC2<Dim>>{w}};
    scene.template get<Positions<Dim>>().assign({Vec<Dim>::Zero(), 0.5 * Vec<Dim>::Unit(0)});
    scene.template get<Masses>().assign(2, 1.0);
    scene.template get<Temperature>().assign({0.0, 1.0});
    scene.template get<Conductivity>().assign({1.0, 9.0});
    scene.template get<HeatCapacity>().assign(2, 1.0);
    scene.step(0.0);
    const double rho = w.value(0.0) + w.value(0.5);
    const double expected = 2.0 * mean * -w.derivative(0.5) / 0.5 / (rho * rho);
    return std::abs(scene.template get<Rate<Temperature>>()[0] / expected - 1.0);
}

const Register conserved{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "heat_conduction.conserves_heat",
                 .source = {Paper::literature, "Cleary and Monaghan 1999"},
                 .says = "|Σ m c dT/dt| / Σ |…| = 0 for irregular particles of different materials",
                 .bound = at_most(rounding_of_pairs, sums_of_pairs),
                 .measure = [] { return total<D>(true); },
                 .sabotaged = [] { return total<D>(false); }};
})};
const Register hottest{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "heat_conduction.cools_the_hottest",
                 .source = {Paper::literature, "Cleary and Monaghan 1999"},
                 .says = "dT/dt < 0 where T is the greatest among its neighbours",
                 .bound = at_most(0.0, "every term has Tⱼ − Tᵢ ≤ 0 and −ω′/r ≥ 0"),
                 .measure = [] { return heating_of_the_hottest<D>(1.0); },
                 .sabotaged = [] { return heating_of_the_hottest<D>(-1.0); }};
})};
const Register constant{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "heat_conduction.one_temperature_stays",
                 .source = {Paper::literature, "Cleary and Monaghan 1999"},
                 .says = "max |dT/dt| of particles that have one temperature",
                 .bound = at_most(0.0, "every term has the factor Tⱼ − Tᵢ, which is 0 exactly"),
                 .measure = [] { return heating_at_one_temperature<D>(true); },
                 .sabotaged = [] { return heating_at_one_temperature<D>(false); }};
})};
const Register jump{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "heat_conduction.takes_the_harmonic_mean",
        .source = {Paper::literature, "Cleary and Monaghan 1999"},
        .says =
            "two particles of conductivities 1 and 9 exchange heat by 2 · 9/(1 + 9) = 1.8, "
            "as two slabs in series do; by 5, the arithmetic mean, they do not",
        .bound = at_most(2e-15, "a dozen roundings on both sides"),
        .measure = [] { return error_of_exchange<D>(1.8); },
        .sabotaged = [] { return error_of_exchange<D>(5.0); }};
})};
}  // namespace
}  // namespace heat_conduction_claims
