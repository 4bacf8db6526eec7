#include "solver/io/point_formats.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace plumbline {

namespace {
enum class Encoding { ascii, little_endian, big_endian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct NamedType {
    std::string_view name;
    Type type;
};
constexpr NamedType types[] = {
    {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
    {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
    {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
    {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
    {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
    {"float64", Type::float64}};

struct Property {
    std::string name;
    Type type;
    std::optional<Type> list_count;  // a list, and the type of its length
};

struct Element {
    std::string_view name;
    std::size_t count;
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding;
    std::vector<Element> elements;
    std::string_view body;
};

Type type_named(const SourceText& text, std::string_view name) {
    const auto found = std::ranges::find(types, name, &NamedType::name);
    if (found == std::end(types)) text.reject(name, "a PLY type such as float or double");
    return found->type;
}

Encoding encoding_of(const SourceText& text, std::string_view line) {
    const auto w = words(line);
    if (w.size() == 3 && w[0] == "format" && w[2] == "1.0") {
        if (w[1] == "ascii") return Encoding::ascii;
        if (w[1] == "binary_little_endian") return Encoding::little_endian;
        if (w[1] == "binary_big_endian") return Encoding::big_endian;
    }
    text.reject(line, "\"format ascii|binary_little_endian|binary_big_endian 1.0\"");
}

void parse_property(const SourceText& text, const std::vector<std::string_view>& w,
                    Element& element) {
    const bool list = w.size() == 5 && w[1] == "list";
    if (!list && w.size() != 3) text.reject(w[0], "\"property TYPE NAME\"");
    const std::string name(w.back());
    if (std::ranges::find(element.properties, name, &Property::name) != element.properties.end())
        text.reject(w.back(), "each property once", in_quotes(name) + " twice");
    element.properties.push_back({name, type_named(text, w[w.size() - 2]),
                                  list ? std::optional(type_named(text, w[2])) : std::nullopt});
}

Header parse_header(const SourceText& text) {
    Lines lines(text.bytes());
    const auto magic = lines.next();
    if (!magic || *magic != "ply") {
        text.require_text();
        text.reject(magic.value_or(text.bytes()), "\"ply\"");
    }
    Header header{Encoding::ascii, {}, {}};
    const auto format = lines.next();
    header.encoding = encoding_of(text, format.value_or(text.bytes().substr(text.bytes().size())));
    while (const auto line = lines.next()) {
        const auto w = words(*line);
        if (w.empty() || w[0] == "comment" || w[0] == "obj_info") continue;
        if (w[0] == "end_header") {
            header.body = lines.rest();
            return header;
        }
        if (w[0] == "element" && w.size() == 3)
            header.elements.push_back({w[1], text.count(w[2]), {}});
        else if (w[0] == "property" && !header.elements.empty())
            parse_property(text, w, header.elements.back());
        else
            text.reject(*line, "\"element NAME COUNT\", \"property TYPE NAME\" or \"end_header\"");
    }
    text.reject(text.bytes().substr(text.bytes().size()), "\"end_header\"", "the end of the file");
}

/// Hands out the values of the body one after the other, whatever their encoding.
class Body {
public:
    Body(const SourceText& text, const Header& header)
        : text_{text}, encoding_{header.encoding}, bytes_{header.body}, lines_{header.body} {}

    void begin_row(const Element& element, std::size_t row) {
        where_ = std::string(element.name) + " " + std::to_string(row + 1) + " of " +
                 std::to_string(element.count);
        if (encoding_ != Encoding::ascii) return;
        do {
            const auto line = lines_.next();
            if (!line) text_.reject_at(where_, "its values", "the end of the file");
            line_ = *line;
        } while (trimmed(line_).empty());
        words_ = words(line_);
        used_ = 0;
    }
    double value(Type type) {
        if (encoding_ != Encoding::ascii) return binary_value(type);
        if (used_ == words_.size())
            text_.reject(line_.substr(line_.size()), "one more value of " + where_,
                         "the end of the line");
        return text_.finite_number(words_[used_++]);
    }
    void end_row() const {
        if (encoding_ == Encoding::ascii && used_ < words_.size())
            text_.reject(words_[used_], "the end of the line, after " + where_);
    }
    const std::string& where() const { return where_; }

private:
    template <class T> double read() {
        if (bytes_.size() < sizeof(T)) text_.reject_at(where_, "its values", "the end of the file");
        char raw[sizeof(T)];
        std::memcpy(raw, bytes_.data(), sizeof(T));
        bytes_.remove_prefix(sizeof(T));
        constexpr bool little_machine = std::endian::native == std::endian::little;
        if ((encoding_ == Encoding::little_endian) != little_machine)
            std::reverse(std::begin(raw), std::end(raw));
        T value;
        std::memcpy(&value, raw, sizeof(T));
        return static_cast<double>(value);
    }
    double binary_value(Type type) {
        switch (type) {
            case Type::int8:
                return read<std::int8_t>();
            case Type::uint8:
                return read<std::uint8_t>();
            case Type::int16:
                return read<std::int16_t>();
            case Type::uint16:
                return read<std::uint16_t>();
            case Type::int32:
                return read<std::int32_t>();
            case Type::uint32:
                return read<std::uint32_t>();
            case Type::float32:
                return read<float>();
            case Type::float64:
                return read<double>();
        }
        return 0.0;
    }

    const SourceText& text_;
    Encoding encoding_;
    std::string_view bytes_;
    Lines lines_;
    std::string where_;
    std::string_view line_;
    std::vector<std::string_view> words_;
    std::size_t used_ = 0;
};

void skip_list(Body& body, const Property& p) {
    const double length = body.value(*p.list_count);
    for (double k = 0; k < length; ++k) body.value(p.type);
}

void skip(Body& body, const Element& element) {
    if (element.properties.empty()) return;
    for (std::size_t row = 0; row < element.count; ++row) {
        body.begin_row(element, row);
        for (const Property& p : element.properties)
            p.list_count ? skip_list(body, p) : static_cast<void>(body.value(p.type));
        body.end_row();
    }
}

PointFile read_vertices(const SourceText& text, Body& body, const Element& vertex) {
    std::vector<std::string> names;
    for (const Property& p : vertex.properties)
        if (!p.list_count) names.push_back(p.name);
    if (const std::string missing = missing_coordinate(names); !missing.empty())
        text.reject(vertex.name, "a scalar property \"" + missing + "\" of the element vertex",
                    "none of that name");
    if (vertex.count == 0) text.reject(vertex.name, "at least one vertex", "none");
    if (vertex.count > most_points)
        text.reject(vertex.name, "at most 4294967294 vertices", std::to_string(vertex.count));

    PointTable table(names);
    for (std::size_t row = 0; row < vertex.count; ++row) {
        body.begin_row(vertex, row);
        table.begin_row();
        std::size_t column = 0;
        for (const Property& p : vertex.properties) {
            if (p.list_count) {
                skip_list(body, p);
                continue;
            }
            const double value = body.value(p.type);
            if (!std::isfinite(value))
                text.reject_at(body.where() + ", property \"" + p.name + "\"", "a finite number",
                               std::to_string(value));
            table.add(column++, value);
        }
        body.end_row();
    }
    return table.take();
}
}  // namespace

PointFile parse_ply_points(const SourceText& text) {
    const Header header = parse_header(text);
    Body body(text, header);
    for (const Element& element : header.elements) {
        if (element.name == "vertex") return read_vertices(text, body, element);
        skip(body, element);
    }
    text.reject(text.bytes(), "an element \"vertex\" in the header", "none");
}

}  // namespace plumbline
