#pragma once

#include "solver/foundation/errors.h"
#include "solver/foundation/types.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

struct PointColumn {
    std::string name;
    std::vector<double> values;  // one per point
};

/// Points of a file, whose dimension is known at run time only, and what the file says of each.
struct PointFile {
    int dim = 0;                       // 2 or 3
    std::vector<double> coordinates;   // n × dim, one point after the other
    std::vector<PointColumn> columns;  // in the order of the file; coordinates are not among them

    std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dim); }
    /// The column of that name, or null.
    const std::vector<double>* find(std::string_view name) const;
    /// Throws InvalidInput, naming the columns there are, if there is none of that name.
    const std::vector<double>& column(std::string_view name) const;

    /// Throws InvalidInput unless dim == Dim.
    template <int Dim> Points<Dim> points_as() const {
        if (dim != Dim)
            throw InvalidInput("expected points in " + std::to_string(Dim) + "D, found points in " +
                               std::to_string(dim) + "D");
        Points<Dim> points(size());
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int d = 0; d < Dim; ++d) points[i][d] = coordinates[i * Dim + d];
        return points;
    }
};

enum class PointFormat { csv, xyz, ply, vtp };

/// Reads points in 2D or 3D with any number of scalars per point. The format is told by the first
/// bytes (PLY, VTP), then by the extension (.csv, .xyz, .ply, .vtp), then by the first line.
///  - CSV: a header that has `x`, `y` and, in 3D, `z`; every other name is a column. Lines that
///    begin with `#`, and blank ones, are skipped.
///  - XYZ: x, y, z and possibly more numbers between blanks; the further ones are `column_4`, …
///    A molecule's file (a count, a comment, a symbol before x) is read too, without the symbol.
///  - PLY 1.0: ASCII, or binary of either byte order; scalar properties of the element `vertex`.
///    In 2D if it has no `z`. Other elements (faces, …) are skipped.
///  - VTP: ASCII, or not compressed base64 or raw, inline or appended; one Piece; PointData with
///    k > 1 components become `name_0` … `name_k-1`. In 2D if all z are zero.
/// Numbers keep every bit and do not depend on the locale.
/// Throws InvalidInput "file:line:column: expected …, found …" for anything else: no such file, a
/// file of another kind or cut off, no points, a value that is not a finite number, …
PointFile read_points(const std::filesystem::path& path);

/// The same for bytes in memory; `name` stands for the file in messages, and its extension counts.
PointFile parse_points(std::string name, std::string bytes);

}  // namespace plumbline
