#include "reports/comparison.h"

#include "reports/times.h"
#include "reports/words.h"
#include "solver/foundation/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace reports {

namespace {
using Word = Change::Verdict;
using Entries = std::map<std::string, Json>;

void check(const Json& file, const char* which) {
    const bool known = file.is_object() && file.contains("schema") && file["schema"].is_string() &&
                       file["schema"].get<std::string>().starts_with("plumbline.");
    if (!known)
        throw plumbline::InvalidInput(
            fmt::format("the {} file: expected a result of plumbline with a \"schema\", found {}",
                        which, file.is_object() ? "an object without it" : file.type_name()));
}

/// Higher is better.
int rank(const std::string& verdict) {
    if (verdict == "verified") return 2;
    return verdict == "failed" || verdict == "toothless" || verdict == "saturated" ? 0 : 1;
}

Change by_verdict(const std::string& id, const Json& before, const Json& now) {
    const std::string a = before.at("verdict"), b = now.at("verdict");
    if (rank(b) > rank(a)) return {Word::better, id, a, b, "verdict"};
    if (rank(b) < rank(a)) return {Word::worse, id, a, b, "verdict"};
    if (rank(a) == 1) return {Word::cannot_tell, id, a, b, "neither run can tell"};
    return {Word::same, id, a, b, "same verdict"};
}

Change of_claim(const std::string& id, const Json& before, const Json& now) {
    Change change = by_verdict(id, before, now);
    change.before += " " + short_number(before.at("measured"));
    change.now += " " + short_number(now.at("measured"));
    return change;
}

Change of_series(const std::string& id, const Json& before, const Json& now) {
    Change change = by_verdict(id, before, now);
    const Json &a = before.at("confidence"), &b = now.at("confidence");
    const auto text = [](const Json& s) {
        return fmt::format(" order {} [{}, {}]", short_number(s.at("order")),
                           short_number(s.at("confidence")[0]),
                           short_number(s.at("confidence")[1]));
    };
    change.before += text(before);
    change.now += text(now);
    const bool known = a[0].is_number() && b[0].is_number();
    if (change.verdict != Word::same || !known) return change;
    if (b[0] > a[1]) change.verdict = Word::better, change.why = "the order is higher";
    if (b[1] < a[0]) change.verdict = Word::worse, change.why = "the order is lower";
    return change;
}

Entries claims_in(const Json& file) {
    Entries all;
    if (file.contains("claims"))
        for (const Json& claim : file["claims"])
            all["claims/" + claim.at("id").get<std::string>()] = claim;
    return all;
}

Entries series_in(const Json& file) {
    Entries all;
    if (file.contains("studies"))
        for (const Json& study : file["studies"])
            for (const Json& s : study.at("series"))
                all["studies/" + study.at("id").get<std::string>() + "/" +
                    s.at("name").get<std::string>()] = s;
    return all;
}

template <class Of>
void pair_up(const Entries& before, const Entries& now, Of change_of,
             std::vector<Change>& changes) {
    for (const auto& [id, entry] : before) {
        const auto same = now.find(id);
        if (same == now.end())
            changes.push_back(
                {Word::cannot_tell, id, "there", "not there", "only in the old file"});
        else
            changes.push_back(change_of(id, entry, same->second));
    }
    for (const auto& [id, entry] : now)
        if (!before.contains(id))
            changes.push_back(
                {Word::cannot_tell, id, "not there", "there", "only in the new file"});
}

void compare_times(const Json& before, const Json& now, std::vector<Change>& changes) {
    const std::map<std::string, Time> a = times_in(before), b = times_in(now);
    const std::string obstacle = obstacle_to_comparing_times(before, now);
    const double floor = std::max(noise_floor_in(before), noise_floor_in(now));
    for (const auto& [id, old_time] : a) {
        const auto same = b.find(id);
        if (same == b.end()) {
            changes.push_back(
                {Word::cannot_tell, id, "there", "not there", "only in the old file"});
            continue;
        }
        Change change{Word::cannot_tell, id, fmt::format("{:.3g} s", old_time.median_s),
                      fmt::format("{:.3g} s", same->second.median_s), obstacle};
        if (obstacle.empty()) {
            const double ratio = same->second.median_s / old_time.median_s;
            const double least = least_ratio_to_tell(old_time, same->second, floor);
            change.why = fmt::format("{:.3g} times the old time; told apart beyond a factor {:.3g}",
                                     ratio, least);
            if (ratio > least) change.verdict = Word::worse;
            if (ratio < 1.0 / least) change.verdict = Word::better;
        }
        changes.push_back(std::move(change));
    }
    for (const auto& [id, time] : b)
        if (!a.contains(id))
            changes.push_back(
                {Word::cannot_tell, id, "not there", "there", "only in the new file"});
}
}  // namespace

std::string_view name_of(Change::Verdict verdict) {
    switch (verdict) {
        case Word::worse:
            return "worse";
        case Word::better:
            return "better";
        case Word::cannot_tell:
            return "cannot tell";
        case Word::same:
            return "same";
    }
    return "";
}

Json json_of(const Change& c) {
    return {{"verdict", name_of(c.verdict)},
            {"id", c.id},
            {"before", c.before},
            {"now", c.now},
            {"why", c.why}};
}

std::vector<Change> compare(const Json& before, const Json& now) {
    check(before, "old");
    check(now, "new");
    std::vector<Change> changes;
    try {
        pair_up(claims_in(before), claims_in(now), of_claim, changes);
        pair_up(series_in(before), series_in(now), of_series, changes);
        compare_times(before, now, changes);
    } catch (const Json::exception& e) {
        throw plumbline::InvalidInput(std::string("a result has not the form it should have: ") +
                                      e.what());
    }
    std::ranges::stable_sort(changes, {}, &Change::verdict);
    return changes;
}

}  // namespace reports
