#pragma once

#include "solver/neighbours/neighbour_lists.h"

namespace plumbline {

/// O(n²); the oracle that every other search is compared with.
template <int Dim> class BruteForce {
public:
    static constexpr std::string_view name = "brute_force";

    void build(std::span<const Vec<Dim>> points, double radius) {
        points_.assign(points.begin(), points.end());
        radius_ = radius;
    }
    NeighbourLists query(std::span<const Vec<Dim>> queries) const {
        NeighbourLists lists{{0}, {}};
        for (const Vec<Dim>& q : queries) {
            for (Index j = 0; j < points_.size(); ++j)
                if ((q - points_[j]).squaredNorm() < radius_ * radius_) lists.indices.push_back(j);
            lists.offsets.push_back(lists.indices.size());
        }
        return lists;
    }

private:
    std::vector<Vec<Dim>> points_;
    double radius_ = 0.0;
};

}  // namespace plumbline
