#pragma once

#include "solver/io/read_points.h"
#include "solver/io/source_text.h"

namespace plumbline {

// One reader per format; read_points chooses among them.
PointFile parse_csv_points(const SourceText& text);
PointFile parse_xyz_points(const SourceText& text);
PointFile parse_ply_points(const SourceText& text);
PointFile parse_vtp_points(const SourceText& text);

/// The largest number of points that an Index can tell apart.
constexpr std::size_t most_points = 0xFFFFFFFE;

/// Takes values row by row, and knows which of them are coordinates.
class PointTable {
public:
    /// `names`: of all values of a row. Without a `z` among them the points are in 2D.
    /// Call `missing_coordinate` first: `x` and `y` must be there.
    explicit PointTable(const std::vector<std::string>& names);

    void add(std::size_t column, double value) {
        if (coordinate_of_[column] >= 0)
            file_.coordinates[file_.coordinates.size() - file_.dim + coordinate_of_[column]] =
                value;
        else
            file_.columns[column_of_[column]].values.push_back(value);
    }
    void begin_row() { file_.coordinates.resize(file_.coordinates.size() + file_.dim); }
    PointFile take() { return std::move(file_); }

private:
    PointFile file_;
    std::vector<int> coordinate_of_;  // 0, 1, 2 for x, y, z; −1 otherwise
    std::vector<std::size_t> column_of_;
};

/// "x" or "y" if `names` lacks it, or empty.
std::string missing_coordinate(const std::vector<std::string>& names);

}  // namespace plumbline
