#pragma once

#include "solver/io/csv.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace verification {

/// A table of reference_data/, found by its name in whichever folder holds it.
class Reference {
public:
    /// Throws InvalidInput if there is no such table.
    explicit Reference(const std::string& name);

    std::size_t rows() const { return table_.rows(); }
    /// The numbers of a column, NaN where one is missing. Throws InvalidInput for an unknown column.
    const std::vector<double>& operator[](const std::string& column) const;
    const std::vector<std::string>& text(const std::string& column) const {
        return table_.text(column);
    }

private:
    plumbline::CsvTable table_;
    mutable std::map<std::string, std::vector<double>> numbers_;
};

/// The folder reference_data/ of this tree.
std::string reference_folder();

/// The numbers of one row, by the names of the columns.
struct ReferenceRow {
    const Reference& table;
    std::size_t index;
    double operator()(const std::string& column) const { return table[column][index]; }
};

/// max |printed − exact(row)| / max(|exact(row)|, floor) over the rows that have a number in
/// `column`. `floor` belongs to columns whose values go through zero. NaN if none has one.
double worst_difference(const Reference& table, const std::string& column,
                        const std::function<double(const ReferenceRow&)>& exact,
                        double floor = 1e-300);

/// The largest relative error of a number rounded to `digits` significant ones, with as much again
/// for the double in which it is computed anew: 5 · 10^−digits · 1.01.
double rounding_to(int digits);

}  // namespace verification
