#include "benchmarks/neighbours/particle_order.h"

#include "solver/foundation/random.h"
#include "solver/neighbours/cell_order.h"
#include "solver/particles/hilbert_order.h"

namespace benchmarks {

namespace {
using namespace plumbline;

template <int Dim> std::vector<Index> by_cell(const PointCloud<Dim>& cloud) {
    CellOrder<Dim> cells;
    cells.sort(CellFrame<Dim>::around(cloud.points, cloud.radius), cloud.points);
    return {cells.order(), cells.order() + cloud.points.size()};
}

std::vector<Index> shuffled(std::size_t n, std::uint64_t seed) {
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index{0});
    Random random(seed);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
    return order;
}

template <class T>
std::vector<T> taken(const std::vector<T>& from, const std::vector<Index>& order) {
    std::vector<T> to;
    to.reserve(order.size());
    for (const Index i : order) to.push_back(from[i]);
    return to;
}
}  // namespace

std::vector<std::string> order_names() {
    return {"as_given", "shuffled", "by_cell", "morton", "hilbert"};
}

template <int Dim>
void reorder(PointCloud<Dim>& cloud, const std::string& order, std::uint64_t seed) {
    const auto apply = [&](const std::vector<Index>& by) {
        cloud.points = taken(cloud.points, by);
        if (!cloud.radii.empty()) cloud.radii = taken(cloud.radii, by);
    };
    if (order == "shuffled")
        apply(shuffled(cloud.points.size(), seed));
    else if (order == "by_cell")
        apply(by_cell(cloud));
    else if (order == "morton")
        apply(morton_order<Dim>(cloud.points));
    else if (order == "hilbert")
        apply(hilbert_order<Dim>(cloud.points));
    else if (order != "as_given")
        throw InvalidInput("no order \"" + order +
                           "\"; expected one of: as_given shuffled by_cell morton hilbert");
    cloud.order = order;
}
template void reorder<2>(PointCloud<2>&, const std::string&, std::uint64_t);
template void reorder<3>(PointCloud<3>&, const std::string&, std::uint64_t);

}  // namespace benchmarks
