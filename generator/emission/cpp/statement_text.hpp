// Prints expressions and statements as C++.
#pragma once

#include <string>
#include <vector>

#include "emission/cpp/expression.hpp"

namespace assur::generator::emission::cpp {

/// The text of an expression that reads no locals. Numbers are of type Scalar, so that a solver in
/// float computes nothing in double.
[[nodiscard]] std::string printed(const Expression& expression);

/// The text of the statements of one function, one line each. A number is appended to the name of a
/// local if an earlier local has the same name.
[[nodiscard]] std::vector<std::string> printed(const Block& block);

}  // namespace assur::generator::emission::cpp
