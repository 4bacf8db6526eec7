#include "solver/surface/isosurface.h"

#include <Eigen/Geometry>

namespace plumbline {

namespace {
/// Goes through the grid layer by layer; the vertices of two layers at a time can be found by edge.
template <int Dim> class March {
public:
    March(const ScalarGrid<Dim>& field, double level, const CellTable<Dim>& table)
        : field_{field}, level_{level}, table_{table} {
        for (int d = 0; d < Dim; ++d) stride_[d] = field.stride(d);
        layer_ = stride_[Dim - 1];
        vertex_of_.resize(2 * layer_ * Dim);
    }

    Isosurface<Dim> run() {
        for (std::size_t node = 0; node < field_.values.size(); node += layer_) {
            for (std::size_t k = 0; k < layer_; ++k) add_vertices(node + k);
            if (node > 0)
                for (std::size_t k = 0; k < layer_; ++k) add_facets(node - layer_ + k);
        }
        return std::move(surface_);
    }

private:
    bool is_inside(std::size_t node) const { return field_.values[node] < level_; }

    void add_vertices(std::size_t node) {
        const auto place = field_.place(node);
        for (int d = 0; d < Dim; ++d)
            if (place[d] + 1 < field_.size[d] && is_inside(node) != is_inside(node + stride_[d]))
                add_vertex(node, d);
    }
    void add_vertex(std::size_t node, int axis) {
        const std::size_t other = node + stride_[axis];
        const double f = field_.values[node], g = field_.values[other];
        const double share = std::isfinite(g - f) ? (level_ - f) / (g - f) : 0.5;
        vertex_of_[slot(node, axis)] = static_cast<Index>(surface_.vertices.size());
        Vec<Dim> x = field_.position(node);
        x[axis] += share * field_.spacing;
        surface_.vertices.push_back(x);
        const Vec<Dim> slope = (1.0 - share) * gradient_at(node) + share * gradient_at(other);
        const double length = slope.norm();
        surface_.normals.push_back(length > 0.0 && std::isfinite(length) ? Vec<Dim>(slope / length)
                                                                         : Vec<Dim>::Zero());
    }
    /// By central differences, one-sided at the rim [unit of the field per spacing].
    Vec<Dim> gradient_at(std::size_t node) const {
        const auto place = field_.place(node);
        Vec<Dim> slope;
        for (int d = 0; d < Dim; ++d) {
            const bool first = place[d] == 0, last = place[d] + 1 == field_.size[d];
            const double high = field_.values[last ? node : node + stride_[d]];
            const double low = field_.values[first ? node : node - stride_[d]];
            slope[d] = (high - low) / (first || last ? 1.0 : 2.0);
        }
        return slope;
    }

    void add_facets(std::size_t node) {
        const auto place = field_.place(node);
        for (int d = 0; d + 1 < Dim; ++d)
            if (place[d] + 1 == field_.size[d]) return;
        std::size_t inside = 0;
        for (int corner = 0; corner < 1 << Dim; ++corner)
            inside |= static_cast<std::size_t>(is_inside(node_of(node, corner))) << corner;
        const CellCase<Dim>& cell = table_[inside];
        for (int k = 0; k < cell.count; ++k) {
            std::array<Index, Dim> facet;
            for (int v = 0; v < Dim; ++v) {
                const int edge = cell.facets[k][v];
                facet[v] = vertex_of_[slot(node_of(node, edge / Dim), edge % Dim)];
            }
            surface_.facets.push_back(facet);
        }
    }
    std::size_t node_of(std::size_t cell, int corner) const {
        for (int d = 0; d < Dim; ++d)
            if ((corner >> d & 1) != 0) cell += stride_[d];
        return cell;
    }
    std::size_t slot(std::size_t node, int axis) const {
        return (node % (2 * layer_)) * Dim + static_cast<std::size_t>(axis);
    }

    const ScalarGrid<Dim>& field_;
    double level_;
    const CellTable<Dim>& table_;
    std::array<std::size_t, Dim> stride_;
    std::size_t layer_;
    std::vector<Index> vertex_of_;
    Isosurface<Dim> surface_;
};

/// A facet's normal times its area; in the plane its length, to the right of it.
Vec<2> area_vector(const Isosurface<2>& s, const std::array<Index, 2>& facet) {
    const Vec<2> along = s.vertices[facet[1]] - s.vertices[facet[0]];
    return {along[1], -along[0]};
}
Vec<3> area_vector(const Isosurface<3>& s, const std::array<Index, 3>& facet) {
    const Vec<3>&a = s.vertices[facet[0]], &b = s.vertices[facet[1]], &c = s.vertices[facet[2]];
    return 0.5 * (b - a).cross(c - a);
}
}  // namespace

template <int Dim>
Isosurface<Dim> isosurface(const ScalarGrid<Dim>& field, double level,
                           const CellTable<Dim>& table) {
    if (field.values.size() != field.nodes())
        throw InvalidInput("isosurface: expected " + std::to_string(field.nodes()) +
                           " values, one per node, found " + std::to_string(field.values.size()));
    for (const std::size_t along : field.size)
        if (along < 2)
            throw InvalidInput("isosurface: expected at least 2 nodes along each axis, found " +
                               std::to_string(along));
    return March<Dim>(field, level, table).run();
}

template <int Dim> double volume(const Isosurface<Dim>& surface) {
    double sum = 0.0;
    for (const auto& facet : surface.facets)
        sum += surface.vertices[facet[0]].dot(area_vector(surface, facet));
    return sum / Dim;
}

template <int Dim> double area(const Isosurface<Dim>& surface) {
    double sum = 0.0;
    for (const auto& facet : surface.facets) sum += area_vector(surface, facet).norm();
    return sum;
}

template Isosurface<2> isosurface(const ScalarGrid<2>&, double, const CellTable<2>&);
template Isosurface<3> isosurface(const ScalarGrid<3>&, double, const CellTable<3>&);
template double volume(const Isosurface<2>&);
template double volume(const Isosurface<3>&);
template double area(const Isosurface<2>&);
template double area(const Isosurface<3>&);

}  // namespace plumbline
