#pragma once

#include "solver/foundation/parallel.h"
#include "solver/neighbours/space.h"

#include <array>
#include <cstdint>
#include <mutex>
#include <span>

namespace plumbline {

/// The grid over the box of the points, or over the periodic box: cells no narrower than the radius, so
/// that the neighbours of a point are in its cell and the adjacent ones.
///
/// A cell number is ⌊t⌋ of t = (x − low) / width, at most 2³¹, with an error below 2⁻²¹ from its two
/// roundings. So that two points closer than the radius never seem to be two cells apart, cells are
/// wider than the radius by 2⁻¹⁸. A box of more than 2³¹ radii gets wider cells: right, but slower
/// where many points share a cell.
template <int Dim> class CellFrame {
public:
    CellFrame() = default;

    template <class Real>
    static CellFrame around(std::span<const VecOf<Real, Dim>> points, double radius) {
        CellFrame frame;
        if (points.empty()) return frame;
        frame.enclose(points);
        for (int axis = 0; axis < Dim; ++axis) {
            const double edge = frame.high_[axis] - frame.low_[axis];
            const double width = std::max(radius * (1.0 + 0x1p-18), edge * 0x1p-31);
            frame.inverse_width_[axis] = 1.0 / width;
            frame.cells_[axis] = static_cast<std::uint32_t>(edge / width) + 1;
        }
        return frame;
    }
    static CellFrame around(const Points<Dim>& points, double radius) {
        return around(std::span<const Vec<Dim>>(points), radius);
    }
    /// `rounding` is that of the coordinates' precision, 2⁻⁵³ or 2⁻²⁴: in a periodic box differences
    /// are rounded as large numbers, up to the edge, before they become small.
    static CellFrame filling(const PeriodicBox<Dim>& box, double radius,
                             double rounding = 0x1p-53) {
        CellFrame frame;
        frame.low_ = box.low();
        frame.high_ = box.high();
        for (int axis = 0; axis < Dim; ++axis) {
            const double width = radius * (1.0 + 0x1p-18) + 4.0 * rounding * box.edge()[axis];
            const double fit = std::floor(box.edge()[axis] / width);
            frame.cells_[axis] = static_cast<std::uint32_t>(std::clamp(fit, 1.0, 0x1p31));
            frame.inverse_width_[axis] = frame.cells_[axis] / box.edge()[axis];
            frame.rounding_in_cells_[axis] = 4.0 * rounding * frame.cells_[axis];
        }
        return frame;
    }

    /// A coordinate outside of the box counts to the nearest cell of the grid; moving a query there
    /// brings it no farther from any point.
    std::uint32_t cell(double x, int axis) const {
        const double inside = std::clamp(x, low_[axis], high_[axis]);
        const auto number =
            static_cast<std::uint32_t>((inside - low_[axis]) * inverse_width_[axis]);
        return std::min(number, cells_[axis] - 1);
    }
    template <class Real> std::array<std::uint32_t, Dim> cell(const VecOf<Real, Dim>& x) const {
        std::array<std::uint32_t, Dim> all;
        for (int axis = 0; axis < Dim; ++axis) all[axis] = cell(x[axis], axis);
        return all;
    }
    std::uint32_t cells(int axis) const { return cells_[axis]; }
    /// How many cells a ball reaches to either side of the cell of its centre. The margin is for the
    /// rounding of two cell numbers, and of distances: relative to the radius, which single precision
    /// rounds by less than 2⁻²¹, and in a periodic box relative to its edge.
    std::int64_t reach(double radius) const {
        double most = 1.0;
        for (int axis = 0; axis < Dim; ++axis) {
            const double cells = radius * (1.0 + 0x1p-20) * inverse_width_[axis];
            const double wide = std::ceil(cells + 0x1p-19 + rounding_in_cells_[axis]);
            most = std::max(most, std::min(wide, static_cast<double>(cells_[axis])));
        }
        return static_cast<std::int64_t>(most);
    }
    /// Rows are lines of cells along the first axis, numbered with the second axis fastest.
    std::uint64_t row(const std::array<std::uint32_t, Dim>& cell) const {
        std::uint64_t number = 0;
        for (int axis = Dim - 1; axis > 0; --axis) number = number * cells_[axis] + cell[axis];
        return number;
    }
    double cell_count() const {
        double all = 1.0;
        for (const std::uint32_t n : cells_) all *= n;
        return all;
    }

private:
    template <class Real> void enclose(std::span<const VecOf<Real, Dim>> points) {
        std::mutex mutex;
        VecOf<Real, Dim> low = points.front(), high = low;
        parallel_for_parts(points.size(), [&](std::size_t first, std::size_t last) {
            VecOf<Real, Dim> part_low = points[first], part_high = part_low;
            for (std::size_t i = first + 1; i < last; ++i) {
                part_low = part_low.cwiseMin(points[i]);
                part_high = part_high.cwiseMax(points[i]);
            }
            const std::scoped_lock lock(mutex);
            low = low.cwiseMin(part_low);
            high = high.cwiseMax(part_high);
        });
        low_ = low.template cast<double>();
        high_ = high.template cast<double>();
    }

    Vec<Dim> low_ = Vec<Dim>::Zero(), high_ = Vec<Dim>::Zero();
    Vec<Dim> inverse_width_ = Vec<Dim>::Zero();
    Vec<Dim> rounding_in_cells_ = Vec<Dim>::Zero();  // of differences in a periodic box
    std::array<std::uint32_t, Dim> cells_ = [] {
        std::array<std::uint32_t, Dim> one;
        one.fill(1);
        return one;
    }();
};
}  // namespace plumbline
