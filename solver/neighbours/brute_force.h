#pragma once

#include "solver/neighbours/fill_lists.h"
#include "solver/neighbours/queries.h"

namespace plumbline {

/// O(n²); the oracle that every other search is compared with.                adams2009 Sec. 5
template <int Dim, class Space = OpenSpace<Dim>>
class BruteForce : public Queries<BruteForce<Dim, Space>, Dim> {
public:
    static constexpr std::string_view name = "brute_force";

    explicit BruteForce(Space space = {}) : space_{space} {}

    void build(std::span<const Vec<Dim>> points, double radius) {
        check_radius(space_, radius);
        check_points(space_, points);
        points_.assign(points.begin(), points.end());
        radius_ = radius;
    }
    void find(std::span<const Vec<Dim>> queries, Radii radii, NeighbourLists& lists) const {
        fill_lists(queries.size(), lists, [&](std::size_t i, std::vector<Index>& row) {
            const double r = radii.of(i);
            for (Index j = 0; j < points_.size(); ++j)
                if (squared_distance(space_, queries[i], points_[j]) < r * r) row.push_back(j);
        });
    }

    const Space& space() const { return space_; }
    double radius() const { return radius_; }
    std::size_t memory() const { return points_.size() * sizeof(Vec<Dim>); }

private:
    Space space_;
    Points<Dim> points_;
    double radius_ = 0.0;
};

}  // namespace plumbline
