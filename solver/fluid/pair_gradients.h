#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/lanes.h"
#include "solver/foundation/parallel.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// mⱼ ∇ᵢωᵢⱼ of all pairs, in the precision Real, and the sums that an implicit solve needs time and again while particles
/// stay where they are.
template <class Real, int Dim> class PairGradients {
public:
    using Numbers = Lanes<Real>;
    using Vectors = LaneVector<Real, Dim>;

    /// Room for as many neighbours as the lists have; rows are filled up to whole lanes.
    void restart(const NeighbourLists& lists) {
        const std::size_t n = lists.size();
        first_.resize(n + 1);
        first_[0] = 0;
        for (Index i = 0; i < n; ++i)
            first_[i + 1] = first_[i] + (lists.of(i).size() + lanes - 1) / lanes;
        neighbours_.resize(first_[n] * lanes);
        gradients_.resize(first_[n] * lanes * Dim);
        walls.resize(n);
        flow_of_walls.resize(n);
        factors.resize(n);
    }
    /// Writes the row of particle i, one neighbour after the other.
    class Writer {
    public:
        Writer(PairGradients& all, Index i)
            : all_{all}, i_{i}, at_{all.first_[i] * lanes}, end_{all.first_[i + 1] * lanes} {}
        void add(Index j, const Vec<Dim>& gradient) {
            all_.neighbours_[at_] = j;
            const std::size_t block = at_ / lanes * lanes * Dim + at_ % lanes;
            for (int d = 0; d < Dim; ++d)
                all_.gradients_[block + static_cast<std::size_t>(d) * lanes] =
                    static_cast<Real>(gradient[d]);
            ++at_;
        }
        ~Writer() {
            while (at_ < end_) add(i_, Vec<Dim>::Zero());
        }

    private:
        PairGradients& all_;
        Index i_;
        std::size_t at_, end_;
    };

    /// Calls use(neighbours, gradients) for the neighbours of i, some at a time.
    template <class Use> [[gnu::always_inline]] void for_neighbours(Index i, Use use) const {
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
            Vectors gradient;
            const Real* const from = gradients_.data() + k * Dim * lanes;
            for_each_constant<Dim>(
                [&](auto d) { gradient.x[d] = Numbers::load(from + d * lanes); });
            use(neighbours_.data() + k * lanes, gradient);
        }
    }

    Points<Dim> walls;                  // 2 Σₖ mₖ ∇ᵢωᵢₖ over ghosts k
    std::vector<double> flow_of_walls;  // 2 Σₖ mₖ vₖ·∇ᵢωᵢₖ
    std::vector<double> factors;        // αᵢ of CollectGradients

private:
    static constexpr std::size_t lanes = Numbers::size;
    std::vector<std::size_t> first_;  // of each row, in whole lanes
    std::vector<Index> neighbours_;
    std::vector<Real> gradients_;
};

/// Fills PairGradients, for the positions and the ghosts' velocities of the step, with
/// αᵢ = 1 / (‖Σⱼ mⱼ ∇ᵢωᵢⱼ + 2 Σₖ mₖ ∇ᵢωᵢₖ‖² + Σⱼ mᵢ mⱼ ‖∇ᵢωᵢⱼ‖²), over particles j and ghosts k, 0 where nothing is near:
/// an impulse P of pressure of particle i lowers its dρᵢ/dt by P/αᵢ. Ghosts stay where they are, hence they are not
/// in the second sum. They count twice: each has the pressure of the particle that feels it, as in
/// GhostPressureForce, so that p goes on up to the wall; and its velocity mirrored at the wall, so that what pressures do
/// to velocities stays the adjoint of what velocities do to densities.
///                                                               Bender and Koschier 2017, Eqs. 8, 11
template <RadialKernel K, class Real = double, class Space = OpenSpace<K::dim>>
struct CollectGradients {
    static constexpr int dim = K::dim;
    using Reads = Quantities<Positions<dim>, Masses, Neighbourhood<dim, Space>, GhostPositions<dim>,
                             GhostVelocities<dim>, GhostMasses, GhostNeighbourhood<dim, Space>>;
    using Writes = Quantities<PairGradients<Real, dim>>;
    K w;

    void run(double, const Positions<dim>& x, const Masses& m,
             const Neighbourhood<dim, Space>& near, const GhostPositions<dim>& ghosts,
             const GhostVelocities<dim>& v_ghost, const GhostMasses& m_ghost,
             const GhostNeighbourhood<dim, Space>& near_ghosts,
             PairGradients<Real, dim>& pairs) const {
        pairs.restart(near.lists);
        parallel_for(x.size(), [&](std::size_t index) {
            const auto i = static_cast<Index>(index);
            typename PairGradients<Real, dim>::Writer row(pairs, i);
            double squares = 0.0;
            const Vec<dim> fluid =
                near.template sum<Vec<dim>>(x, i, [&](const auto& n) -> Vec<dim> {
                    Vec<dim> g = m[n.j] * gradient(w, n);
                    squares += m[i] / m[n.j] * g.squaredNorm();
                    row.add(n.j, g);
                    return g;
                });
            double flow = 0.0;
            pairs.walls[i] =
                near_ghosts.template sum<Vec<dim>>(x, i, ghosts, [&](const auto& n) -> Vec<dim> {
                    Vec<dim> g = 2.0 * m_ghost[n.j] * gradient(w, n);
                    flow += g.dot(v_ghost[n.j]);
                    return g;
                });
            pairs.flow_of_walls[i] = flow;
            const double sum = (fluid + pairs.walls[i]).squaredNorm() + squares;
            pairs.factors[i] = sum > 0.0 ? 1.0 / sum : 0.0;
        });
    }
};

}  // namespace plumbline
