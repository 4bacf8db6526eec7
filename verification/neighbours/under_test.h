#pragma once

#include "solver/neighbours/hash_grid.h"
#include "solver/neighbours/kd_tree.h"
#include "verification/framework/mutant.h"
#include "verification/neighbours/printed_hash_grid.h"
#include "verification/neighbours/printed_kd_tree.h"

#include <type_traits>

namespace verification {

inline constinit Mutant alg_4_with_one_radius{16, "Alg. 4 with d = r", "query of a hash grid"};
inline constinit Mutant eq_43_in_signed_numbers{26, "Eq. 43 in signed numbers", "hash of a cell"};
inline constinit Mutant alg_3_without_modulus{26, "Alg. 3: a sum without mod s", "hash of a cell"};
inline constinit Mutant alg_1_by_value{27, "Alg. 1: x < median to the left",
                                       "construction of a kd-tree"};

/// The seam of the hash: the bucket of a cell, of a table of `size`, or a number that is none.
template <int Dim> std::int64_t bucket_under_test(const plumbline::Cell<Dim>& cell, int size) {
    if (eq_43_in_signed_numbers.applied()) return printed_hash<Dim>(cell, size);
    if (alg_3_without_modulus.applied()) return static_cast<std::int64_t>(printed_sum<Dim>(cell));
    return static_cast<std::int64_t>(plumbline::hash<Dim>(cell, static_cast<std::size_t>(size)));
}

// The seams of the searches, in open space and with one radius, as the text has them. Where a printed
// form would access what is not there, or never end, they throw.

template <int Dim>
class HashGridUnderTest : public plumbline::Queries<HashGridUnderTest<Dim>, Dim> {
public:
    static constexpr std::string_view name = plumbline::HashGrid<Dim>::name;

    void build(std::span<const plumbline::Vec<Dim>> points, double radius) {
        grid_.build(points, radius);
        if (alg_4_with_one_radius.applied()) printed_.build(points, radius);
        constexpr int size = 4093;
        const plumbline::EndlessGrid<Dim, plumbline::OpenSpace<Dim>> cells({}, 2.0 * radius);
        for (const auto& x : points) {
            const std::int64_t bucket = bucket_under_test<Dim>(cells.cell(x), size);
            if (bucket < 0 || bucket >= size)
                throw std::out_of_range("the table has no bucket " + std::to_string(bucket));
        }
    }
    void find(std::span<const plumbline::Vec<Dim>> queries, plumbline::Radii radii,
              plumbline::NeighbourLists& lists) const {
        if (!radii.vary() && alg_4_with_one_radius.applied())
            lists = printed_.query(queries);
        else
            grid_.find(queries, radii, lists);
    }
    const plumbline::OpenSpace<Dim>& space() const { return grid_.space(); }
    double radius() const { return grid_.radius(); }

private:
    plumbline::HashGrid<Dim> grid_;
    PrintedHashGrid<Dim> printed_{1.0};
};

/// Where Algorithm 1 ends, its lists are those of any other tree.
template <int Dim> class KdTreeUnderTest : public plumbline::KdTree<Dim> {
public:
    explicit KdTreeUnderTest(plumbline::OpenSpace<Dim> space = {}, plumbline::Index leaf_size = 16)
        : plumbline::KdTree<Dim>(space, leaf_size), leaf_size_{leaf_size} {}

    void build(std::span<const plumbline::Vec<Dim>> points, double radius) {
        constexpr int endless = 1000;
        if (alg_1_by_value.applied() &&
            depth_of_algorithm_1<Dim>({points.begin(), points.end()}, leaf_size_, 0, endless) ==
                endless)
            throw std::runtime_error("Algorithm 1 has not ended at depth 1000");
        plumbline::KdTree<Dim>::build(points, radius);
    }

private:
    plumbline::Index leaf_size_;
};

}  // namespace verification
