#include "benchmarks/neighbours/local_radii.h"

#include "solver/foundation/parallel.h"

#include <nanoflann.hpp>

#include <cmath>

namespace benchmarks {

namespace {
using namespace plumbline;

template <int Dim> struct Cloud {
    const Points<Dim>& x;
    std::size_t kdtree_get_point_count() const { return x.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return x[i][static_cast<Eigen::Index>(axis)];
    }
    template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
};
}  // namespace

template <int Dim>
std::vector<double> local_radii(const Points<Dim>& points, std::size_t neighbours) {
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<
        nanoflann::L2_Simple_Adaptor<double, Cloud<Dim>, double, Index>, Cloud<Dim>, Dim, Index>;
    std::vector<double> radii(points.size(), 1.0);
    if (points.size() < 2) return radii;
    const Cloud<Dim> cloud{points};
    const Tree tree(Dim, cloud);
    const std::size_t number = std::min(neighbours + 1, points.size());  // and the point itself
    parallel_for(points.size(), [&](std::size_t i) {
        std::vector<Index> indices(number);
        std::vector<double> squares(number);
        tree.knnSearch(points[i].data(), number, indices.data(), squares.data());
        if (squares.back() > 0.0) radii[i] = std::sqrt(squares.back());
    });
    return radii;
}
template std::vector<double> local_radii<2>(const Points<2>&, std::size_t);
template std::vector<double> local_radii<3>(const Points<3>&, std::size_t);

}  // namespace benchmarks
