#include "benchmarks/neighbours/contestant_forms.h"
#include "solver/neighbours/hash_grid.h"
#include "solver/neighbours/kd_tree.h"
#include "solver/neighbours/leaf_tree.h"
#include "solver/neighbours/skin_lists.h"

#include <optional>

namespace benchmarks {

namespace {
using namespace plumbline;

/// Positions and distances in single precision, lists as found.
template <int Dim> class SinglePrecision : public Contestant<Dim> {
public:
    using typename Contestant<Dim>::Points;
    using typename Contestant<Dim>::Lists;

    void take(Points points) override {
        Contestant<Dim>::take(points);
        single_.clear();
        for (const Vec<Dim>& x : points) single_.push_back(x.template cast<float>());
    }
    void build(double radius) override { grid_.build(single_, radius); }
    void update() override { grid_.build(single_, grid_.radius()); }
    void query(std::span<const double> radii, Lists&) override {
        if (radii.empty())
            grid_.query(Given(single_), packed_);
        else
            grid_.query(Given(single_), radii, packed_);
    }
    Lists answer(const Lists&) const override { return ascending(packed_); }
    std::size_t answer_bytes(const Lists&) const override { return packed_.memory(); }
    std::string form() const override { return "lists as found, single precision"; }
    bool is_full_answer() const override { return false; }
    bool is_single_precision() const override { return true; }

private:
    using Point = VecOf<float, Dim>;
    using Given = std::span<const Point>;
    std::vector<Point> single_;
    CellGrid<Dim, OpenSpace<Dim>, float> grid_;
    PackedLists packed_;
};

/// Each pair once.
template <int Dim> class Pairs : public PackedForm<Dim, CellGrid<Dim>> {
public:
    using typename Contestant<Dim>::Lists;

    void query(std::span<const double>, Lists&) override {
        this->search().pack_pairs(this->packed_);
    }
    Lists answer(const Lists&) const override {
        std::vector<std::vector<Index>> rows(this->packed_.size());
        for (Index i = 0; i < rows.size(); ++i) {
            rows[i].push_back(i);
            for (const Index j : this->packed_.of(i)) {
                rows[i].push_back(j);
                rows[j].push_back(i);
            }
        }
        Lists lists{{0}, {}};
        for (std::vector<Index>& row : rows) {
            std::ranges::sort(row);
            lists.indices.insert(lists.indices.end(), row.begin(), row.end());
            lists.offsets.push_back(lists.indices.size());
        }
        return lists;
    }
    std::string form() const override { return "each pair once, as found"; }
    bool is_full_answer() const override { return false; }
    bool has_own_radii() const override { return false; }
};

/// Lists with a skin of 0.2 radii; a query takes the neighbours out of them.
template <int Dim> class Skin : public Contestant<Dim> {
public:
    using typename Contestant<Dim>::Lists;

    void build(double radius) override {
        if (!skin_ || skin_->radius() != radius) skin_.emplace(radius, 0.2 * radius);
        skin_->build(this->points());
    }
    void update() override { skin_->update(this->points()); }
    bool has_update() const override { return true; }
    void query(std::span<const double>, Lists&) override { skin_->exact(packed_); }
    Lists answer(const Lists&) const override { return ascending(packed_); }
    std::size_t answer_bytes(const Lists&) const override { return packed_.memory(); }
    std::string form() const override { return "lists as found"; }
    bool has_own_radii() const override { return false; }

private:
    std::optional<SkinLists<Dim>> skin_;
    PackedLists packed_;
};
}  // namespace

template <int Dim> std::vector<ContestantMaker<Dim>> our_contestants() {
    return {maker<Dim, SortedForm<Dim, CellGrid<Dim>>>("cell_grid"),
            maker<Dim, SortedForm<Dim, HashGrid<Dim>>>("hash_grid"),
            maker<Dim, SortedForm<Dim, HashGrid<Dim, HashSpacing::radius>>>("hash_grid_r"),
            maker<Dim, SortedForm<Dim, KdTree<Dim>>>("kd_tree"),
            maker<Dim, SortedForm<Dim, LeafTree<Dim>>>("leaf_tree"),
            maker<Dim, PackedForm<Dim, CellGrid<Dim>>>("cell_grid_packed"),
            maker<Dim, PackedForm<Dim, LeafTree<Dim>>>("leaf_tree_packed"),
            maker<Dim, SinglePrecision<Dim>>("cell_grid_single"),
            maker<Dim, Pairs<Dim>>("cell_grid_pairs"),
            maker<Dim, Skin<Dim>>("skin_lists")};
}
template std::vector<ContestantMaker<2>> our_contestants<2>();
template std::vector<ContestantMaker<3>> our_contestants<3>();

}  // namespace benchmarks
