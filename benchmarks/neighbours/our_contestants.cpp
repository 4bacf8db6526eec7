#include "benchmarks/neighbours/contestant_forms.h"
#include "solver/neighbours/hash_grid.h"
#include "solver/neighbours/kd_tree.h"
#include "solver/neighbours/leaf_tree.h"
#include "solver/neighbours/level_grid.h"
#include "solver/neighbours/skin_lists.h"

#include <numeric>
#include <optional>

namespace benchmarks {

namespace {
using namespace plumbline;

NeighbourLists sorted_lists(std::vector<std::vector<Index>>& rows) {
    NeighbourLists lists{{0}, {}};
    for (std::vector<Index>& row : rows) {
        std::ranges::sort(row);
        lists.indices.insert(lists.indices.end(), row.begin(), row.end());
        lists.offsets.push_back(lists.indices.size());
    }
    return lists;
}

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
        return sorted_lists(rows);
    }
    std::string form() const override { return "each pair once, as found"; }
    bool is_full_answer() const override { return false; }
    bool has_own_radii() const override { return false; }
};

/// Lengths of rows only. The answer is the rows of the same grid, but none where the length is not that counted.
template <int Dim> class Counts : public Searching<Dim, CellGrid<Dim>> {
public:
    using typename Contestant<Dim>::Lists;

    void query(std::span<const double> radii, Lists&) override {
        radii_.assign(radii.begin(), radii.end());
        if (radii.empty())
            this->search().count(counts_);
        else
            this->search().count(radii, counts_);
    }
    Lists answer(const Lists&) const override {
        PackedLists packed;
        if (radii_.empty())
            this->search().pack(packed);
        else
            this->search().pack(radii_, packed);
        Lists lists = ascending(packed), as_counted{{0}, {}};
        for (Index i = 0; i < lists.size(); ++i) {
            const auto row = lists.of(i);
            if (counts_[i] == row.size())
                as_counted.indices.insert(as_counted.indices.end(), row.begin(), row.end());
            as_counted.offsets.push_back(as_counted.indices.size());
        }
        return as_counted;
    }
    std::size_t answer_bytes(const Lists&) const override { return counts_.size() * sizeof(Index); }
    std::string form() const override { return "lengths of rows only"; }
    bool is_full_answer() const override { return false; }

private:
    std::vector<Index> counts_;
    std::vector<double> radii_;
};

/// Each row is handed to a function, which adds up its numbers, and is not stored.
template <int Dim> class Callback : public Searching<Dim, CellGrid<Dim>> {
public:
    using typename Contestant<Dim>::Lists;

    void query(std::span<const double> radii, Lists&) override {
        radii_.assign(radii.begin(), radii.end());
        sums_.resize(this->points().size());
        visit_rows([&](Index i, std::span<const Index> row) {
            sums_[i] = std::accumulate(row.begin(), row.end(), std::uint64_t{0});
        });
    }
    /// Rows handed out once more, but none where their sum is another.
    Lists answer(const Lists&) const override {
        std::vector<std::vector<Index>> rows(sums_.size());
        visit_rows([&](Index i, std::span<const Index> row) {
            if (std::accumulate(row.begin(), row.end(), std::uint64_t{0}) == sums_[i])
                rows[i].assign(row.begin(), row.end());
        });
        return sorted_lists(rows);
    }
    std::size_t answer_bytes(const Lists&) const override {
        return sums_.size() * sizeof(std::uint64_t);
    }
    std::string form() const override { return "rows handed to a function, as found, not stored"; }
    bool is_full_answer() const override { return false; }

private:
    template <class Visit> void visit_rows(Visit visit) const {
        if (radii_.empty())
            this->search().for_each_row(visit);
        else
            this->search().for_each_row(radii_, visit);
    }
    std::vector<std::uint64_t> sums_;
    std::vector<double> radii_;
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
            maker<Dim, SortedForm<Dim, LevelGrid<Dim>>>("level_grid"),
            maker<Dim, PackedForm<Dim, CellGrid<Dim>>>("cell_grid_packed"),
            maker<Dim, PackedForm<Dim, LeafTree<Dim>>>("leaf_tree_packed"),
            maker<Dim, PackedForm<Dim, LevelGrid<Dim>>>("level_grid_packed"),
            maker<Dim, SinglePrecision<Dim>>("cell_grid_single"),
            maker<Dim, Pairs<Dim>>("cell_grid_pairs"),
            maker<Dim, Counts<Dim>>("cell_grid_counts"),
            maker<Dim, Callback<Dim>>("cell_grid_callback"),
            maker<Dim, Skin<Dim>>("skin_lists")};
}
template std::vector<ContestantMaker<2>> our_contestants<2>();
template std::vector<ContestantMaker<3>> our_contestants<3>();

}  // namespace benchmarks
