#pragma once

#include "reports/json.h"

#include <map>
#include <string>

namespace reports {

/// Median and median absolute deviation [s].
struct Time {
    double median_s, mad_s;
};

/// Every object with a "median_s" in a result, at any depth, by where it stands. An element of an
/// array is named by what says which case it is (cloud, count, search, method, kernel …), so that
/// neither the order of the array nor what was measured matters.
std::map<std::string, Time> times_in(const Json& result);

/// The largest relative noise floor that was measured with the result; 0 if none was.
double noise_floor_in(const Json& result);

/// Why the times of two results must not be compared; empty if they may be.
std::string obstacle_to_comparing_times(const Json& before, const Json& now);

/// From which ratio on two medians differ by more than noise.
double least_ratio_to_tell(const Time& a, const Time& b, double noise_floor);

}  // namespace reports
