#pragma once

#include "benchmarks/neighbours/studies.h"

namespace reports {

/// What is asked on the command line. All combinations of the values are measured; an empty list stands
/// for the usual value.
struct NeighbourRequest {
    std::vector<std::string> clouds, orders;
    std::vector<plumbline::Index> counts;
    std::vector<double> contrasts, spacings, moved;
    std::optional<double> radius;
    int dim = 3;
    bool own_radii = false;
};

/// The studies of a request: one for each combination of what is not the main thing varied, which is
/// the first of contrast, count, cloud, order, radius and moved that has more than one value.
/// Throws InvalidInput if values make no sense together, or out of their range.
std::vector<benchmarks::SearchStudy> plan(const NeighbourRequest& request);

}  // namespace reports
