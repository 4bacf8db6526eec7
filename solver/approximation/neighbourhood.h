#pragma once

#include "solver/foundation/sum.h"
#include "solver/kernels/kernel.h"
#include "solver/neighbours/neighbour_lists.h"
#include "solver/neighbours/space.h"

#include <cmath>
#include <concepts>
#include <optional>
#include <type_traits>

namespace plumbline {

/// A sample j, as another one, i, sees it.
template <int Dim> struct Neighbour {
    Index j;
    Vec<Dim> x;  // xᵢ − xⱼ, between nearest images [m]
    double r;    // ‖x‖ [m]
};

/// ∇ᵢω(‖xᵢ − xⱼ‖), 0 where both coincide                                      adams2009 Eq. 10
template <RadialKernel K> Vec<K::dim> gradient(const K& w, const Neighbour<K::dim>& n) {
    if (n.r == 0.0) return Vec<K::dim>::Zero();
    return w.derivative(n.r) / n.r * n.x;
}

/// What `Term` returns for a neighbour.
template <class Term, int Dim> using TermValue = std::invoke_result_t<Term, const Neighbour<Dim>&>;

/// What returns exactly T for a neighbour: an Eigen expression would outlive its operands.
template <class Term, class T, int Dim>
concept TermOf = std::same_as<TermValue<Term, Dim>, T>;

/// The neighbours of each particle, whatever search found them and in whatever space. Lists may hold
/// more than what is within the support, where kernels are 0.
template <int Dim, class Space = OpenSpace<Dim>> struct Neighbourhood {
    NeighbourLists lists;
    std::optional<Space> space = {};  // set by whoever fills the lists

    /// Σⱼ term(neighbour) over the neighbours of particle i, itself included, in the order of the
    /// lists.
    template <class T, TermOf<T, Dim> Term>
    T sum(std::span<const Vec<Dim>> x, Index i, Term term) const {
        return sum<T>(x, i, x, term);
    }
    /// The same where the neighbours of particle i are of another set, at `others`.
    template <class T, TermOf<T, Dim> Term>
    T sum(std::span<const Vec<Dim>> x, Index i, std::span<const Vec<Dim>> others, Term term) const {
        T total = zero<T>();
        const Vec<Dim>& x_i = x[i];
        for (const Index j : lists.of(i)) {
            Neighbour<Dim> n{j, {}, 0.0};
            for (int d = 0; d < Dim; ++d) n.x[d] = space->difference(x_i[d], others[j][d], d);
            n.r = n.x.norm();
            total += term(n);
        }
        return total;
    }
};

/// The ghosts near each particle.
template <int Dim, class Space = OpenSpace<Dim>>
struct GhostNeighbourhood : Neighbourhood<Dim, Space> {};

}  // namespace plumbline
