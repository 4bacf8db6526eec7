#include "reports/sections/section.h"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {
std::vector<Section>& registered() {
    static std::vector<Section> all;
    return all;
}
}  // namespace

std::vector<Section> sections() {
    std::vector<Section> all = registered();
    std::ranges::sort(all, {}, &Section::place);
    return all;
}

RegisterSection::RegisterSection(Section section) { registered().push_back(std::move(section)); }

Json ReportRun::piece(const std::string& key, const std::string& what,
                      const std::function<Json()>& make) {
    return pieces.get(key, [&] {
        fmt::print(stderr, "plumbline: {}\n", what);
        return make();
    });
}

}  // namespace reports
