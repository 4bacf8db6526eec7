#include "solver/io/read_points.h"

#include "solver/io/point_formats.h"

#include <algorithm>
#include <cctype>

namespace plumbline {

namespace {
std::string lower_case_extension(const std::string& name) {
    std::string extension = std::filesystem::path(name).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// A first line of numbers between blanks is XYZ; anything else is the header of a CSV.
bool begins_like_xyz(std::string_view bytes) {
    Lines lines(bytes);
    while (const auto line = lines.next()) {
        const auto first = trimmed(*line);
        if (first.empty() || first.starts_with('#')) continue;
        return first.find(',') == first.npos &&
               std::isalpha(static_cast<unsigned char>(first[0])) == 0;
    }
    return false;
}

PointFormat format_of(const SourceText& text) {
    const std::string_view bytes = text.bytes();
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n")) return PointFormat::ply;
    if (trimmed(bytes.substr(0, 400)).starts_with('<')) return PointFormat::vtp;
    const std::string extension = lower_case_extension(text.name());
    if (extension == ".ply") return PointFormat::ply;
    if (extension == ".vtp") return PointFormat::vtp;
    if (extension == ".xyz") return PointFormat::xyz;
    if (extension == ".csv") return PointFormat::csv;
    return begins_like_xyz(bytes) ? PointFormat::xyz : PointFormat::csv;
}

PointFile parse(const SourceText& text) {
    switch (format_of(text)) {
        case PointFormat::csv:
            return parse_csv_points(text);
        case PointFormat::xyz:
            return parse_xyz_points(text);
        case PointFormat::ply:
            return parse_ply_points(text);
        case PointFormat::vtp:
            return parse_vtp_points(text);
    }
    return {};
}
}  // namespace

const std::vector<double>* PointFile::find(std::string_view name) const {
    const auto found = std::ranges::find(columns, name, &PointColumn::name);
    return found == columns.end() ? nullptr : &found->values;
}

const std::vector<double>& PointFile::column(std::string_view name) const {
    if (const auto* values = find(name)) return *values;
    std::string there;
    for (const PointColumn& c : columns) there.append(there.empty() ? "" : ", ").append(c.name);
    throw InvalidInput("expected a column \"" + std::string(name) + "\", found " +
                       (there.empty() ? "coordinates only" : "only: " + there));
}

PointTable::PointTable(const std::vector<std::string>& names) {
    constexpr std::string_view axes[] = {"x", "y", "z"};
    file_.dim = std::ranges::find(names, "z") == names.end() ? 2 : 3;
    for (const std::string& name : names) {
        const auto axis = std::ranges::find(axes, name);
        coordinate_of_.push_back(axis == std::end(axes) ? -1 : static_cast<int>(axis - axes));
        column_of_.push_back(file_.columns.size());
        if (axis == std::end(axes)) file_.columns.push_back({name, {}});
    }
}

std::string missing_coordinate(const std::vector<std::string>& names) {
    for (const char* axis : {"x", "y"})
        if (std::ranges::find(names, axis) == names.end()) return axis;
    return {};
}

PointFile read_points(const std::filesystem::path& path) { return parse(SourceText::read(path)); }

PointFile parse_points(std::string name, std::string bytes) {
    return parse(SourceText(std::move(name), std::move(bytes)));
}

}  // namespace plumbline
