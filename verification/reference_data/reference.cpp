#include "verification/reference_data/reference.h"

#include "solver/foundation/errors.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace verification {

namespace {
std::filesystem::path find(const std::string& name) {
    for (const char* folder : {"analytic", "published", "independent"}) {
        const auto path = std::filesystem::path(reference_folder()) / folder / (name + ".csv");
        if (std::filesystem::exists(path)) return path;
    }
    throw plumbline::InvalidInput("reference_data: expected a table, found none of the name " +
                                  name);
}
}  // namespace

std::string reference_folder() { return PLUMBLINE_REFERENCE_DATA; }

Reference::Reference(const std::string& name) : table_{plumbline::CsvTable::read(find(name))} {}

const std::vector<double>& Reference::operator[](const std::string& column) const {
    const auto found = numbers_.find(column);
    if (found != numbers_.end()) return found->second;
    return numbers_[column] = table_.numbers(column);
}

double worst_difference(const Reference& table, const std::string& column,
                        const std::function<double(const ReferenceRow&)>& exact, double floor) {
    double worst = std::nan("");
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double printed = table[column][i];
        if (std::isnan(printed)) continue;
        const double expected = exact({table, i});
        const double error = std::abs(printed - expected) / std::max(std::abs(expected), floor);
        if (!(error <= worst)) worst = error;
        if (std::isnan(error)) break;
    }
    return worst;
}

double rounding_to(int digits) { return 5.05 * std::pow(10.0, -digits); }

}  // namespace verification
