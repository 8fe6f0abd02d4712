// Turns a C++ expression into the formula that it is, character by character in the same place.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "closures/statement.hpp"

namespace assur::generator::audit {

/// What of C++ no formula stands for, and at which column of the text.
struct CodeError : std::runtime_error {
  CodeError(const std::string& what, std::size_t at) : std::runtime_error(what), column(at) {}
  std::size_t column;
};

/// A statement of C++, and the character that ends it.
struct CodeStatement {
  closures::PlacedText text;
  char end = ';';
  bool conditional = false;  ///< inside a block that may run any number of times
};

/// The statements between ; { and }, without comments and each on one line: a place behind the end
/// of a line means the lines below, see place_in_code.
[[nodiscard]] std::vector<CodeStatement> code_statements(const std::string& code);
/// The place in the code, where the column counts on over the ends of lines.
[[nodiscard]] closures::Place place_in_code(const std::string& code, closures::Place place);

/// `a.b` and `a->b` become a_b, `a[2]` and, unless a is a function, `a(2)` become a_2, `a(1, 2)`
/// becomes a_1_2; `std::` and the suffixes of numbers go. What goes becomes spaces. Throws
/// CodeError for casts, `^`, and quotients of whole numbers, which mean something else in C++.
[[nodiscard]] std::string code_as_formula(const std::string& code);

}  // namespace assur::generator::audit
