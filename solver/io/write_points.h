#pragma once

#include "solver/io/read_points.h"

#include <ostream>

namespace plumbline {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class VtpEncoding { ascii, base64 };

/// Each writes points so that `read_points` gives back the same bits, whatever the encoding.
/// The exception: a VTP file has no dimension, so points in space whose z are all zero come back
/// in the plane. Throws InvalidInput if a column has not one value per point, or its name is empty,
/// comes twice, is that of a coordinate or, in a PLY file, has a blank.
void write_points_csv(std::ostream& out, const PointFile& points);
void write_points_ply(std::ostream& out, const PointFile& points, PlyEncoding encoding);
void write_points_vtp(std::ostream& out, const PointFile& points, VtpEncoding encoding);

}  // namespace plumbline
