#pragma once

#include "solver/approximation/neighbourhood.h"
#include "solver/foundation/quantities.h"
#include "solver/particles/quantities.h"

namespace plumbline {

/// The space of a search: where its points live.
template <class Search>
using SpaceOf = std::remove_cvref_t<decltype(std::declval<const Search&>().space())>;

/// The neighbours of every particle, and itself, closer than `radius`.            adams2009 Sec. 5
template <int Dim, NeighbourSearch<Dim> Search> struct FindNeighbours {
    using Space = SpaceOf<Search>;
    using Reads = Quantities<Positions<Dim>>;
    using Writes = Quantities<Neighbourhood<Dim, Space>>;
    double radius;  // [m], the largest support of the kernels
    Search search = Search();

    void run(double, const Positions<Dim>& x, Neighbourhood<Dim, Space>& near) const {
        Search built = search;
        built.build(x, radius);
        built.query(x, near.lists);
        near.space = built.space();
    }
};

/// The ghosts closer than `radius` to every particle.                         adams2009 Eq. 55
template <int Dim, NeighbourSearch<Dim> Search> struct FindGhosts {
    using Space = SpaceOf<Search>;
    using Reads = Quantities<Positions<Dim>, GhostPositions<Dim>>;
    using Writes = Quantities<GhostNeighbourhood<Dim, Space>>;
    double radius;  // [m], the largest support of the kernels
    Search search = Search();

    void run(double, const Positions<Dim>& x, const GhostPositions<Dim>& ghosts,
             GhostNeighbourhood<Dim, Space>& near) const {
        Search built = search;
        built.build(ghosts, radius);
        built.query(x, near.lists);
        near.space = built.space();
    }
};

/// Moves every particle to its image inside a box that repeats without end.
template <int Dim> struct WrapIntoBox {
    using Reads = Quantities<>;
    using Writes = Quantities<Positions<Dim>>;
    PeriodicBox<Dim> box;

    void run(double, Positions<Dim>& x) const {
        for (Vec<Dim>& x_i : x) x_i = box.wrap(x_i);
    }
};

}  // namespace plumbline
