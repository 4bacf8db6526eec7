#pragma once

#include "verification/framework/expected_order.h"

namespace verification {

/// One study of approximations: every method for one quantity, or a few of them with each kernel of the
/// studies, under one set of conditions.
struct ApproximationPlan {
    Quantity quantity;
    Conditions conditions;
    bool all_kernels = false;
};

/// Values are measured between samples, derivatives at samples: conditions.measured_at is set so.
Study study_of(ApproximationPlan plan);

}  // namespace verification
