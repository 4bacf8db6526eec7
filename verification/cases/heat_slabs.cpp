#include "solver/particles/lattice.h"
#include "verification/cases/conduction.h"
#include "verification/framework/registry.h"

#include <numbers>

namespace heat_slabs_claims {
namespace {
using namespace plumbline;
using namespace verification;

// Half spaces of temperature 0 and conductivity 1, x < 0, and of 1 and 10, x > 0, in contact since t = 0. They end
// where the heat does not get to: erfc(0.8 / 0.2) = 2e-8, erfc(2 / 0.63) = 8e-6.
constexpr double duration = 0.01, cold_end = -0.8, hot_end = 2.0, ratio = 10.0;

/// The temperature of the contact is that of the effusivities √(k ρ c).
double exact(double x) {
    const double contact = std::sqrt(ratio) / (1.0 + std::sqrt(ratio));
    if (x <= 0.0) return contact * std::erfc(-x / (2.0 * std::sqrt(duration)));
    return 1.0 - (1.0 - contact) * std::erfc(x / (2.0 * std::sqrt(ratio * duration)));
}

using Mean = double (*)(double mine, double theirs);
double arithmetic(double a, double b) { return 0.5 * (a + b); }
double its_own(double a, double) { return a; }

/// HeatConduction with another mean of the conductivities.
struct ConductionByMean {
    using Space = PeriodicBox<2>;
    using Reads = HeatConduction<WendlandC2<2>, Space>::Reads;
    using Writes = Quantities<Rate<Temperature>>;
    WendlandC2<2> w;
    Mean mean;

    void run(double, const Positions<2>& x, const Masses& m, const Density& rho,
             const Temperature& T, const Conductivity& k, const HeatCapacity& c,
             const Neighbourhood<2, Space>& near, Rate<Temperature>& rate) const {
        for (Index i = 0; i < x.size(); ++i)
            rate[i] += near.sum<double>(x, i, [&](const Neighbour<2>& n) -> double {
                if (n.r == 0.0) return 0.0;
                return m[n.j] / (rho[i] * rho[n.j]) * 2.0 * mean(k[i], k[n.j]) *
                       (-w.derivative(n.r) / n.r) * (T[n.j] - T[i]) / c[i];
            });
    }
};

/// √ mean (T − exact)² of the particles with |x| < 0.8; `mean` null: by HeatConduction itself.
double error(double spacing, Mean mean) {
    const double height = 9.0 * spacing;
    Solid<2> solid{{Vec<2>(cold_end - 1.0, 0.0), Vec<2>(hot_end + 1.0, height)},
                   spacing,
                   4.0 * spacing,
                   {},
                   {},
                   {}};
    solid.x = lattice<2>({Vec<2>(cold_end, 0.0), Vec<2>(hot_end, height)}, spacing);
    for (const Vec<2>& x : solid.x) {
        solid.temperature.push_back(x[0] > 0.0 ? 1.0 : 0.0);
        solid.conductivity.push_back(x[0] > 0.0 ? ratio : 1.0);
    }
    const WendlandC2<2> w(solid.support);
    const auto T = mean
                       ? conduct(solid, ConductionByMean{w, mean}, duration)
                       : conduct(solid, HeatConduction<WendlandC2<2>, PeriodicBox<2>>{w}, duration);
    double squares = 0.0, n = 0.0;
    for (std::size_t i = 0; i < T.size(); ++i) {
        if (std::abs(solid.x[i][0]) > 0.8) continue;
        const double off = T[i] - exact(solid.x[i][0]);
        squares += off * off, ++n;
    }
    return std::sqrt(squares / n);
}

const Register claims_of_slabs{
    Claim{.id = "heat_slabs.harmonic_mean",
          .source = {Paper::literature, "Cleary and Monaghan 1999"},
          .says = "temperature error, L2, of two slabs of conductivities 1 and 10, 25 particles "
                  "per unit; with the arithmetic mean the contact is three times as thin as it is",
          .bound = at_most(
              0.0094,
              "smoothing: k t T⁗ Σ V (−ω′/r) x⁴/12 = 0.01 · 0.0175 h² T⁗ with h = 4/25 and T⁗ = 2 "
              "· 0.76 · 0.55/(2 k t)² at the worst place, of a step of the height 2 · 0.76"),
          .measure = [] { return error(1.0 / 25.0, nullptr); },
          .sabotaged = [] { return error(1.0 / 25.0, arithmetic); }},
    Study{
        .id = "heat_slabs.error_over_spacing",
        .source = {Paper::literature, "Cleary and Monaghan 1999"},
        .says =
            "heat through a jump of the conductivity from 1 to 10: to first order in the end, with "
            "the harmonic mean as with the arithmetic one, whose error is ten times as large; with "
            "no mean, each particle by its own conductivity, the flux jumps, and nothing converges",
        .quantity = "temperature error, L2, over the spacing [m]",
        .spacing = {1.0 / 20, 1.0 / 25, 1.0 / 30, 1.0 / 35},
        .seeds = 1,
        .series = {{"harmonic mean",
                    between(0.7, 2.3,
                            "2 as long as smoothing over h² is most of it, 1 once the layer of "
                            "pairs across the contact is, whose breadth is h: their flux is right "
                            "on the whole, not one by one")},
                   {"arithmetic mean",
                    between(0.7, 1.3,
                            "1: pairs across conduct (k₁ + k₂)²/(4 k₁ k₂) = 3 times as much as "
                            "they should, in a layer of breadth h")},
                   {"its own conductivity", between(0.7, 2.3, "a wrong flux: no convergence"),
                    false, true}},
        .errors = [](double spacing, std::uint64_t) {
            return std::vector{error(spacing, nullptr), error(spacing, arithmetic),
                               error(spacing, its_own)};
        }}};
}  // namespace
}  // namespace heat_slabs_claims
