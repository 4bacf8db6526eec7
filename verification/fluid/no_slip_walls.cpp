#include "solver/fluid/no_slip_walls.h"

#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/jittered.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace no_slip_walls_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// v = v_w + γ y along x, of disordered fluid above a wall that moves with v_w; the wall's particles lie three spacings
/// deep. max |vₖ − (v_w + γ yₖ)| of those with fluid near them, over γ h; `speed` is what the pass takes for v_w.
template <int Dim> double error_of_shear(double speed) {
    constexpr double h = 2.6, gamma = 0.7, speed_of_wall = 1.3;
    using W = WendlandC2<Dim>;
    MirrorPlane<Dim> plane{Vec<Dim>::Zero(), Vec<Dim>::Unit(Dim - 1)};
    plane.velocity[0] = speed;
    Scene scene{Given<Positions<Dim>, Velocities<Dim>, IsWall>{},
                FindNeighbours<Dim, CellGrid<Dim>>{h}, StickToWalls<W>{W(h), {plane}}};
    Vec<Dim> low = Vec<Dim>::Constant(-5.0), high = -low;
    low[Dim - 1] = -3.0, high[Dim - 1] = 4.0;
    const auto shear = [&](const Vec<Dim>& x) { return speed_of_wall + gamma * x[Dim - 1]; };
    for (const Vec<Dim>& x : jittered<Dim>({low, high}, 1.0, 0.2, 1)) {
        const bool wall = x[Dim - 1] < 0.0;
        scene.template get<Positions<Dim>>().push_back(x);
        scene.template get<IsWall>().push_back(wall ? 1 : 0);
        scene.template get<Velocities<Dim>>().push_back(wall ? Vec<Dim>(Vec<Dim>::Zero())
                                                             : shear(x) * Vec<Dim>::Unit(0));
    }
    scene.step(0.0);
    const auto& x = scene.template get<Positions<Dim>>();
    const auto& v = scene.template get<Velocities<Dim>>();
    double worst = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k)
        if (x[k][Dim - 1] < 0.0 && x[k][Dim - 1] > -1.2)
            worst = std::max(worst, std::abs(v[k][0] - shear(x[k])));
    return worst / (gamma * h);
}

const Register shear{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "no_slip_walls.continue_a_shear_flow",
                 .source = {Paper::plumbline, "docstring of StickToWalls"},
                 .says =
                     "velocities of a moving wall's particles below a shear flow of disordered "
                     "particles, against "
                     "its continuation; wrong: the wall is taken to be at rest",
                 .bound = at_most(
                     1e-13,
                     "sums of up to 200 terms, of one size, and their ratio: 200 · 1.1e-16, a few "
                     "times over where little fluid is near"),
                 .measure = [] { return error_of_shear<D>(1.3); },
                 .sabotaged = [] { return error_of_shear<D>(0.0); }};
})};
}  // namespace
}  // namespace no_slip_walls_claims
