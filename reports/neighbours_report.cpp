#include "reports/neighbours_report.h"

#include "benchmarks/neighbours/verdicts.h"

#include <fmt/format.h>

namespace reports {

using namespace benchmarks;

namespace {
Json json_of_runs(const std::vector<double>& seconds) {
    const Timing timing = summarise(seconds);
    return {{"median_s", number(timing.median_s)},
            {"mad_s", number(timing.mad_s)},
            {"runs_s", seconds}};
}

Json json_of_ratio(const Ratio& ratio) {
    return {
        {"value", number(ratio.value)}, {"low", number(ratio.low)}, {"high", number(ratio.high)}};
}

/// The cost of each search over that of the fastest, and the places it may have.
void add_standing(const CaseResult& c, Json& searches) {
    const Standing standing = standing_of(c);
    if (standing.best.empty()) return;
    const auto places = places_of(c);
    for (std::size_t k = 0; k < c.searches.size(); ++k) {
        const SearchResult& s = c.searches[k];
        if (!s.agrees()) continue;
        const bool is_fastest = &s == standing.best.front();
        if (places[k] != Places{}) {
            searches[k]["first_place"] = places[k].first;
            searches[k]["last_place"] = places[k].last;
        }
        searches[k]["over_fastest"] = json_of_ratio(
            is_fastest ? Ratio{1, 1, 1} : ratio_of(s, *standing.best.front(), total_cost, c.noise));
    }
}

Json json_of_exponents(const std::vector<CaseResult>& cases) {
    Json all = Json::array();
    const auto add = [&](const char* phase, const Cost& cost) {
        for (const Exponent& e : exponents(cases, cost))
            all.push_back({{"search", e.search},
                           {"phase", phase},
                           {"value", number(e.value)},
                           {"low", number(e.low)},
                           {"high", number(e.high)},
                           {"n_log_n", number(e.n_log_n)}});
    };
    add("build", [](const Runs& runs) { return runs.build; });
    add("query", [](const Runs& runs) { return runs.query; });
    return all;
}

/// What is asked beside points and radius.
std::string conditions_of(const CaseResult& c) {
    std::string text;
    if (c.contrast) text += fmt::format("density 1:{:g}, ", *c.contrast);
    if (c.own_radii) text += "own radii, ";
    if (c.moved > 0.0) text += fmt::format("{:g} % moved, ", 100.0 * c.moved);
    return text + fmt::format("{}, {} thread{}", c.order, c.threads, c.threads == 1 ? "" : "s");
}

template <class Results> Json all_of(const Results& results) {
    Json all = Json::array();
    for (const auto& result : results) all.push_back(reports::json_of(result));
    return all;
}
}  // namespace

std::string in_words(const CaseResult& c) {
    return fmt::format("{} {}D, {} points, r = {:.4g}, {}", c.cloud, c.dim, c.count, c.radius,
                       conditions_of(c));
}

Json json_of(const SearchResult& s) {
    Json json = {{"search", s.name},
                 {"form", s.form},
                 {"is_full_answer", s.is_full_answer},
                 {"left_out", s.left_out},
                 {"wrong_pairs", s.wrong_pairs},
                 {"cold_build_s", number(s.cold_build_s)},
                 {"cold_query_s", number(s.cold_query_s)},
                 {"held_bytes", s.held_bytes},
                 {"lists_bytes", s.lists_bytes},
                 {"peak_bytes", s.peak_bytes ? Json(*s.peak_bytes) : Json()}};
    if (s.runs.build.empty()) return json;
    json["build"] = json_of_runs(s.runs.build);
    json["query"] = json_of_runs(s.runs.query);
    json["total"] = json_of_runs(s.runs.total());
    if (s.runs.update.empty()) return json;
    json["update"] = json_of_runs(s.runs.update);
    json["requery"] = json_of_runs(s.runs.requery);
    return json;
}

Json json_of(const CaseResult& c) {
    Json searches = all_of(c.searches);
    add_standing(c, searches);
    return {{"id", conditions_of(c)},
            {"case", in_words(c)},
            {"cloud", c.cloud},
            {"dim", c.dim},
            {"count", c.count},
            {"contrast", c.contrast ? Json(*c.contrast) : Json()},
            {"order", c.order},
            {"radius", number(c.radius)},
            {"spacings", number(c.spacings)},
            {"own_radii", c.own_radii},
            {"moved", number(c.moved)},
            {"threads", c.threads},
            {"mean_neighbours", number(c.mean_neighbours)},
            {"unevenness", number(c.unevenness)},
            {"points_bytes", c.points_bytes},
            {"lists_bytes", c.lists_bytes},
            {"brute_force_rows", c.brute_force_rows},
            {"noise", number(c.noise)},
            {"one_at_a_time", c.one_at_a_time},
            {"recommendation", recommendation(c)},
            {"searches", std::move(searches)}};
}

Json json_of(const SearchStudyResult& study) {
    Json verdicts = Json::array();
    for (const benchmarks::Verdict& v : verdicts_on_section_5_3(study))
        verdicts.push_back({{"source", v.source},
                            {"statement", v.statement},
                            {"verdict", v.word},
                            {"evidence", v.evidence}});
    return {{"id", study.name},
            {"question", study.question},
            {"cases", all_of(study.cases)},
            {"exponents", study.name == "size" ? json_of_exponents(study.cases) : Json::array()},
            {"verdicts", std::move(verdicts)}};
}

Json json_of(const NeighbourComparison& comparison) {
    return {{"command", comparison.command}, {"studies", all_of(comparison.studies)}};
}

std::string csv_of(const NeighbourComparison& comparison) {
    std::string text =
        "study,cloud,dim,points,contrast,order,radius,own_radii,moved,threads,neighbours,noise,"
        "search,wrong_pairs,build_s,build_mad_s,query_s,query_mad_s,total_s,update_s,requery_s,"
        "cold_build_s,cold_query_s,held_bytes,peak_bytes,points_bytes,lists_bytes\n";
    const auto seconds = [](double s) { return std::isfinite(s) ? fmt::format("{:.6g}", s) : ""; };
    for (const SearchStudyResult& study : comparison.studies)
        for (const CaseResult& c : study.cases)
            for (const SearchResult& s : c.searches)
                text += fmt::format(
                    "{},{},{},{},{},{},{:.17g},{},{:g},{},{:.6g},{},{},{},{},{},{},{},{},{},{},{},{"
                    "},{},{},{},{}\n",
                    study.name, c.cloud, c.dim, c.count,
                    c.contrast ? fmt::format("{:g}", *c.contrast) : "", c.order, c.radius,
                    c.own_radii ? 1 : 0, c.moved, c.threads, c.mean_neighbours, seconds(c.noise),
                    s.name, s.wrong_pairs, seconds(s.build().median_s), seconds(s.build().mad_s),
                    seconds(s.query().median_s), seconds(s.query().mad_s),
                    seconds(s.total().median_s), seconds(s.update().median_s),
                    seconds(summarise(s.runs.requery).median_s), seconds(s.cold_build_s),
                    seconds(s.cold_query_s), s.held_bytes,
                    s.peak_bytes ? fmt::format("{}", *s.peak_bytes) : "", c.points_bytes,
                    c.lists_bytes);
    return text;
}

}  // namespace reports
