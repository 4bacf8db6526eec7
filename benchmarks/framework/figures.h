#pragma once

#include <string>

namespace benchmarks {

/// A factor in a sentence, with two significant figures: "0.34", "1.8", "180", "1.8·10⁵"; "none" for what is
/// no positive number.
std::string factor_in_words(double factor);

}  // namespace benchmarks
