#include "verification/stability/findings.h"

#include <fmt/format.h>

namespace verification {

Extremes extremes_of(const MapResult& result) {
    Extremes e{"", "", 0.0, HUGE_VAL, 0.0, -HUGE_VAL};
    for (const LineResult& line : result.lines) {
        if (!line.line.measured) continue;
        for (std::size_t k = 0; k < line.curve.size(); ++k) {
            const double x = result.map.curve_at[k], y = line.curve[k];
            if (y < e.low) e.low_name = line.line.name, e.low_x = x, e.low = y;
            if (y > e.high) e.high_name = line.line.name, e.high_x = x, e.high = y;
        }
    }
    return e;
}

std::string agreement(const MapResult& result) {
    return fmt::format("runs agree with theory within {:.1f} %", 100.0 * result.worst);
}

}  // namespace verification
