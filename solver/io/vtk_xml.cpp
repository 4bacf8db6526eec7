#include "solver/io/vtk_xml.h"

#include "solver/io/base64.h"
#include "solver/io/csv.h"

#include <bit>
#include <cstring>

namespace plumbline {

namespace {
std::string as_digits(double value) { return digits17(value); }
std::string as_digits(std::int64_t value) { return std::to_string(value); }

template <class T>
void write_array(std::ostream& out, std::string_view type, std::string_view name, int components,
                 std::span<const T> values, VtpEncoding encoding) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << xml_escaped(name)
        << "\" NumberOfComponents=\"" << components << "\" format=\""
        << (encoding == VtpEncoding::ascii ? "ascii" : "binary") << "\">\n";
    if (encoding == VtpEncoding::ascii) {
        for (const T value : values) out << as_digits(value) << '\n';
    } else {
        const std::uint64_t length = values.size_bytes();
        std::string bytes(sizeof length + length, '\0');
        std::memcpy(bytes.data(), &length, sizeof length);
        if (length > 0) std::memcpy(bytes.data() + sizeof length, values.data(), length);
        out << encode_base64(bytes) << '\n';
    }
    out << "</DataArray>\n";
}
}  // namespace

std::string xml_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

void begin_vtk(std::ostream& out, std::string_view type) {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type << "\" version=\"1.0\" byte_order=\""
        << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
        << "\" header_type=\"UInt64\">\n<" << type << ">\n";
}
void end_vtk(std::ostream& out, std::string_view type) { out << "</" << type << ">\n</VTKFile>\n"; }

void write_vtk_array(std::ostream& out, std::string_view name, int components,
                     std::span<const double> values, VtpEncoding encoding) {
    write_array(out, "Float64", name, components, values, encoding);
}
void write_vtk_array(std::ostream& out, std::string_view name, std::span<const std::int64_t> values,
                     VtpEncoding encoding) {
    write_array(out, "Int64", name, 1, values, encoding);
}

}  // namespace plumbline
