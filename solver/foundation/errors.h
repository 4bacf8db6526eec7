#pragma once

#include <stdexcept>

namespace plumbline {

/// The caller passed something that no implementation could work with. The message says what was
/// expected, what was found, and where: "points.csv:3:5: expected a finite number, found \"abc\"".
struct InvalidInput : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

}  // namespace plumbline
