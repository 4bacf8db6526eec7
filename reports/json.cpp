#include "reports/json.h"

#include "verification/framework/mutant.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace reports {

using namespace verification;

namespace {
Json numbers(const std::vector<double>& values) {
    Json all = Json::array();
    for (const double v : values) all.push_back(number(v));
    return all;
}

Json json_of(const Interval& interval) {
    return Json::array({number(interval.low), number(interval.high)});
}

Json json_of(const SeriesResult& s) {
    Json errors = Json::array();
    for (const auto& level : s.errors) errors.push_back(numbers(level));
    return {{"name", s.name},
            {"verdict", name_of(s.verdict)},
            {"order", number(s.fit.order)},
            {"confidence", json_of(s.fit.confidence)},
            {"expected", reports::json_of(s.expected_order)},
            {"expected_saturation", s.expected_saturation},
            {"sabotaged", s.sabotaged},
            {"level_errors", numbers(s.fit.error)},
            {"floor", number(s.fit.floor)},
            {"local_orders", numbers(s.fit.local_orders)},
            {"grid_convergence_index", number(s.fit.grid_convergence_index)},
            {"safety_factor", number(s.fit.safety_factor)},
            {"failures", s.failures},
            {"errors", std::move(errors)}};
}
}  // namespace

Json number(double value) {
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    return std::isnan(value) ? Json(nullptr) : Json(value);
}

double value_of(const Json& number) {
    if (number.is_number()) return number.get<double>();
    if (number == "inf") return HUGE_VAL;
    return number == "-inf" ? -HUGE_VAL : std::numeric_limits<double>::quiet_NaN();
}

Json json_of(const Provenance& p) {
    return {
        {"version", p.version},           {"compiler", p.compiler},   {"flags", p.flags},
        {"processor", p.processor},       {"cores", p.cores},         {"memory_gb", p.memory_gb},
        {"threads", p.threads},           {"libraries", p.libraries}, {"seeds", p.seeds},
        {"command_line", p.command_line}, {"started", p.started}};
}

Json json_of(const Source& source) {
    return {{"paper", name_of(source.paper)}, {"place", source.place}};
}

Json json_of(const Bound& bound) {
    return {{"low", number(bound.low)}, {"high", number(bound.high)}, {"why", bound.why}};
}

Json json_of(const ClaimResult& r) {
    Json json = {{"id", r.claim.id},
                 {"source", json_of(r.claim.source)},
                 {"says", r.claim.says},
                 {"measured", number(r.measured)},
                 {"bound", json_of(r.claim.bound)},
                 {"verdict", name_of(r.verdict)},
                 {"sabotaged", nullptr},
                 {"seconds", r.seconds}};
    if (r.sabotaged)
        json["sabotaged"] = {{"measured", number(*r.sabotaged)},
                             {"caught", !r.claim.bound.holds(*r.sabotaged)}};
    if (r.claim.erratum) json["erratum"] = *r.claim.erratum;
    for (const Mutant* mutant : r.depends_on) json["depends_on"].push_back(mutant->printed);
    if (!r.error.empty()) json["error"] = r.error;
    return json;
}

Json json_of(const StudyResult& r) {
    Json series = Json::array();
    for (const SeriesResult& s : r.series) series.push_back(json_of(s));
    Json json = {{"id", r.study.id},
                 {"source", json_of(r.study.source)},
                 {"says", r.study.says},
                 {"quantity", r.study.quantity},
                 {"spacing", numbers(r.spacing)},
                 {"seeds", r.seeds},
                 {"series", std::move(series)},
                 {"seconds", r.seconds}};
    if (!r.warning.empty()) json["warning"] = r.warning;
    if (!r.error.empty()) json["error"] = r.error;
    return json;
}

Json json_of(const Erratum& e) {
    return {{"number", e.number},
            {"source", json_of(e.source)},
            {"printed", e.printed},
            {"corrected", e.corrected}};
}

Json document(const std::string& kind, Json results) {
    return {{"schema", "plumbline." + kind + "/1"},
            {"provenance", json_of(provenance())},
            {kind, std::move(results)}};
}

std::string lines(const Json& json) { return json.dump(1) + "\n"; }

std::string one_line(const Json& json) { return json.dump(); }

void write_json(const Json& json, const std::string& target) {
    const std::string text = lines(json);
    if (target == "-") {
        fmt::print("{}", text);
        return;
    }
    std::ofstream file(target, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + target);
}

}  // namespace reports
