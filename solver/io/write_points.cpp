#include "solver/io/write_points.h"

#include "solver/io/csv.h"
#include "solver/io/vtk_xml.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace plumbline {

namespace {
std::vector<std::string> checked_names(const PointFile& points) {
    std::vector<std::string> names = {"x", "y"};
    if (points.dim == 3) names.push_back("z");
    for (const PointColumn& c : points.columns) {
        if (c.values.size() != points.size())
            throw InvalidInput("column " + in_quotes(c.name) + ": expected " +
                               std::to_string(points.size()) + " values, one per point, found " +
                               std::to_string(c.values.size()));
        if (c.name.empty() || c.name == "z" || std::ranges::find(names, c.name) != names.end())
            throw InvalidInput("expected a name of its own for each column, found " +
                               in_quotes(c.name) + (c.name.empty() ? "" : " twice"));
        names.push_back(c.name);
    }
    return names;
}

/// Calls visit(value) for every value, point by point: the coordinates, then the columns.
template <class Visit> void for_each_value_of(const PointFile& points, std::size_t i, Visit visit) {
    const auto dim = static_cast<std::size_t>(points.dim);
    for (std::size_t d = 0; d < dim; ++d) visit(points.coordinates[i * dim + d]);
    for (const PointColumn& c : points.columns) visit(c.values[i]);
}

void append_bytes(std::string& bytes, double value, bool big_endian) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian == (std::endian::native == std::endian::little))
        std::reverse(std::begin(raw), std::end(raw));
    bytes.append(raw, sizeof raw);
}
}  // namespace

void write_points_csv(std::ostream& out, const PointFile& points) {
    CsvWriter csv(out, checked_names(points));
    for (std::size_t i = 0; i < points.size(); ++i) {
        for_each_value_of(points, i, [&](double value) { csv.add(value); });
        csv.end_row();
    }
}

void write_points_ply(std::ostream& out, const PointFile& points, PlyEncoding encoding) {
    constexpr std::string_view formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const auto names = checked_names(points);
    out << "ply\nformat " << formats[static_cast<std::size_t>(encoding)] << " 1.0\nelement vertex "
        << points.size() << '\n';
    for (const std::string& name : names) {
        if (name.find_first_of(" \t\r\n") != name.npos)
            throw InvalidInput("a PLY file: expected a name without blanks, found " +
                               in_quotes(name));
        out << "property double " << name << '\n';
    }
    out << "end_header\n";
    std::string row;
    for (std::size_t i = 0; i < points.size(); ++i) {
        row.clear();
        for_each_value_of(points, i, [&](double value) {
            if (encoding == PlyEncoding::ascii)
                row.append(row.empty() ? "" : " ").append(digits17(value));
            else
                append_bytes(row, value, encoding == PlyEncoding::big_endian);
        });
        if (encoding == PlyEncoding::ascii) row += '\n';
        out << row;
    }
}

void write_points_vtp(std::ostream& out, const PointFile& points, VtpEncoding encoding) {
    checked_names(points);
    std::vector<double> xyz;
    for (std::size_t i = 0; i < points.coordinates.size(); ++i) {
        xyz.push_back(points.coordinates[i]);
        if (points.dim == 2 && i % 2 == 1) xyz.push_back(0.0);
    }
    begin_vtk(out, "PolyData");
    out << "<Piece NumberOfPoints=\"" << points.size() << "\">\n<Points>\n";
    write_vtk_array(out, "Points", 3, xyz, encoding);
    out << "</Points>\n<PointData>\n";
    for (const PointColumn& c : points.columns) write_vtk_array(out, c.name, 1, c.values, encoding);
    out << "</PointData>\n</Piece>\n";
    end_vtk(out, "PolyData");
}

}  // namespace plumbline
