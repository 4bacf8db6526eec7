#include "solver/io/write_surface.h"

#include "solver/io/csv.h"

namespace plumbline {

namespace {
template <int Dim> std::string in_digits(const Vec<Dim>& x) {
    std::string text = digits17(x[0]) + " " + digits17(x[1]) + " ";
    return text + (Dim == 3 ? digits17(x[Dim - 1]) : "0");
}
template <int Dim> std::vector<double> flat(const Points<Dim>& points) {
    return in_space({points.empty() ? nullptr : points[0].data(), points.size() * Dim}, Dim);
}
}  // namespace

template <int Dim> void write_surface_obj(std::ostream& out, const Isosurface<Dim>& surface) {
    for (const Vec<Dim>& x : surface.vertices) out << "v " << in_digits<Dim>(x) << '\n';
    for (const Vec<Dim>& n : surface.normals) out << "vn " << in_digits<Dim>(n) << '\n';
    for (const auto& facet : surface.facets) {
        out << (Dim == 3 ? 'f' : 'l');
        for (const Index v : facet) {
            out << ' ' << v + 1;
            if (Dim == 3) out << "//" << v + 1;
        }
        out << '\n';
    }
}

template <int Dim> void write_surface_ply(std::ostream& out, const Isosurface<Dim>& surface) {
    out << "ply\nformat ascii 1.0\nelement vertex " << surface.vertices.size() << '\n';
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        out << "property double " << name << '\n';
    out << "element " << (Dim == 3 ? "face " : "edge ") << surface.facets.size() << '\n'
        << (Dim == 3 ? "property list uchar uint vertex_indices\n"
                     : "property uint vertex1\nproperty uint vertex2\n")
        << "end_header\n";
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
        out << in_digits<Dim>(surface.vertices[v]) << ' ' << in_digits<Dim>(surface.normals[v])
            << '\n';
    for (const auto& facet : surface.facets) {
        if (Dim == 3) out << "3 ";
        for (int k = 0; k < Dim; ++k) out << facet[k] << (k + 1 < Dim ? ' ' : '\n');
    }
}

template <int Dim> PolyData poly_data_of(const Isosurface<Dim>& surface) {
    PolyData data{.xyz = flat<Dim>(surface.vertices),
                  .arrays = {{"normals", 3, flat<Dim>(surface.normals)}},
                  .kind = Dim == 2 ? PolyData::Cells::edges : PolyData::Cells::triangles};
    for (const auto& facet : surface.facets)
        data.corners.insert(data.corners.end(), facet.begin(), facet.end());
    return data;
}

template void write_surface_obj(std::ostream&, const Isosurface<2>&);
template void write_surface_obj(std::ostream&, const Isosurface<3>&);
template void write_surface_ply(std::ostream&, const Isosurface<2>&);
template void write_surface_ply(std::ostream&, const Isosurface<3>&);
template PolyData poly_data_of(const Isosurface<2>&);
template PolyData poly_data_of(const Isosurface<3>&);

}  // namespace plumbline
