#include "solver/io/poly_data.h"

#include "solver/io/vtk_xml.h"

#include <numeric>

namespace plumbline {

namespace {
void check(const PolyData& data) {
    const auto reject = [](const std::string& what, std::size_t expected, std::size_t found) {
        throw InvalidInput("VTP: " + what + ": expected " + std::to_string(expected) +
                           " values, found " + std::to_string(found));
    };
    if (data.xyz.size() % 3 != 0) reject("points", 3 * data.points() + 3, data.xyz.size());
    for (const PolyData::Array& a : data.arrays)
        if (a.values.size() != data.points() * static_cast<std::size_t>(a.components))
            reject(a.name, data.points() * static_cast<std::size_t>(a.components), a.values.size());
    for (const std::int64_t corner : data.corners)
        if (corner < 0 || static_cast<std::size_t>(corner) >= data.points())
            throw InvalidInput("VTP: expected corners below " + std::to_string(data.points()) +
                               ", found " + std::to_string(corner));
}

struct Kind {
    const char *count, *element;
    std::size_t corners;
};
Kind kind_of(PolyData::Cells cells) {
    switch (cells) {
        case PolyData::Cells::edges:
            return {"NumberOfLines", "Lines", 2};
        case PolyData::Cells::triangles:
            return {"NumberOfPolys", "Polys", 3};
        default:
            return {"NumberOfVerts", "Verts", 1};
    }
}
}  // namespace

std::vector<double> in_space(std::span<const double> vectors, int dim) {
    const auto n = static_cast<std::size_t>(dim);
    std::vector<double> xyz;
    xyz.reserve(vectors.size() / n * 3);
    for (std::size_t k = 0; k < vectors.size(); ++k) {
        xyz.push_back(vectors[k]);
        if (k % n == n - 1) xyz.resize(xyz.size() + 3 - n, 0.0);
    }
    return xyz;
}

void write_vtp(std::ostream& out, const PolyData& data, VtpEncoding encoding) {
    check(data);
    const Kind kind = kind_of(data.kind);
    std::vector<std::int64_t> corners = data.corners;
    if (data.kind == PolyData::Cells::points) {
        corners.resize(data.points());
        std::iota(corners.begin(), corners.end(), 0);
    }
    std::vector<std::int64_t> ends(corners.size() / kind.corners);
    for (std::size_t k = 0; k < ends.size(); ++k)
        ends[k] = static_cast<std::int64_t>((k + 1) * kind.corners);
    begin_vtk(out, "PolyData");
    out << "<Piece NumberOfPoints=\"" << data.points() << "\" " << kind.count << "=\""
        << ends.size() << "\">\n<Points>\n";
    write_vtk_array(out, "Points", 3, data.xyz, encoding);
    out << "</Points>\n<PointData>\n";
    for (const PolyData::Array& a : data.arrays)
        write_vtk_array(out, a.name, a.components, a.values, encoding);
    out << "</PointData>\n<" << kind.element << ">\n";
    write_vtk_array(out, "connectivity", corners, encoding);
    write_vtk_array(out, "offsets", ends, encoding);
    out << "</" << kind.element << ">\n</Piece>\n";
    end_vtk(out, "PolyData");
}

}  // namespace plumbline
