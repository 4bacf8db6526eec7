#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/cell_frame.h"

#include <numeric>
#include <vector>

namespace plumbline {

/// The points first .. last of adjacent cells of one row.
struct GroupOfCells {
    std::uint64_t row;
    std::uint32_t first_column, last_column;
    Index first, last;
};

/// The cells of one row, and where their points begin: those of column first_column + c at starts[c],
/// 0 ≤ c < columns, and at starts[columns] they end. Without a table starts is null, and the row's
/// cells first_cell .. last_cell are to be searched.
struct RowOfCells {
    const Index* starts;
    std::int64_t first_column, columns;
    Index first_cell = 0, last_cell = 0;
};

/// Points sorted by cell: row after row, in a row by column, in a cell as given. Only cells and rows
/// that hold points are kept. O(n): by counting if the grid has at most a few cells per point, else
/// digit by digit.
template <int Dim, class Real = double> class CellOrder {
    using Given = std::span<const VecOf<Real, Dim>>;

public:
    /// How many elements beyond its end each array may be read, for copies in blocks.
    static constexpr std::size_t room_beyond = 16;

    void sort(const CellFrame<Dim>& frame, Given points) {
        const std::size_t n = points.size();
        size_ = n;
        order_.resize(n + room_beyond);
        clear_cells();
        const double most = most_entries();
        has_table_ = frame.cell_count() <= most;
        if (has_table_)
            sort_by_counting(frame, points);
        else
            sort_by_digits(frame, points);
        close_cells();
        if (!has_table_) make_tables(most);
        for (int axis = 0; axis < Dim; ++axis) x_[axis].resize(n + room_beyond);
        parallel_for_parts(n, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k)
                for (int axis = 0; axis < Dim; ++axis) x_[axis][k] = points[order_[k]][axis];
        });
    }

    /// Point k, which was given as point i = order(k), is called numbers[i] from now on.
    void rename(std::span<const Index> numbers) {
        for (std::size_t k = 0; k < size_; ++k) order_[k] = numbers[order_[k]];
    }

    /// Whether these are the points that were sorted, in the order they were given.
    bool holds(Given points) const {
        if (points.size() != size_) return false;
        for (std::size_t k = 0; k < points.size(); ++k)
            for (int axis = 0; axis < Dim; ++axis)
                if (points[order_[k]][axis] != x_[axis][k]) return false;
        return true;
    }

    std::size_t size() const { return size_; }
    Index order(std::size_t k) const { return order_[k]; }
    const Index* order() const { return order_.data(); }
    const Real* x(int axis) const { return x_[axis].data(); }
    VecOf<Real, Dim> position(std::size_t k) const {
        VecOf<Real, Dim> p;
        for (int axis = 0; axis < Dim; ++axis) p[axis] = x_[axis][k];
        return p;
    }

    /// Cells are treated in parallel in blocks of so many.
    static constexpr std::size_t cells_per_block = 64;
    std::size_t blocks() const { return (cells() + cells_per_block - 1) / cells_per_block; }

    /// Calls visit(group) for each cell of a block, or for a few of its cells in a row: cells with few
    /// points share what is done for them.
    template <class Visit> void for_each_group(std::size_t block, Visit visit) const {
        const std::size_t begin = block * cells_per_block;
        const std::size_t end = std::min(cells(), begin + cells_per_block);
        std::size_t row = row_of(begin);
        for (std::size_t c = begin, next; c < end; c = next) {
            if (c == first_cell(row + 1)) ++row;
            next = end_of_group(c, std::min<std::size_t>(end, first_cell(row + 1)));
            visit(GroupOfCells{row_[row], column_[c], column_[next - 1], first_point_[c],
                               first_point_[next]});
        }
    }

    std::size_t cells() const { return column_.size(); }
    std::uint32_t column(std::size_t cell) const { return column_[cell]; }
    /// The points of a cell are first_point(cell) .. first_point(cell + 1).
    Index first_point(std::size_t cell) const { return first_point_[cell]; }

    /// Whether there is a table of all cells, empty ones too: if the grid has at most a few per point.
    bool has_table() const { return has_table_; }
    /// Any row of the table, by its number.
    RowOfCells row_in_table(std::uint64_t number) const {
        const auto columns = static_cast<std::int64_t>(columns_);
        return {start_.data() + number * columns_, 0, columns};
    }
    /// Row r of those that hold points.
    RowOfCells row_of_cells(std::size_t r) const {
        const Index first = first_cell_[r], last = first_cell_[r + 1];
        const std::int64_t least = column_[first];
        if (row_start_.empty()) return {nullptr, least, 0, first, last};
        return {start_.data() + row_start_[r], least, column_[last - 1] - least + 1};
    }
    /// The first point of a row with a table whose column is not below `column`, or the end of the row.
    static Index first_point(const RowOfCells& row, std::int64_t column) {
        return row.starts[std::clamp<std::int64_t>(column - row.first_column, 0, row.columns)];
    }
    /// The first cell of a row whose column is not below `column`, or its end; looked for from `cell` on,
    /// since who asks for one column after the other finds it nearby.
    Index first_cell(const RowOfCells& row, std::int64_t column, Index cell) const {
        while (cell > row.first_cell && column_[cell - 1] >= column) --cell;
        while (cell < row.last_cell && column_[cell] < column) ++cell;
        return cell;
    }

    std::size_t rows() const { return row_.size(); }
    std::uint64_t row(std::size_t r) const { return row_[r]; }
    /// The cells of a row are first_cell(r) .. first_cell(r + 1).
    Index first_cell(std::size_t r) const { return first_cell_[r]; }
    /// The first row whose number is not below `number`, or rows(); found in O(log distance) from
    /// `hint`, if that row is not above it, or in a table of all rows, if those are few.
    std::size_t row_from(std::uint64_t number, std::size_t hint = 0) const {
        if (!row_table_.empty()) return row_table_[std::min(number, row_.back() + 1)];
        if (hint >= rows() || row_[hint] > number) hint = 0;
        std::size_t step = 1, low = hint;
        while (low + step < rows() && row_[low + step] < number) low += step, step *= 2;
        const auto first = row_.begin() + static_cast<std::ptrdiff_t>(low);
        const auto last = row_.begin() + static_cast<std::ptrdiff_t>(std::min(low + step, rows()));
        return static_cast<std::size_t>(std::lower_bound(first, last, number) - row_.begin());
    }
    /// The row that holds a cell.
    std::size_t row_of(std::size_t cell) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(first_cell_, cell) -
                                        first_cell_.begin()) -
               1;
    }

    /// Bytes held, those kept for the next sort included.
    std::size_t memory() const {
        const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
        std::size_t all = bytes(order_) + bytes(column_) + bytes(first_point_) + bytes(row_) +
                          bytes(first_cell_) + bytes(key_) + bytes(start_) + bytes(row_start_) +
                          bytes(row_table_);
        for (const auto& coordinate : x_) all += bytes(coordinate);
        return all;
    }

private:
    /// Cells with few points are taken together, up to four columns of a row.
    std::size_t end_of_group(std::size_t begin, std::size_t end) const {
        constexpr std::uint32_t most_columns = 4, enough_points = 6;
        std::size_t next = begin + 1;
        while (next < end && column_[next] - column_[begin] < most_columns &&
               first_point_[next] - first_point_[begin] < enough_points)
            ++next;
        return next;
    }

    void clear_cells() {
        column_.clear();
        first_point_.clear();
        row_.clear();
        first_cell_.clear();
        row_start_.clear();
        row_table_.clear();
    }
    void add_cell(std::uint64_t row, std::uint32_t column, Index first_point) {
        if (row_.empty() || row_.back() != row) {
            row_.push_back(row);
            first_cell_.push_back(static_cast<Index>(column_.size()));
        }
        column_.push_back(column);
        first_point_.push_back(first_point);
    }
    void close_cells() {
        first_point_.push_back(static_cast<Index>(size_));
        first_cell_.push_back(static_cast<Index>(column_.size()));
    }

    void sort_by_counting(const CellFrame<Dim>& frame, Given points) {
        const std::size_t n = points.size();
        const std::uint32_t columns = frame.cells(0);
        key_.resize(n);
        parallel_for_parts(n, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const auto cell = frame.cell(points[i]);
                key_[i] = static_cast<Index>(frame.row(cell)) * columns + cell[0];
            }
        });
        columns_ = columns;
        const auto cells = static_cast<std::size_t>(frame.cell_count());
        start_.assign(cells + 2, 0);
        for (const Index key : key_) ++start_[key + 2];
        for (std::size_t c = 0; c < cells; ++c) {
            if (start_[c + 2] != 0)
                add_cell(c / columns, static_cast<std::uint32_t>(c % columns), start_[c + 1]);
            start_[c + 2] += start_[c + 1];
        }
        // The start of each cell stands one place behind, and moves on to that of the next cell.
        for (std::size_t i = 0; i < n; ++i) order_[start_[key_[i] + 1]++] = static_cast<Index>(i);
    }

    /// As many as there may be in a table, so that memory and time stay O(n).
    double most_entries() const { return 4.0 * static_cast<double>(size_) + 64.0; }
    /// Where the grid is too large for a table of all cells: one of its rows, and for each row that holds
    /// points one from its first cell to its last, each if it is not too large.
    void make_tables(double most) {
        double entries = 0.0;
        for (std::size_t r = 0; r < rows(); ++r)
            entries += 2.0 + column_[first_cell_[r + 1] - 1] - column_[first_cell_[r]];
        if (entries <= most) add_row_starts();
        if (!row_.empty() && static_cast<double>(row_.back()) + 2.0 <= most) add_row_table();
    }
    void add_row_starts() {
        start_.clear();
        for (std::size_t r = 0; r < rows(); ++r) {
            row_start_.push_back(static_cast<Index>(start_.size()));
            const Index first = first_cell_[r], last = first_cell_[r + 1];
            for (Index c = first; c < last; ++c)
                start_.resize(row_start_[r] + column_[c] - column_[first] + 1, first_point_[c]);
            start_.push_back(first_point_[last]);
        }
    }
    void add_row_table() {
        for (std::size_t r = 0; r < rows(); ++r)
            row_table_.resize(row_[r] + 1, static_cast<Index>(r));
        row_table_.push_back(static_cast<Index>(rows()));
    }

    struct Placed {
        std::array<std::uint32_t, Dim> cell;
        Index point;
    };

    /// Stable counting sorts by 11 bits at a time, from the lowest digit of the first axis.
    void sort_by_digits(const CellFrame<Dim>& frame, Given points) {
        constexpr int digit = 11;
        const std::size_t n = points.size();
        std::vector<Placed> placed(n), sorted(n);
        parallel_for(n, [&](std::size_t i) {
            placed[i] = {frame.cell(points[i]), static_cast<Index>(i)};
        });
        for (int axis = 0; axis < Dim; ++axis)
            for (int shift = 0; shift < 32 && (frame.cells(axis) - 1) >> shift != 0;
                 shift += digit) {
                const auto digit_of = [&](const Placed& p) {
                    return p.cell[axis] >> shift & ((1u << digit) - 1);
                };
                std::array<Index, (1u << digit) + 1> start{};
                for (const Placed& p : placed) ++start[digit_of(p) + 1];
                std::partial_sum(start.begin(), start.end(), start.begin());
                for (const Placed& p : placed) sorted[start[digit_of(p)]++] = p;
                placed.swap(sorted);
            }
        for (std::size_t k = 0; k < n; ++k) {
            order_[k] = placed[k].point;
            if (k == 0 || placed[k].cell != placed[k - 1].cell)
                add_cell(frame.row(placed[k].cell), placed[k].cell[0], static_cast<Index>(k));
        }
    }

    std::size_t size_ = 0;
    bool has_table_ = false;
    std::vector<Index> order_;              // point k in this order was given as order_[k]
    std::array<std::vector<Real>, Dim> x_;  // coordinates in this order
    std::vector<std::uint32_t> column_;     // of each cell
    std::vector<Index> first_point_;        // of each cell, and the end
    std::vector<std::uint64_t> row_;        // ascending
    std::vector<Index> first_cell_;         // of each row, and the end
    std::vector<Index> key_, start_;        // kept: new memory costs more than the sort
    std::uint32_t columns_ = 0;             // of the table of all cells
    std::vector<Index> row_start_;  // of each row in start_, if that holds one table for each
    std::vector<Index> row_table_;  // of each row number up to the last: the first row from it on
};

}  // namespace plumbline
