#pragma once

#include "solver/io/write_points.h"

#include <cstdint>
#include <span>

namespace plumbline {

/// `text` as the value of an XML attribute.
std::string xml_escaped(std::string_view text);

/// The first lines of a VTK file, up to <TYPE>, and the last ones, from </TYPE> on.
void begin_vtk(std::ostream& out, std::string_view type);
void end_vtk(std::ostream& out, std::string_view type);

/// One <DataArray>; `components` values per member. Base64 holds the same bits, ascii has 17 digits.
void write_vtk_array(std::ostream& out, std::string_view name, int components,
                     std::span<const double> values, VtpEncoding encoding);
void write_vtk_array(std::ostream& out, std::string_view name, std::span<const std::int64_t> values,
                     VtpEncoding encoding);

}  // namespace plumbline
