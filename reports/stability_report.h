#pragma once

#include "reports/charts/chart.h"
#include "reports/json.h"
#include "reports/pieces.h"
#include "verification/stability/map.h"

namespace reports {

Json json_of(const verification::MapResult& result);

/// The theory of each line as a curve, the borders of the runs as points of the same colour.
Chart chart_of(const verification::MapResult& result);

/// Each map and its chart, one after the other, kept as pieces; a failure to finish one is an "error" in its place.
Json run_maps(const std::vector<verification::Map>& maps, verification::Effort effort,
              Pieces& pieces);

}  // namespace reports
