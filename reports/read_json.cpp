#include "reports/read_json.h"

#include "reports/files.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

Json read_json(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    try {
        return Json::parse(std::string_view(text));
    } catch (const Json::parse_error& e) {
        const std::string before = text.substr(0, e.byte > 0 ? e.byte - 1 : 0);
        const auto line = 1 + std::ranges::count(before, '\n');
        const auto column = before.size() - (before.rfind('\n') + 1) + 1;
        throw plumbline::InvalidInput(fmt::format("{}:{}:{}: expected JSON, as --json writes it",
                                                  file.string(), line, column));
    }
}

Json parse_json(std::string_view text) { return Json::parse(text, nullptr, false); }

}  // namespace reports
