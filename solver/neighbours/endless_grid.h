#pragma once

#include "solver/neighbours/space.h"

#include <array>
#include <cstdint>

namespace plumbline {

template <int Dim> using Cell = std::array<std::int64_t, Dim>;

/// Along each axis the cells first, first + 1, ..., last.
template <int Dim> struct CellRange {
    Cell<Dim> first, last;

    /// As a floating-point number: it may exceed every integer.
    double count() const {
        double all = 1.0;
        for (int axis = 0; axis < Dim; ++axis)
            all *= static_cast<double>(last[axis] - first[axis]) + 1.0;
        return all;
    }
    /// Calls visit(cell) for each cell, the first axis fastest.
    template <class Visit> void for_each(Visit visit) const {
        for (Cell<Dim> cell = first;;) {
            visit(cell);
            int axis = 0;
            while (axis < Dim && ++cell[axis] > last[axis]) cell[axis] = first[axis], ++axis;
            if (axis == Dim) return;
        }
    }
};

/// I(x) = (⌊x/d⌋, ⌊y/d⌋, ⌊z/d⌋): the cells of an endless grid of spacing d with a corner at the origin.
/// adams2009 Eq. 42, which prints z twice: erratum 38. Floor, so that cells do not change width at 0.
/// Cells are numbered up to 2⁵⁰ on either side of the origin; all that is farther out belongs to the
/// outermost ones: a search stays right there, but is no longer fast.
template <int Dim, class Space> class EndlessGrid {
public:
    EndlessGrid() = default;
    EndlessGrid(const Space&, double spacing) : spacing_{spacing} {}

    Cell<Dim> cell(const Vec<Dim>& x) const {
        Cell<Dim> all;
        for (int axis = 0; axis < Dim; ++axis) all[axis] = along(x[axis]);
        return all;
    }
    /// The cells that may hold a point x + y with |y| < radius along each axis, however it was rounded:
    /// ⌊·⌋ of a rounded quotient is monotonic, so it is enough to widen the interval outwards.
    CellRange<Dim> around(const Vec<Dim>& x, double radius) const {
        CellRange<Dim> range;
        const double reach = radius * (1.0 + 0x1p-49);
        for (int axis = 0; axis < Dim; ++axis) {
            range.first[axis] = along(std::nextafter(x[axis] - reach, -HUGE_VAL));
            range.last[axis] = along(std::nextafter(x[axis] + reach, HUGE_VAL));
        }
        return range;
    }
    Cell<Dim> image(const Cell<Dim>& cell) const { return cell; }

private:
    std::int64_t along(double x) const {
        constexpr double outermost = 0x1p50;
        return static_cast<std::int64_t>(
            std::floor(std::clamp(x / spacing_, -outermost, outermost)));
    }
    double spacing_ = 1.0;
};

/// As many whole cells as fit into a periodic box, none narrower than the spacing (or than the box).
template <int Dim> class EndlessGrid<Dim, PeriodicBox<Dim>> {
public:
    EndlessGrid() = default;
    EndlessGrid(const PeriodicBox<Dim>& box, double spacing) : low_{box.low()}, edge_{box.edge()} {
        for (int axis = 0; axis < Dim; ++axis)
            cells_[axis] = static_cast<std::int64_t>(
                std::clamp(std::floor(edge_[axis] / spacing), 1.0, 0x1p31));
    }

    Cell<Dim> cell(const Vec<Dim>& x) const {
        Cell<Dim> all;
        for (int axis = 0; axis < Dim; ++axis) all[axis] = along(x[axis], axis);
        return image(all);
    }
    /// As in open space, but through the faces of the box; each cell at most once, before `image`.
    /// Cells of images are not rounded alike, by up to 6 2⁻⁵³ of the box, hence the second widening.
    CellRange<Dim> around(const Vec<Dim>& x, double radius) const {
        CellRange<Dim> range;
        for (int axis = 0; axis < Dim; ++axis) {
            const double reach = radius * (1.0 + 0x1p-49) + 0x1p-49 * edge_[axis];
            range.first[axis] = along(x[axis] - reach, axis);
            range.last[axis] =
                std::min(along(x[axis] + reach, axis), range.first[axis] + cells_[axis] - 1);
        }
        return range;
    }
    Cell<Dim> image(const Cell<Dim>& cell) const {
        Cell<Dim> inside;
        for (int axis = 0; axis < Dim; ++axis)
            inside[axis] = ((cell[axis] % cells_[axis]) + cells_[axis]) % cells_[axis];
        return inside;
    }

private:
    std::int64_t along(double x, int axis) const {
        return static_cast<std::int64_t>(
            std::floor((x - low_[axis]) / edge_[axis] * static_cast<double>(cells_[axis])));
    }
    Vec<Dim> low_ = Vec<Dim>::Zero(), edge_ = Vec<Dim>::Ones();
    Cell<Dim> cells_{};
};

}  // namespace plumbline
