#pragma once

#include "reports/provenance.h"
#include "verification/framework/claim.h"
#include "verification/framework/registry.h"
#include "verification/framework/study.h"

#include <nlohmann/json.hpp>

#include <span>

namespace reports {

using Json = nlohmann::ordered_json;

/// The number, or what stands for it where JSON has none: "inf" and "-inf" (a bound that is open on
/// that side), null for NaN (no answer).
Json number(double value);

/// The opposite: the number, an infinity, or NaN for null and everything else.
double value_of(const Json& number);

Json json_of(const Provenance& provenance);
Json json_of(const verification::Source& source);
Json json_of(const verification::Bound& bound);
Json json_of(const verification::ClaimResult& result);
Json json_of(const verification::StudyResult& result);
Json json_of(const verification::Erratum& erratum);

/// {"schema": "plumbline.KIND/1", "provenance": {...}, KIND: results}
Json document(const std::string& kind, Json results);

template <class Results> Json json_array(const Results& results) {
    Json all = Json::array();
    for (const auto& result : results) all.push_back(json_of(result));
    return all;
}

/// As it stands in a file: a line for each value, and a newline at the end. It and one_line() are here
/// because each file that calls Json::dump() compiles all of the writer; read_json.h has the reader.
std::string lines(const Json& json);
std::string one_line(const Json& json);

/// Writes to stdout if `target` is "-", else to that file.
/// Throws std::runtime_error if the file cannot be written.
void write_json(const Json& json, const std::string& target);

}  // namespace reports
