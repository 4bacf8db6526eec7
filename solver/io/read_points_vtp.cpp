#include "solver/io/base64.h"
#include "solver/io/point_formats.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace plumbline {

namespace {
using Tree = boost::property_tree::ptree;
const Tree nothing;

std::string attribute(const Tree& node, const std::string& name, const std::string& otherwise) {
    return node.get("<xmlattr>." + name, otherwise);
}

/// The XML parser calls itself once per level; a VTP file has six.
void refuse_deep_nesting(const SourceText& text, std::string_view xml) {
    constexpr int deepest = 100;
    int depth = 0;
    for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
        const char next = at + 1 < xml.size() ? xml[at + 1] : '>';
        if (next == '/')
            --depth;
        else if (next != '!' && next != '?' &&
                 xml[std::min(xml.find('>', at), xml.size()) - 1] != '/')
            ++depth;
        if (depth > deepest) text.reject(xml.substr(at), "at most 100 nested elements", "more");
    }
}

/// A VTP file whose header has been understood.
class VtpFile {
public:
    explicit VtpFile(const SourceText& text) : text_{text} {
        parse_xml();
        const auto file = root_.get_child_optional("VTKFile");
        if (!file) text.reject(text.bytes(), "the element <VTKFile>", "another one");
        if (const auto type = attribute(*file, "type", ""); type != "PolyData")
            text.reject(text.bytes(), "<VTKFile type=\"PolyData\">", "type " + in_quotes(type));
        if (const auto compressor = attribute(*file, "compressor", ""); !compressor.empty())
            text.reject(text.bytes(), "data that are not compressed (in ParaView: compressor None)",
                        compressor);
        big_endian_ = attribute(*file, "byte_order", "LittleEndian") == "BigEndian";
        wide_header_ = attribute(*file, "header_type", "UInt32") == "UInt64";
        raw_ = attribute(file->get_child("AppendedData", nothing), "encoding", "raw") == "raw";
        find_piece(*file);
    }

    PointFile points() const {
        const auto arrays = piece_->get_child_optional("Points");
        const auto coordinates = arrays ? arrays->get_child_optional("DataArray") : boost::none;
        if (!coordinates) text_.reject_at("Piece", "<Points> with a <DataArray>", "none");
        const std::vector<double> xyz = values(*coordinates, 3, "Points");
        const bool flat = [&] {
            for (std::size_t i = 2; i < xyz.size(); i += 3)
                if (xyz[i] != 0.0) return false;
            return true;
        }();
        PointFile file{flat ? 2 : 3, {}, {}};
        for (std::size_t i = 0; i < xyz.size(); ++i)
            if (!flat || i % 3 != 2) file.coordinates.push_back(xyz[i]);
        for (const auto& [tag, array] : piece_->get_child("PointData", nothing))
            if (tag == "DataArray") add_columns(array, file);
        return file;
    }

private:
    /// The appended data need not be XML: they are cut off before the rest is parsed.
    void parse_xml() {
        std::string_view xml = text_.bytes();
        const std::size_t start = xml.find("<AppendedData");
        std::string closing;
        if (start != xml.npos) {
            const std::size_t mark = xml.find('_', std::min(xml.find('>', start), xml.size()));
            if (mark == xml.npos)
                text_.reject(xml.substr(start), "\"_\" before the appended data", "none");
            appended_ = xml.substr(mark + 1);
            xml = xml.substr(0, mark);
            closing = "</AppendedData></VTKFile>";
        }
        if (appended_.empty()) text_.require_text();
        refuse_deep_nesting(text_, xml);
        std::istringstream stream(std::string(xml) + closing);
        try {
            boost::property_tree::read_xml(stream, root_);
        } catch (const boost::property_tree::xml_parser_error& e) {
            throw InvalidInput(text_.name() + ":" + std::to_string(e.line()) +
                               ": expected well-formed XML, found text that is not (" +
                               e.message() + ")");
        }
    }

    void find_piece(const Tree& file) {
        const auto data = file.get_child_optional("PolyData");
        const std::size_t pieces = data ? data->count("Piece") : 0;
        if (pieces != 1) text_.reject_at("PolyData", "exactly one <Piece>", std::to_string(pieces));
        piece_ = &data->get_child("Piece");
        n_ = count_attribute(*piece_, "NumberOfPoints", "", "Piece", 1, most_points);
    }

    static std::string place_of(const std::string& array) { return "DataArray \"" + array + "\""; }

    std::size_t count_attribute(const Tree& node, const std::string& name,
                                const std::string& otherwise, const std::string& place,
                                std::size_t least, std::size_t most) const {
        const std::string found = attribute(node, name, otherwise);
        const auto count = parsed_count(found);
        if (!count || *count < least || *count > most)
            text_.reject_at(place,
                            name + " from " + std::to_string(least) + " to " + std::to_string(most),
                            in_quotes(found));
        return *count;
    }

    void add_columns(const Tree& array, PointFile& file) const {
        const std::string name = attribute(array, "Name", "");
        if (attribute(array, "type", "") == "String") return;
        const std::size_t components =
            count_attribute(array, "NumberOfComponents", "1", place_of(name), 1, 1000);
        const std::vector<double> all = values(array, components, name);
        for (std::size_t c = 0; c < components; ++c) {
            const std::string column = components == 1 ? name : name + "_" + std::to_string(c);
            if (file.find(column))
                text_.reject_at("PointData", "each name once", in_quotes(column) + " twice");
            file.columns.push_back({column, {}});
            for (std::size_t i = 0; i < n_; ++i)
                file.columns.back().values.push_back(all[i * components + c]);
        }
    }

    /// The n × components finite values of one <DataArray>.
    std::vector<double> values(const Tree& array, std::size_t components,
                               const std::string& name) const {
        const std::string place = place_of(name);
        const std::string format = attribute(array, "format", "ascii");
        std::vector<double> found;
        if (format == "ascii")
            found = ascii_values(array.data());
        else if (format == "binary")
            found = typed(array, place, block(decoded(array.data(), place), place));
        else if (format == "appended")
            found = typed(array, place, block(appended_from(array, place), place));
        else
            text_.reject_at(place, "format ascii, binary or appended", in_quotes(format));
        if (found.size() != n_ * components)
            text_.reject_at(place,
                            std::to_string(n_) + " × " + std::to_string(components) + " values",
                            std::to_string(found.size()));
        for (std::size_t i = 0; i < found.size(); ++i)
            if (!std::isfinite(found[i]))
                text_.reject_at(place + ", value " + std::to_string(i + 1), "a finite number",
                                std::to_string(found[i]));
        return found;
    }

    /// The parser hands out a copy of the text; the same characters in the file have the position.
    std::vector<double> ascii_values(const std::string& content) const {
        const std::size_t start = text_.bytes().find(content);
        const SourceText copy(text_.name(), content);
        const bool here = start != std::string_view::npos;
        const std::string_view source =
            here ? text_.bytes().substr(start, content.size()) : copy.bytes();
        std::vector<double> found;
        for (const std::string_view word : words(source))
            found.push_back((here ? text_ : copy).finite_number(word));
        return found;
    }

    std::string decoded(std::string_view base64, const std::string& place) const {
        auto bytes = decode_base64(base64);
        if (!bytes) text_.reject_at(place, "base64", in_quotes(trimmed(base64)));
        return *std::move(bytes);
    }

    /// What follows from the offset of this array on; its own length tells where it ends.
    std::string appended_from(const Tree& array, const std::string& place) const {
        if (appended_.empty()) text_.reject_at(place, "<AppendedData>", "none");
        const std::size_t offset =
            count_attribute(array, "offset", "", place, 0, appended_.size() - 1);
        std::string_view rest = appended_.substr(offset);
        if (raw_) return std::string(rest);
        // Whole arrays follow one another: decode up to the end of this one only.
        const std::size_t head = length_size() / 3 * 4 + 4;
        const std::string start = decoded(rest.substr(0, head), place);
        const std::size_t digits = (block_length(start, place) + length_size() + 2) / 3 * 4 + 4;
        rest = rest.substr(0, std::min(digits, rest.find_first_of("< \n", 0)));
        return decoded(rest.substr(0, rest.size() / 4 * 4), place);
    }

    std::size_t length_size() const { return wide_header_ ? 8 : 4; }

    template <class T> T from_bytes(const char* bytes) const {
        char raw[sizeof(T)];
        std::memcpy(raw, bytes, sizeof(T));
        if (big_endian_ == (std::endian::native == std::endian::little))
            std::reverse(std::begin(raw), std::end(raw));
        T value;
        std::memcpy(&value, raw, sizeof(T));
        return value;
    }

    std::size_t block_length(const std::string& bytes, const std::string& place) const {
        if (bytes.size() < length_size())
            text_.reject_at(place, "the length of the data", "the end of the data");
        return wide_header_ ? from_bytes<std::uint64_t>(bytes.data())
                            : from_bytes<std::uint32_t>(bytes.data());
    }

    /// The data behind their length.
    std::string block(const std::string& bytes, const std::string& place) const {
        const std::size_t length = block_length(bytes, place);
        if (length > bytes.size() - length_size())
            text_.reject_at(place, std::to_string(length) + " bytes",
                            std::to_string(bytes.size() - length_size()));
        return bytes.substr(length_size(), length);
    }

    template <class T> std::vector<double> typed(const std::string& bytes) const {
        std::vector<double> found(bytes.size() / sizeof(T));
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i] = static_cast<double>(from_bytes<T>(bytes.data() + i * sizeof(T)));
        return found;
    }

    std::vector<double> typed(const Tree& array, const std::string& place,
                              const std::string& bytes) const {
        const std::string type = attribute(array, "type", "");
        if (type == "Float64") return typed<double>(bytes);
        if (type == "Float32") return typed<float>(bytes);
        if (type == "Int8") return typed<std::int8_t>(bytes);
        if (type == "UInt8") return typed<std::uint8_t>(bytes);
        if (type == "Int16") return typed<std::int16_t>(bytes);
        if (type == "UInt16") return typed<std::uint16_t>(bytes);
        if (type == "Int32") return typed<std::int32_t>(bytes);
        if (type == "UInt32") return typed<std::uint32_t>(bytes);
        if (type == "Int64") return typed<std::int64_t>(bytes);
        if (type == "UInt64") return typed<std::uint64_t>(bytes);
        text_.reject_at(place, "a type such as Float64", in_quotes(type));
    }

    const SourceText& text_;
    Tree root_;
    const Tree* piece_ = nullptr;
    std::string_view appended_;
    std::size_t n_ = 0;
    bool big_endian_ = false, wide_header_ = false, raw_ = true;
};
}  // namespace

PointFile parse_vtp_points(const SourceText& text) { return VtpFile(text).points(); }

}  // namespace plumbline
