#pragma once

#include <fnmatch.h>

#include <algorithm>
#include <string>
#include <vector>

namespace reports {

/// Whether `id` contains `pattern`, or matches it as shell wildcards do.
inline bool matches(const std::string& pattern, const std::string& id) {
    return id.find(pattern) != std::string::npos || fnmatch(pattern.c_str(), id.c_str(), 0) == 0;
}

/// Those entries (claims, studies) that match one of the patterns and have the tag; no pattern and no
/// tag select all.
template <class Entry>
std::vector<Entry> select(const std::vector<Entry>& all, const std::vector<std::string>& patterns,
                          const std::string& tag = {}) {
    std::vector<Entry> selected;
    for (const Entry& entry : all) {
        const bool named = patterns.empty() || std::ranges::any_of(patterns, [&](const auto& p) {
                               return matches(p, entry.id);
                           });
        const bool tagged = tag.empty() || std::ranges::count(entry.tags, tag) > 0;
        if (named && tagged) selected.push_back(entry);
    }
    return selected;
}

}  // namespace reports
