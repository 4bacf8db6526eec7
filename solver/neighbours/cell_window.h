#pragma once

#include "solver/neighbours/candidates.h"
#include "solver/neighbours/cell_order.h"

namespace plumbline {

/// Cells first to last along each axis. They may lie beyond the grid: there are none in open space, in a
/// periodic box they are images.
template <int Dim> struct CellBlock { std::array<std::int64_t, Dim> first, last; };

/// A block of cells, as runs of cells in the rows that it crosses. It is moved from block to block; from
/// one to the next in the same rows each run moves on by a few cells.
template <int Dim, bool Wraps, class Real = double> class CellWindow {
    using Order = CellOrder<Dim, Real>;

public:
    CellWindow(const CellFrame<Dim>& frame, const Order& points) : frame_{frame}, points_{points} {}

    /// The cells within `reach` of the columns first_column .. last_column of a row.
    void move_to(std::uint64_t row, std::uint32_t first_column, std::uint32_t last_column,
                 std::int64_t reach) {
        if (row != row_ || reach != reach_) {
            row_ = row;
            reach_ = reach;
            block_ = around(row, reach);
            enter_rows();
        }
        move_along(first_column - reach, last_column + reach);
    }
    void move_to(const CellBlock<Dim>& block) {
        row_ = no_row;
        bool same_rows = true;
        for (int axis = 1; axis < Dim; ++axis)
            same_rows &=
                block.first[axis] == block_.first[axis] && block.last[axis] == block_.last[axis];
        if (!same_rows || !entered_) {
            block_ = block;
            enter_rows();
        }
        move_along(block.first[0], block.last[0]);
    }

    bool is_empty() const { return points_in_block(0) == 0; }

    /// All points of the block.
    void gather(Candidates<Dim, Real>& near) const {
        near.resize(0);
        append(near);
        near.close();
    }
    /// The same, behind those that are there; they are not closed.
    void append(Candidates<Dim, Real>& near) const {
        std::size_t to = near.size();
        near.resize(to + points_in_block(0));
        for (const Run& run : runs_) to = copy(run.points, near, to);
    }
    /// Of the points of the block those from `first` on, in the order of the cells; `first` and what
    /// follows it in its row come first.
    void gather_from(Index first, Candidates<Dim, Real>& near) const {
        near.resize(points_in_block(first));
        std::size_t to = 0;
        for (const bool own : {true, false})
            for (const Run& run : runs_) {
                const Span points = run.not_before(first);
                if ((points.first == first && points.last > first) == own)
                    to = copy(points, near, to);
            }
        near.close();
    }

private:
    struct Span {
        Index first, last;
    };

    /// The points of some columns of one row.
    struct Run {
        RowOfCells row;
        Index begin = row.first_cell, end = begin;  // their cells, where the row has no table
        Span points{0, 0};

        void move_to(const Order& order, std::int64_t first, std::int64_t last) {
            if (row.starts != nullptr) {
                points = {Order::first_point(row, first), Order::first_point(row, last + 1)};
                return;
            }
            begin = order.first_cell(row, first, begin);
            end = order.first_cell(row, last + 1, std::max(begin, end));
            points = {order.first_point(begin), order.first_point(end)};
        }
        /// Those that are not before `least`.
        Span not_before(Index least) const {
            return {std::min(std::max(points.first, least), points.last), points.last};
        }
    };

    std::size_t points_in_block(Index from) const {
        std::size_t n = 0;
        for (const Run& run : runs_) {
            const Span points = run.not_before(from);
            n += points.last - points.first;
        }
        return n;
    }
    /// Copies points to the candidates from `to` on; returns where they end. Runs are short, so they
    /// are copied in whole blocks: what is copied beyond the end of a run is overwritten by the next
    /// one, and all arrays have room for a block more.
    std::size_t copy(Span points, Candidates<Dim, Real>& near, std::size_t to) const {
        constexpr std::size_t block = Order::room_beyond;
        const std::size_t n = points.last - points.first;
        for (std::size_t k = 0; k < n; k += block) {
            for (int axis = 0; axis < Dim; ++axis)
                copy_block(points_.x(axis) + points.first + k, near.x(axis) + to + k);
            copy_block(points_.order() + points.first + k, near.id() + to + k);
        }
        return to + n;
    }
    /// As vectors of up to 64 bytes, each one instruction.
    template <class T> static void copy_block(const T* from, T* to) {
        constexpr std::size_t part = std::min(Order::room_beyond, 64 / sizeof(T));
        for (std::size_t k = 0; k < Order::room_beyond; k += part)
            std::copy_n(from + k, part, to + k);
    }

    CellBlock<Dim> around(std::uint64_t row, std::int64_t reach) const {
        CellBlock<Dim> block{};
        for (int axis = 1; axis < Dim; ++axis) {
            const auto at = static_cast<std::int64_t>(row % frame_.cells(axis));
            row /= frame_.cells(axis);
            block.first[axis] = at - reach;
            block.last[axis] = at + reach;
        }
        return block;
    }
    void enter_rows() {
        entered_ = true;
        runs_.clear();
        hint_used_ = 0;
        add_rows<Dim - 1>(0);
    }

    /// Adds the rows of the block along `Axis` and the axes below it; `base` numbers the axes above it.
    template <int Axis> void add_rows(std::uint64_t base) {
        if constexpr (Axis == 0) {
            add_run(base);
        } else {
            std::int64_t first = block_.first[Axis], last = block_.last[Axis];
            const std::int64_t cells = frame_.cells(Axis);
            if (!Wraps || last - first + 1 >= cells)
                first = std::max<std::int64_t>(Wraps ? 0 : first, 0),
                last = std::min(Wraps ? cells - 1 : last, cells - 1);
            for (std::int64_t k = first; k <= last; ++k) {
                const std::int64_t image = (k + cells) % cells;
                add_rows<Axis - 1>(base * frame_.cells(Axis) + static_cast<std::uint64_t>(image));
            }
        }
    }

    void add_run(std::uint64_t number) {
        if (points_.has_table()) return push({points_.row_in_table(number)});
        // The windows of one row after the other look for rows that also follow one another.
        if (hint_used_ == hints_.size()) hints_.push_back(0);
        std::size_t& hint = hints_[hint_used_++];
        const std::size_t r = hint = points_.row_from(number, hint);
        if (r == points_.rows() || points_.row(r) != number) return;
        push({points_.row_of_cells(r)});
    }
    /// In a box that wraps, runs come in pairs: the second takes the columns beyond a face.
    void push(const Run& run) {
        runs_.push_back(run);
        if (Wraps) runs_.push_back(run);
    }

    void move_along(std::int64_t first, std::int64_t last) {
        const std::int64_t cells = frame_.cells(0);
        if (Wraps && last - first + 1 >= cells) return move_runs(0, cells - 1, 0, -1);
        if (Wraps && first < 0) return move_runs(0, last, first + cells, cells - 1);
        if (Wraps && last >= cells) return move_runs(0, last - cells, first, cells - 1);
        move_runs(first, last, 0, -1);
    }
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
    const Order& points_;
    std::vector<Run> runs_;
    std::vector<std::size_t> hints_;
    std::size_t hint_used_ = 0;
    CellBlock<Dim> block_{};  // its rows
    bool entered_ = false;
    static constexpr std::uint64_t no_row = ~std::uint64_t{0};
    std::uint64_t row_ = no_row;  // in whose middle the block lies
    std::int64_t reach_ = 0;
};

}  // namespace plumbline
