#pragma once

#include "verification/stability/map.h"

namespace verification {

/// The largest and the smallest point of all curves of a map, lines that only show a rule left out.
struct Extremes {
    std::string low_name, high_name;
    double low_x, low, high_x, high;
};
Extremes extremes_of(const MapResult& result);

/// "runs agree with theory within 0.4 %".
std::string agreement(const MapResult& result);

}  // namespace verification
