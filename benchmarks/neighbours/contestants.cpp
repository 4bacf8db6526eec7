#include "benchmarks/neighbours/contestants.h"

#include "benchmarks/neighbours/cgal_kd_tree_search.h"
#include "benchmarks/neighbours/nanoflann_search.h"
#include "solver/neighbours/cell_grid.h"
#include "solver/neighbours/hash_grid.h"
#include "solver/neighbours/kd_tree.h"

namespace benchmarks {

namespace {
using namespace plumbline;

template <int Dim, VariableRadiusSearch<Dim> Search> class Entry : public Contestant<Dim> {
public:
    using typename Contestant<Dim>::Points;
    std::string name() const override { return std::string(Search::name); }
    void build(Points points, double radius) override { search_.build(points, radius); }
    void update(Points points) override {
        if constexpr (updates)
            search_.update(points);
        else
            search_.build(points, search_.radius());
    }
    bool has_update() const override { return updates; }
    void query(Points queries, std::span<const double> radii,
               NeighbourLists& lists) const override {
        if (radii.empty())
            search_.query(queries, lists);
        else
            search_.query(queries, radii, lists);
    }

private:
    static constexpr bool updates = requires(Search search, Points points) {
        search.update(points);
    };

    Search search_;
};

/// Calls visit(type_identity<Search>) for every search.
template <int Dim, class Visit> void for_each_type(Visit visit) {
    visit(std::type_identity<CellGrid<Dim>>{});
    visit(std::type_identity<HashGrid<Dim>>{});
    visit(std::type_identity<HashGrid<Dim, HashSpacing::radius>>{});
    visit(std::type_identity<KdTree<Dim>>{});
    visit(std::type_identity<NanoflannSearch<Dim, nanoflann_default_leaf>>{});
    visit(std::type_identity<NanoflannSearch<Dim, nanoflann_tuned_leaf>>{});
    visit(std::type_identity<CgalKdTreeSearch<Dim>>{});
}
}  // namespace

std::vector<std::string> contestant_names() {
    std::vector<std::string> names;
    for_each_type<3>([&]<class S>(std::type_identity<S>) { names.emplace_back(S::name); });
    return names;
}

template <int Dim> std::unique_ptr<Contestant<Dim>> make_contestant(const std::string& name) {
    std::unique_ptr<Contestant<Dim>> made;
    for_each_type<Dim>([&]<class S>(std::type_identity<S>) {
        if (S::name == name) made = std::make_unique<Entry<Dim, S>>();
    });
    if (made) return made;
    std::string expected;
    for (const std::string& known : contestant_names()) expected.append(" ").append(known);
    throw InvalidInput("no search \"" + name + "\"; expected one of:" + expected);
}
template std::unique_ptr<Contestant<2>> make_contestant<2>(const std::string&);
template std::unique_ptr<Contestant<3>> make_contestant<3>(const std::string&);

}  // namespace benchmarks
