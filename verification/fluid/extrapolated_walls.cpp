#include "solver/fluid/extrapolated_walls.h"

#include "solver/kernels/wendland_c2.h"
#include "solver/particles/jittered.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace extrapolated_walls_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// max |p − exact| at points up to a spacing outside of an irregular fluid of density 1, with p = 20 + g·x; `gravity` is
/// what the pass is told of g.
template <int Dim> double error_at_rest(double gravity) {
    constexpr double spacing = 1.0, edge = 6.0;
    const Vec<Dim> g = Vec<3>(0.4, -1.0, 0.3).head<Dim>();
    const Box<Dim> box{Vec<Dim>::Zero(), Vec<Dim>::Constant(edge)};
    Positions<Dim> x;
    const auto points = jittered<Dim>(box, spacing, 0.3, 1);
    x.assign(points.begin(), points.end());
    Density rho;
    Pressure p;
    IsWall wall;
    for (const Vec<Dim>& at : x) p.push_back(20.0 + g.dot(at));
    rho.assign(x.size(), 1.0), wall.assign(x.size(), 0);
    Points<Dim> places;
    for (int k = 0; k < 12; ++k) {
        Vec<Dim> at = Vec<Dim>::Constant(0.5 * k);
        at[k % Dim] = k % 2 == 0 ? -spacing : edge + spacing;
        places.push_back(at);
    }
    FluidNearWalls<Dim> near;
    const WendlandC2<Dim> w(2.6 * spacing);
    near.find(x, wall, places, w.support());
    double worst = 0.0;
    for (Index k = 0; k < places.size(); ++k)
        worst = std::max(worst, std::abs(near.pressure(k, places[k], w, gravity * g, rho, p) -
                                         (20.0 + g.dot(places[k]))));
    return worst;
}

const Register at_rest{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "extrapolated_walls.exact_at_rest",
                 .source = {Paper::literature, "Adami, Hu and Adams 2012, Eq. 27"},
                 .says =
                     "pressure at 12 points of walls around an irregular fluid at rest, p linear, "
                     "density 1: largest error; wrong: the mean of the pressures around",
                 .bound = at_most(2e-13,
                                  "a mean of up to 30 numbers near 20, each with 6 roundings: 36 · "
                                  "1.1e-16 · 20 = 8e-14, twice as much for sum and quotient"),
                 .measure = [] { return error_at_rest<D>(1.0); },
                 .sabotaged = [] { return error_at_rest<D>(0.0); }};
})};
}  // namespace
}  // namespace extrapolated_walls_claims
