#include "solver/fluid/surface_tension.h"

#include "solver/kernels/wendland_c2.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/particles/lattice.h"
#include "solver/scene/find_neighbours.h"
#include "solver/scene/scene.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

#include <numbers>

namespace surface_tension_claims {
namespace {
using namespace plumbline;
using namespace verification;

constexpr double h = 3.0;
template <int Dim> constexpr double radius = Dim == 2 ? 20.0 : 10.0;

/// The accelerations that a tension of 1 gives on a lattice of density 1, of which a ball, not in its middle, has the
/// colour 1; or all of it.
template <int Dim, class Visit> void around_ball(bool free_surface, Visit visit) {
    const Vec<Dim> centre = Vec<3>(0.21, 0.37, 0.13).template head<Dim>();
    const auto around = Vec<Dim>::Constant(radius<Dim> + 5.0);
    using W = WendlandC2<Dim>;
    Scene scene{Given<Positions<Dim>, Masses, Density, Colour>{},
                FindNeighbours<Dim, CellGrid<Dim>>{h}, SurfaceTension<W>{W(h), 1.0}};
    for (const Vec<Dim>& x : lattice<Dim>({-around, around}, 1.0)) {
        const bool inside = (x - centre).norm() < radius<Dim>;
        if (free_surface && !inside) continue;
        scene.template get<Positions<Dim>>().push_back(x);
        scene.template get<Colour>().push_back(inside ? 1.0 : 0.0);
    }
    const std::size_t n = scene.template get<Positions<Dim>>().size();
    scene.template get<Masses>().assign(n, 1.0);
    scene.template get<Density>().assign(n, 1.0);
    scene.step(0.0);
    for (std::size_t i = 0; i < n; ++i)
        visit(Vec<Dim>(scene.template get<Positions<Dim>>()[i] - centre),
              scene.template get<Accelerations<Dim>>()[i]);
}
/// −∫ a_r dr over the mean of all directions, in units of (dim − 1)/R: what the pressure jumps by.
template <int Dim> double jump_of_pressure(bool free_surface) {
    double jump = 0.0;
    around_ball<Dim>(free_surface, [&](const Vec<Dim>& x, const Vec<Dim>& a) {
        const double r = x.norm();
        if (r < radius<Dim> - h || r > radius<Dim> + h) return;
        const double sphere =
            Dim == 2 ? 2.0 * std::numbers::pi * r : 4.0 * std::numbers::pi * r * r;
        jump -= a.dot(x) / r / sphere;
    });
    return jump / ((Dim - 1) / radius<Dim>);
}

const Register laplace{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "surface_tension.law_of_laplace",
        .source = {Paper::literature, "Müller et al. 2003; Laplace's law"},
        .says =
            "the pressure that balances the force jumps by σ (dim − 1)/R: measured over "
            "exact, R of 20 (in space 10) spacings; at a free surface, where no colour "
            "changes, there is no force at all",
        .bound = between(0.8, 1.2,
                         "the law holds to (h/R)², 2 % and 9 %; the ball is made of cubes: "
                         "its volume and surface are off by less than a tenth of that"),
        .measure = [] { return jump_of_pressure<D>(false); },
        .sabotaged = [] { return jump_of_pressure<D>(true); }};
})};
}  // namespace
}  // namespace surface_tension_claims
