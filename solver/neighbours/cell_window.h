#pragma once

#include "solver/neighbours/candidates.h"
#include "solver/neighbours/cell_order.h"

namespace plumbline {

/// The block of cells within `reach` of one cell, as runs of cells in the rows that the block crosses.
/// It is moved from cell to cell; from one to the next in a row each run moves on by a few cells.
template <int Dim, bool Wraps> class CellWindow {
public:
    CellWindow(const CellFrame<Dim>& frame, const CellOrder<Dim>& points)
        : frame_{frame}, points_{points} {}

    void move_to(std::uint64_t row, std::uint32_t column, std::int64_t reach) {
        if (row != row_ || reach != reach_) enter_rows(row, reach);
        const std::int64_t cells = frame_.cells(0), first = column - reach, last = column + reach;
        if (Wraps && last - first + 1 >= cells) return move_runs(0, cells - 1, 0, -1);
        if (Wraps && first < 0) return move_runs(0, last, first + cells, cells - 1);
        if (Wraps && last >= cells) return move_runs(0, last - cells, first, cells - 1);
        move_runs(first, last, 0, -1);
    }

    /// How many points the block holds.
    std::size_t size() const {
        std::size_t n = 0;
        for (const Run& run : runs_) n += run.last_point(points_) - run.first_point(points_);
        return n;
    }
    void gather_positions(Candidates<Dim>& near) const {
        near.resize(size());
        for (int axis = 0; axis < Dim; ++axis) copy_runs(points_.x(axis), near.x(axis));
        near.close();
    }
    void gather_ids(Candidates<Dim>& near) const {
        near.resize(size());
        copy_runs(points_.order(), near.id());
    }

private:
    /// The cells begin .. end of the row row_begin .. row_end; moving keeps the cells already found.
    struct Run {
        Index row_begin, row_end;
        Index begin = row_begin, end = row_begin;

        void move_to(const CellOrder<Dim>& points, std::int64_t first, std::int64_t last) {
            begin = from(points, begin, first);
            end = from(points, std::max(begin, end), last + 1);
        }
        Index first_point(const CellOrder<Dim>& points) const { return points.first_point(begin); }
        Index last_point(const CellOrder<Dim>& points) const { return points.first_point(end); }

    private:
        /// The first cell of the row whose column is not below `column`, looked for from `cell` on.
        Index from(const CellOrder<Dim>& points, Index cell, std::int64_t column) const {
            while (cell > row_begin && points.column(cell - 1) >= column) --cell;
            while (cell < row_end && points.column(cell) < column) ++cell;
            return cell;
        }
    };

    /// Runs are short, so they are copied in whole blocks: what is copied beyond the end of a run is
    /// overwritten by the next one, and both arrays have room for a block more.
    template <class T> void copy_runs(const T* from, T* to) const {
        constexpr std::size_t block = CellOrder<Dim>::template room_beyond<T>;
        for (const Run& run : runs_) {
            const T* source = from + run.first_point(points_);
            const std::size_t n = run.last_point(points_) - run.first_point(points_);
            for (std::size_t k = 0; k < n; k += block) std::copy_n(source + k, block, to + k);
            to += n;
        }
    }

    void enter_rows(std::uint64_t row, std::int64_t reach) {
        row_ = row;
        reach_ = reach;
        runs_.clear();
        add_rows<Dim - 1>(row, 0, reach);
    }

    /// Adds the rows near `row` along `Axis` and the axes below it; `base` numbers the axes above it.
    template <int Axis> void add_rows(std::uint64_t row, std::uint64_t base, std::int64_t reach) {
        if constexpr (Axis == 0) {
            add_run(base);
        } else {
            std::uint64_t stride = 1;
            for (int axis = 1; axis < Axis; ++axis) stride *= frame_.cells(axis);
            const auto at = static_cast<std::int64_t>(row / stride);
            const std::int64_t cells = frame_.cells(Axis);
            std::int64_t first = at - reach, last = at + reach;
            if (!Wraps || last - first + 1 >= cells)
                first = std::max<std::int64_t>(Wraps ? 0 : first, 0),
                last = std::min(Wraps ? cells - 1 : last, cells - 1);
            for (std::int64_t k = first; k <= last; ++k) {
                const std::int64_t image = (k + cells) % cells;
                add_rows<Axis - 1>(row % stride, base + static_cast<std::uint64_t>(image) * stride,
                                   reach);
            }
        }
    }

    void add_run(std::uint64_t row) {
        const std::size_t r = points_.row_from(row);
        if (r == points_.rows() || points_.row(r) != row) return;
        const Run run{points_.first_cell(r), points_.first_cell(r + 1)};
        runs_.push_back(run);
        if (Wraps) runs_.push_back(run);
    }

    /// In a box that wraps, runs come in pairs: the second takes the columns beyond a face.
    void move_runs(std::int64_t first, std::int64_t last, std::int64_t first_image,
                   std::int64_t last_image) {
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            if (Wraps && k % 2 == 1)
                runs_[k].move_to(points_, first_image, last_image);
            else
                runs_[k].move_to(points_, first, last);
        }
    }

    const CellFrame<Dim>& frame_;
    const CellOrder<Dim>& points_;
    std::vector<Run> runs_;
    std::uint64_t row_ = ~std::uint64_t{0};
    std::int64_t reach_ = 0;
};

}  // namespace plumbline
