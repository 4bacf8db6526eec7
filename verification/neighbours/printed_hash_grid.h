#pragma once

#include "solver/neighbours/endless_grid.h"
#include "solver/neighbours/neighbour_lists.h"
#include "solver/neighbours/space.h"

#include <algorithm>
#include <array>
#include <map>

namespace verification {

/// Eq. 43 in the arithmetic of `int`, as a programmer would take it from the text: erratum 26.
template <int Dim> int printed_hash(const plumbline::Cell<Dim>& cell, int table_size) {
    constexpr std::array<std::uint32_t, 3> prime{73856093, 19349663, 83492791};
    std::int32_t mixed = 0;
    for (std::size_t a = 0; a < Dim; ++a)
        mixed ^= static_cast<std::int32_t>(static_cast<std::uint32_t>(cell[a]) * prime[a]);
    return mixed % table_size;
}
/// Algorithm 3: H ← H + pᵢ xᵢ, and no modulus.
template <int Dim> std::uint64_t printed_sum(const plumbline::Cell<Dim>& cell) {
    constexpr std::array<std::uint64_t, 3> prime{73856093, 19349663, 83492791};
    std::uint64_t sum = 0;
    for (std::size_t a = 0; a < Dim; ++a) sum += prime[a] * static_cast<std::uint64_t>(cell[a]);
    return sum;
}

/// Algorithm 4 to the letter, with the cells in a map, so that nothing but the choice of cells counts:
/// the 2^Dim cells nearest to x, of a grid whose spacing d is any number of radii. Its caption says
/// d = r, Sec. 5.2 says d = 2r: erratum 16.
template <int Dim> class PrintedHashGrid {
public:
    explicit PrintedHashGrid(double spacing_over_radius) : ratio_{spacing_over_radius} {}

    void build(std::span<const plumbline::Vec<Dim>> points, double radius) {
        radius_ = radius;
        spacing_ = ratio_ * radius;
        points_.assign(points.begin(), points.end());
        cells_.clear();
        for (plumbline::Index i = 0; i < points.size(); ++i)
            cells_[cell_of(points[i])].push_back(i);
    }
    plumbline::NeighbourLists query(std::span<const plumbline::Vec<Dim>> queries) const {
        plumbline::NeighbourLists lists{{0}, {}};
        for (const plumbline::Vec<Dim>& x : queries) {
            for (const plumbline::Index j : candidates(x))
                if (squared_distance(plumbline::OpenSpace<Dim>{}, x, points_[j]) <
                    radius_ * radius_)
                    lists.indices.push_back(j);
            std::sort(lists.indices.begin() + static_cast<std::ptrdiff_t>(lists.offsets.back()),
                      lists.indices.end());
            lists.offsets.push_back(lists.indices.size());
        }
        return lists;
    }

private:
    plumbline::Cell<Dim> cell_of(const plumbline::Vec<Dim>& x) const {
        plumbline::Cell<Dim> cell;
        for (int a = 0; a < Dim; ++a)
            cell[a] = static_cast<std::int64_t>(std::floor(x[a] / spacing_));
        return cell;
    }
    std::vector<plumbline::Index> candidates(const plumbline::Vec<Dim>& x) const {
        const plumbline::Cell<Dim> home = cell_of(x);
        std::vector<plumbline::Index> all;
        for (int corner = 0; corner < 1 << Dim; ++corner) {
            plumbline::Cell<Dim> cell = home;
            for (int a = 0; a < Dim; ++a) {
                const double inside = x[a] - static_cast<double>(home[a]) * spacing_;
                if (corner >> a & 1) cell[a] += inside < spacing_ / 2 ? -1 : 1;
            }
            const auto found = cells_.find(cell);
            if (found != cells_.end())
                all.insert(all.end(), found->second.begin(), found->second.end());
        }
        return all;
    }

    double ratio_, radius_ = 0.0, spacing_ = 1.0;
    plumbline::Points<Dim> points_;
    std::map<plumbline::Cell<Dim>, std::vector<plumbline::Index>> cells_;
};

}  // namespace verification
