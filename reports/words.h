#pragma once

#include "reports/json.h"

#include <string>

namespace reports {

/// A number for people: "1.23e-05", "12", "0.5", "∞"; "none" for null.
std::string short_number(const Json& value);

/// "1.2, 1.3, none" of a list.
std::string in_words(const Json& numbers);

/// An order for a sentence, one digit after the point; what rounds to zero has no sign.
std::string order_in_words(double order);

/// "≤ 1e-06", "≥ 1", "in [0.9, 2.1]" of a bound as json_of(Bound) gives it.
std::string bound_in_words(const Json& bound);

/// "1 claim", "3 claims".
std::string counted(std::size_t n, const std::string& noun);

/// "ok", "bad" or "open" for a word of a verdict: the class of its colour on the page.
std::string colour_class(const std::string& verdict);

/// How many of `results` have this verdict.
std::size_t count_verdict(const Json& results, const std::string& verdict);

}  // namespace reports
