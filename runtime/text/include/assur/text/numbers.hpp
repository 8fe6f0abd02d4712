// Numbers as text for people.
#pragma once

#include <string>

namespace assur::text {

/// The number with at most `digits` digits, as `%g` prints it; 0 for -0.
[[nodiscard]] std::string short_number(double number, int digits);

}  // namespace assur::text
