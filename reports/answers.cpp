#include "reports/answers.h"

#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace reports {

namespace {
const Json& list(const Json& report, const char* key) {
    static const Json none = Json::array();
    return report.contains(key) ? report[key] : none;
}

Json tile(const std::string& label, std::size_t good, std::size_t all, const std::string& word,
          bool bad) {
    return {{"label", label},
            {"value", fmt::format("{} / {}", good, all)},
            {"word", word},
            {"class", good == all ? "ok"
                      : bad       ? "bad"
                                  : "open"}};
}

Json tile_of_claims(const Json& claims) {
    const std::size_t good = count_verdict(claims, "verified");
    const std::size_t failed = count_verdict(claims, "failed");
    const std::size_t toothless = count_verdict(claims, "toothless");
    return tile("claims verified", good, claims.size(),
                fmt::format("{} failed, {} toothless", failed, toothless), true);
}

/// All series of all studies, each with the id of its study.
Json series_of(const Json& studies) {
    Json all = Json::array();
    for (const Json& study : studies)
        for (Json series : study["series"]) {
            series["study"] = study["id"];
            all.push_back(std::move(series));
        }
    return all;
}

Json tile_of_studies(const Json& studies) {
    const Json series = series_of(studies);
    const std::size_t failed = count_verdict(series, "failed") +
                               count_verdict(series, "toothless") +
                               count_verdict(series, "saturated");
    const std::size_t good = count_verdict(series, "verified");
    return tile(
        "series converge as theory says", good, series.size(),
        fmt::format("{} against theory, {} cannot be told; {}", failed,
                    series.size() - good - failed,
                    studies.size() == 1 ? "1 study" : fmt::format("{} studies", studies.size())),
        failed > 0);
}

Json tile_of_errata(const Json& errata) {
    const auto caught = static_cast<std::size_t>(
        std::ranges::count_if(errata, [](const Json& e) { return e["caught"].get<bool>(); }));
    return tile("printed errors caught", caught, errata.size(),
                caught == errata.size() ? "every one" : "some pass unnoticed", true);
}

Json tile_of_statements(const Json& statements) {
    const std::size_t good = count_verdict(statements, "verified");
    return tile("statements of the text verified", good, statements.size(),
                counted(count_verdict(statements, "no claim"), "statement") + " without a claim",
                count_verdict(statements, "failed") > 0);
}

Json is_it_right(const Json& report) {
    const Json& claims = list(report, "claims");
    std::size_t with_twin = 0, refused = 0;
    for (const Json& claim : claims)
        if (!claim["sabotaged"].is_null()) {
            ++with_twin;
            if (claim["sabotaged"]["caught"]) ++refused;
        }
    Json points = Json::array();
    points.push_back(fmt::format("{} of {} hold, each measured against a bound with a reason.",
                                 count_verdict(claims, "verified"),
                                 counted(claims.size(), "claim")));
    points.push_back(
        fmt::format("{} of them were also measured on a variant that is wrong on purpose; the "
                    "bound refused {}.",
                    with_twin, with_twin == refused ? "every one" : fmt::format("{}", refused)));
    const Json& errata = list(report, "errata");
    const auto of_text = std::ranges::count_if(
        errata, [](const Json& e) { return e["source"]["paper"] == "adams2009"; });
    if (!errata.empty())
        points.push_back(fmt::format(
            "The text has {} formulas or statements wrong in the part that is covered, other "
            "sources and reference tables {}; the claims tell the printed from the corrected form "
            "in {} of them.",
            of_text, errata.size() - static_cast<std::size_t>(of_text),
            std::ranges::count_if(errata, [](const Json& e) { return e["caught"].get<bool>(); })));
    return points;
}

/// Series and how bad each is, whatever the unit; larger is worse.
struct Ranking {
    std::vector<std::pair<double, std::string>> entries;

    void add(double badness, std::string name) { entries.emplace_back(badness, std::move(name)); }
    bool empty() const { return entries.empty(); }
    std::size_t size() const { return entries.size(); }

    /// "a, b and 3 more", the worst first.
    std::string worst_first() const {
        auto sorted = entries;
        std::ranges::sort(sorted, [](const auto& a, const auto& b) {
            return std::pair(-a.first, a.second) < std::pair(-b.first, b.second);
        });
        std::string text;
        for (std::size_t n = 0; n < sorted.size(); ++n) {
            if (n == 4) return text + fmt::format(" and {} more", sorted.size() - n);
            text += (n == 0 ? "" : ", ") + sorted[n].second;
        }
        return text;
    }
};

/// The part of the error on the coarsest level that is left on the finest.
double share_left(const Json& series) {
    const Json errors = series.value("level_errors", Json::array());
    if (errors.empty() || !errors.front().is_number() || !errors.back().is_number()) return 0.0;
    const double first = errors.front(), last = errors.back();
    return first > 0.0 ? last / first : 0.0;
}

/// How far the order is from what theory expects.
double distance_to_theory(const Json& series) {
    const Json &order = series["order"], &low = series["expected"]["low"],
               &high = series["expected"]["high"];
    double distance = 0.0;
    if (!order.is_number()) return distance;
    if (low.is_number()) distance = std::max(distance, low.get<double>() - order.get<double>());
    if (high.is_number()) distance = std::max(distance, order.get<double>() - high.get<double>());
    return distance;
}

Json where_it_breaks(const Json& report) {
    Json points = Json::array();
    std::size_t all = 0;
    Ranking stalled, wrong, silent;
    for (const Json& s : series_of(list(report, "studies"))) {
        if (s.value("sabotaged", false)) continue;
        ++all;
        const std::string name = s["study"].get<std::string>() + "/" + s["name"].get<std::string>();
        const bool saturates =
            s["verdict"] == "saturated" || (s["verdict"] == "verified" && s["expected_saturation"]);
        if (saturates) stalled.add(share_left(s), name);
        if (s["verdict"] == "failed") wrong.add(distance_to_theory(s), name);
        if (s.value("failures", 0) > 0) silent.add(s.value("failures", 0), name);
    }
    if (!stalled.empty())
        points.push_back(
            fmt::format("Finer spacing does not help {} of {} series, the error rests "
                        "on a floor; the worst are {}.",
                        stalled.size(), all, stalled.worst_first()));
    if (!wrong.empty())
        points.push_back(fmt::format("{} series converge otherwise than theory says: {}.",
                                     wrong.size(), wrong.worst_first()));
    if (!silent.empty())
        points.push_back(fmt::format("{} series have samples where the method gives no answer: {}.",
                                     silent.size(), silent.worst_first()));
    return points;
}

void add(Json& answers, const char* question, Json points, const Json& from_sections) {
    for (const Json& point : from_sections) points.push_back(point);
    if (!points.empty()) answers.push_back({{"question", question}, {"points", std::move(points)}});
}
}  // namespace

Json tiles_of(const Json& report) {
    Json tiles = Json::array();
    const auto add_tile = [&](const char* key, auto make) {
        if (!list(report, key).empty()) tiles.push_back(make(report[key]));
    };
    add_tile("claims", tile_of_claims);
    add_tile("studies", tile_of_studies);
    add_tile("errata", tile_of_errata);
    add_tile("statements", tile_of_statements);
    for (const Json& tile : list(report, "tiles")) tiles.push_back(tile);
    return tiles;
}

Json answers_of(const Json& report) {
    Json answers = Json::array();
    add(answers, "Is the method right?",
        list(report, "claims").empty() ? Json::array() : is_it_right(report),
        list(report, "findings_right"));
    add(answers, "What does accuracy cost?", Json::array(), list(report, "findings_cost"));
    add(answers, "Where does it break?", where_it_breaks(report), list(report, "findings_breaks"));
    return answers;
}

}  // namespace reports
