#include "solver/fluid/ghost_density.h"

#include "solver/fluid/sph_density.h"
#include "verification/fluid/wall_in_a_lattice.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"

namespace ghost_density_claims {
namespace {
using namespace plumbline;
using namespace verification;

/// The difference of a lattice that is fluid throughout from one with a wall, with its ghosts or without.
template <int Dim> double difference(bool with_ghosts) {
    using Wall = WallInALattice<Dim>;
    using W = typename Wall::W;
    const W w = Wall::kernel();
    const auto everything = Wall::evaluate(false, SphDensity<W>{w});
    if (!with_ghosts)
        return Wall::template difference<Density>(everything,
                                                  Wall::evaluate(true, SphDensity<W>{w}));
    return Wall::template difference<Density>(
        everything, Wall::evaluate(true, SphDensity<W>{w}, AddGhostDensity<W>{w}));
}

/// Σ over ghosts of mₖ ω at one of them, for a row with `spacing`, and for a ghost alone: |… − ρ₀| / ρ₀.
template <int Dim> double error_of_masses(double spacing, bool one_mass) {
    const WendlandC2<Dim> w(2.5);
    Points<Dim> row;
    for (int k = -8; k <= 8; ++k) row.push_back(spacing * k * Vec<Dim>::Unit(0));
    CellGrid<Dim> search;
    search.build(row, w.support());
    const auto masses = ghost_masses<WendlandC2<Dim>>(w, row, search.query(row), 1000.0);
    double sum = 0.0;
    for (std::size_t k = 0; k < row.size(); ++k)
        sum += (one_mass ? 1000.0 * std::pow(spacing, Dim) : masses[k]) * w.value(row[k].norm());
    return std::abs(sum / 1000.0 - 1.0);
}

const Register same{in_dimensions<2, 3>([]<int D>() {
    return Claim{.id = "ghost_density.ghosts_stand_for_fluid",
                 .source = {Paper::adams2009, "Eq. 55; Sec. 6.3"},
                 .says =
                     "densities at a wall whose ghosts continue the lattice are those inside; "
                     "without ghosts they are those of a free surface",
                 .bound = at_most(rounding_of_walls, same_pairs),
                 .measure = [] { return difference<D>(true); },
                 .sabotaged = [] { return difference<D>(false); }};
})};
const Register masses{in_dimensions<2, 3>([]<int D>() {
    return Claim{
        .id = "ghost_density.masses_fill_the_wall",
        .source = {Paper::literature, "Akinci et al. 2012"},
        .says =
            "inside a row of ghosts, sparse or dense, Σ mₖ ω is the rest density; with the mass "
            "of a fluid particle for each it is not",
        .bound = at_most(2e-15, "up to 10 terms: 10 · 1.1e-16, and the quotient"),
        .measure =
            [] { return std::max(error_of_masses<D>(0.7, false), error_of_masses<D>(3.0, false)); },
        .sabotaged = [] { return error_of_masses<D>(0.7, true); },
        .erratum = 36};
})};
const Register erratum_of_ghosts{
    Erratum{36,
            {Paper::adams2009, "Eqs. 55-57; Sec. 6.3"},
            "pₖ, ρₖ, mₖ of ghosts are not defined",
            "mₖ = ρ₀/Σₗ ωₖₗ; pressure and density are those of the particle that feels the ghost"}};
}  // namespace
}  // namespace ghost_density_claims
