#pragma once

#include "solver/io/write_points.h"

#include <cstdint>
#include <span>

namespace plumbline {

/// Points, what is known at each of them, and cells between them: what ParaView reads from a .vtp.
struct PolyData {
    struct Array {
        std::string name;
        int components;
        std::vector<double> values;  // `components` for each point
    };
    enum class Cells { points, edges, triangles };

    std::vector<double> xyz;  // three for each point [m]
    std::vector<Array> arrays;
    Cells kind = Cells::points;
    std::vector<std::int64_t> corners =
        {};  // of edges 2, of triangles 3 each; of points none: one cell each

    std::size_t points() const { return xyz.size() / 3; }
};

/// Appends vectors of `dim` components as vectors of three, those missing being 0.
std::vector<double> in_space(std::span<const double> vectors, int dim);

/// A VTK PolyData file. Throws InvalidInput for arrays of another length than the points ask for, and for
/// corners that are no points.
void write_vtp(std::ostream& out, const PolyData& data, VtpEncoding encoding = VtpEncoding::base64);

}  // namespace plumbline
