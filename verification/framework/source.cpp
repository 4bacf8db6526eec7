#include "verification/framework/source.h"

#include <regex>

namespace verification {

std::string_view name_of(Paper paper) {
    switch (paper) {
        case Paper::adams2009:
            return "adams2009";
        case Paper::wicke2006:
            return "wicke2006";
        case Paper::literature:
            return "literature";
        case Paper::plumbline:
            return "plumbline";
    }
    return "";
}

std::vector<std::string> items_of(std::string_view place) {
    static const std::regex group(R"((Eq|Alg|Sec|Table)s?\. ?|(Table) )");
    static const std::regex number(R"((\d+(?:\.\d+)*)(?:\s*(?:-|–)\s*(\d+))?)");
    std::vector<std::string> items;
    std::size_t start = 0;
    while (start <= place.size()) {
        const std::size_t end = std::min(place.find(';', start), place.size());
        const std::string part(place.substr(start, end - start));
        start = end + 1;
        std::smatch head;
        if (!std::regex_search(part, head, group) || head.position() > 1) {
            const auto first = part.find_first_not_of(' ');
            if (first != std::string::npos) items.push_back(part.substr(first));
            continue;
        }
        const std::string kind = head[1].matched ? head.str(1) + ". " : "Table ";
        const std::string rest = head.suffix();
        for (std::sregex_iterator it(rest.begin(), rest.end(), number), last; it != last; ++it) {
            if (!(*it)[2].matched) {
                items.push_back(kind + it->str(1));
                continue;
            }
            for (int n = std::stoi(it->str(1)); n <= std::stoi(it->str(2)); ++n)
                items.push_back(kind + std::to_string(n));
        }
    }
    return items;
}

}  // namespace verification
