#include "reports/times.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace reports {

namespace {
std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : one_line(value);
}

/// What says which case an element of an array is; all else in it is a result.
constexpr std::array identities{"id",
                                "task",
                                "quantity",
                                "cloud",
                                "count",
                                "dim",
                                "radius",
                                "search",
                                "method",
                                "kernel",
                                "samples_per_metre",
                                "support_in_spacings"};

std::string name_of(const Json& element, std::size_t index) {
    std::string name;
    if (element.is_object())
        for (const char* key : identities)
            if (element.contains(key)) name += (name.empty() ? "" : ",") + text_of(element[key]);
    return name.empty() ? std::to_string(index) : name;
}

void collect(const Json& json, const std::string& place, std::map<std::string, Time>& found) {
    if (json.is_object()) {
        if (json.contains("median_s") && json["median_s"].is_number())
            found[place] = {json["median_s"].get<double>(), json.value("mad_s", 0.0)};
        for (const auto& [key, value] : json.items())
            collect(value, fmt::format("{}/{}", place, key), found);
    }
    if (json.is_array())
        for (std::size_t k = 0; k < json.size(); ++k)
            collect(json[k], fmt::format("{}/{}", place, name_of(json[k], k)), found);
}
}  // namespace

std::map<std::string, Time> times_in(const Json& result) {
    std::map<std::string, Time> found;
    collect(result, "times", found);
    return found;
}

double noise_floor_in(const Json& result) {
    double floor = 0.0;
    if (result.contains("noise") && result["noise"].is_object())
        floor = result["noise"].value("relative", 0.0);
    if (result.contains("frontiers"))
        for (const Json& frontier : result["frontiers"])
            floor = std::max(floor, frontier.value("noise", 0.0));
    return floor;
}

std::string obstacle_to_comparing_times(const Json& before, const Json& now) {
    if (noise_floor_in(before) <= 0.0 || noise_floor_in(now) <= 0.0)
        return "no noise floor was measured beside it";
    const Json none = Json::object();
    const Json a = before.value("provenance", none), b = now.value("provenance", none);
    if (a.value("processor", "") != b.value("processor", "")) return "not the same processor";
    if (a.value("threads", 0) != b.value("threads", 0)) return "not the same number of threads";
    return "";
}

double least_ratio_to_tell(const Time& a, const Time& b, double noise_floor) {
    // 1.4826 MAD estimates the standard deviation of normal scatter.
    const double deviation = 1.4826 * std::hypot(a.mad_s / std::max(a.median_s, 1e-12),
                                                 b.mad_s / std::max(b.median_s, 1e-12));
    return 1.0 + std::max(noise_floor, 3.0 * deviation);
}

}  // namespace reports
