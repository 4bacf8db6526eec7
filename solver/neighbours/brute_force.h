#pragma once

#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/queries.h"

#include <concepts>

namespace plumbline {

/// O(n²); the oracle that every other search is compared with.                adams2009 Sec. 5
template <int Dim, class Space = OpenSpace<Dim>, class Real = double>
class BruteForce : public Queries<BruteForce<Dim, Space, Real>, Dim, Real> {
    using Given = std::span<const VecOf<Real, Dim>>;

public:
    static constexpr std::string_view name = "brute_force";

    BruteForce() requires std::default_initializable<Space> : BruteForce(Space{}) {}
    explicit BruteForce(Space space) : space_{space} {}

    void build(Given points, double radius) {
        check_radius<Real>(space_, radius);
        check_points(space_, points);
        points_.assign(points.begin(), points.end());
        radius_ = radius;
    }
    void find(Given queries, Radii radii, NeighbourLists& lists) const {
        fill_lists(queries.size(), lists, [&](std::size_t i, std::vector<Index>& row) {
            const auto r = static_cast<Real>(radii.of(i));
            for (Index j = 0; j < points_.size(); ++j)
                if (squared_distance(space_, queries[i], points_[j]) < r * r) row.push_back(j);
        });
    }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t memory() const { return points_.size() * sizeof(VecOf<Real, Dim>); }

private:
    Space space_;
    std::vector<VecOf<Real, Dim>> points_;
    double radius_ = 0.0;
};

}  // namespace plumbline
