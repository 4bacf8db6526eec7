#pragma once

#include "solver/neighbours/endless_grid.h"
#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/queries.h"

#include <concepts>

namespace plumbline {

/// H(i, j, k) = (i p₁ xor j p₂ xor k p₃) mod s, in unsigned arithmetic.       adams2009 Eq. 43
/// Algorithm 3 prints a sum without the modulus, and signed numbers have negative remainders:
/// erratum 26. The primes are those of Teschner et al. 2003, which Eq. 43 is from.
template <int Dim> std::size_t hash(const Cell<Dim>& cell, std::size_t table_size) {
    constexpr std::array<std::uint64_t, 3> prime{73856093, 19349663, 83492791};
    std::uint64_t mixed = 0;
    for (int axis = 0; axis < Dim; ++axis)
        mixed ^= static_cast<std::uint64_t>(cell[axis]) * prime[axis];
    return static_cast<std::size_t>(mixed % table_size);
}

/// The smallest prime that is not below n: remainders then depend on all digits of the hash.
inline std::size_t prime_from(std::size_t n) {
    const auto is_prime = [](std::size_t p) {
        for (std::size_t d = 3; d * d <= p; d += 2)
            if (p % d == 0) return false;
        return p % 2 == 1;
    };
    for (n = std::max<std::size_t>(n, 3); !is_prime(n);) ++n;
    return n;
}

/// The spacing of a hash grid for queries of radius r: the ball meets 3^Dim cells of spacing r, but
/// only 2^Dim cells of spacing 2r, the nearest ones.                         adams2009 Sec. 5.2
enum class HashSpacing { radius, diameter };

/// A hash grid: O(n) to build, for one radius and an even density.
/// adams2009 Algs. 3, 4; Eqs. 42, 43. Algorithm 4 visits 2^Dim cells, and its caption says d = r, which
/// loses neighbours: erratum 16. Here both spacings visit the cells that the ball meets. Cells that
/// share a bucket do not make a point count twice: each bucket is searched once.
template <int Dim, HashSpacing Spacing = HashSpacing::diameter, class Space = OpenSpace<Dim>>
class HashGrid : public Queries<HashGrid<Dim, Spacing, Space>, Dim> {
public:
    static constexpr std::string_view name =
        Spacing == HashSpacing::diameter ? "hash_grid" : "hash_grid_r";

    /// The table has about n / `load` buckets for n points.
    HashGrid() requires std::default_initializable<Space> : HashGrid(Space{}) {}
    explicit HashGrid(Space space, double load = 1.0) : space_{space}, load_{load} {
        if (!(load > 0.0)) throw InvalidInput("HashGrid: expected a load above 0");
    }

    void build(std::span<const Vec<Dim>> points, double radius) {
        check_radius(space_, radius);
        check_points(space_, points);
        radius_ = radius;
        grid_ = {space_, Spacing == HashSpacing::diameter ? 2.0 * radius : radius};
        const auto n = points.size();
        const std::size_t table_size =
            prime_from(static_cast<std::size_t>(static_cast<double>(n) / load_));
        std::vector<std::size_t> bucket(n);
        parallel_for(
            n, [&](std::size_t i) { bucket[i] = hash<Dim>(grid_.cell(points[i]), table_size); });
        first_.assign(table_size + 1, 0);
        for (const std::size_t b : bucket) ++first_[b + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        points_.resize(n);
        order_.resize(n);
        std::vector<Index> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < n; ++i) {
            const Index k = next[bucket[i]]++;
            points_[k] = points[i];
            order_[k] = static_cast<Index>(i);
        }
    }

    void find(std::span<const Vec<Dim>> queries, Radii radii, NeighbourLists& lists) const {
        fill_lists(queries.size(), lists, [&](std::size_t i, std::vector<Index>& row) {
            const double r = radii.of(i);
            for_each_bucket(queries[i], r, [&](Index first, Index last) {
                for (Index k = first; k < last; ++k)
                    if (squared_distance(space_, queries[i], points_[k]) < r * r)
                        row.push_back(order_[k]);
            });
        });
    }

    /// Calls bucket(first, last) with the range of points of each bucket that a cell near x falls in.
    template <class Bucket>
    void for_each_bucket(const Vec<Dim>& x, double radius, Bucket bucket) const {
        const CellRange<Dim> range = grid_.around(x, radius);
        if (range.count() > static_cast<double>(buckets()))
            return bucket(0, static_cast<Index>(points_.size()));
        thread_local std::vector<std::size_t> visit;
        visit.clear();
        range.for_each([&](const Cell<Dim>& cell) {
            visit.push_back(hash<Dim>(grid_.image(cell), buckets()));
        });
        std::ranges::sort(visit);
        visit.erase(std::unique(visit.begin(), visit.end()), visit.end());
        for (const std::size_t b : visit) bucket(first_[b], first_[b + 1]);
    }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t buckets() const { return first_.empty() ? 0 : first_.size() - 1; }
    std::size_t memory() const {
        return points_.size() * (sizeof(Vec<Dim>) + sizeof(Index)) + first_.size() * sizeof(Index);
    }

private:
    Space space_;
    double load_, radius_ = 0.0;
    EndlessGrid<Dim, Space> grid_;
    Points<Dim> points_;        // bucket after bucket
    std::vector<Index> order_;  // points_[k] was given as point order_[k]
    std::vector<Index> first_;  // of each bucket, and the end
};

}  // namespace plumbline
