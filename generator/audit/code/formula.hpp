// Turns a C++ expression into a formula with every name and number in the same place.
#pragma once

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

/// A variable, a member `a.b` or an element `a[2]`, `a(1, 2)` of one.
struct CodeName {
  std::string name;     ///< in formulas: `a_b`, `a_2`, `a_1_2`
  std::string spelled;  ///< `a.b` for `a->b` too, `a[2]` for `a(2)` too
  closures::Place place;
  bool called = false;  ///< it is spelled with round brackets, and may be a call

  /// Whether it is that variable, or a part of it.
  [[nodiscard]] bool is_part_of(const CodeName& whole) const;
};

/// The longest name that the tokens begin with, and its number of tokens; zero for a function.
struct LeadingName {
  CodeName name;
  std::size_t tokens = 0;
};
[[nodiscard]] LeadingName leading_name(Tokens tokens);

struct CodeFormula {
  closures::PlacedText text;  ///< its columns are counted across line ends
  std::vector<CodeName> names;
  std::vector<CodeName> unknown_calls;  ///< of functions that formulas do not have
};

/// What is spelled alike in C++ and MATLAB but means something different.
struct Dialect {
  bool caret_is_power = false;
  bool pi_is_known = false;
  bool whole_quotients_round = true;
};

/// Replaces `std::`, `this->` and the suffixes of numbers by spaces. Throws CodeError for what has
/// another meaning in C++ than in formulas: casts, `^`, `++`, `=`, octal numbers.
[[nodiscard]] CodeFormula code_formula(Tokens tokens, const Dialect& dialect = {});

/// Whether the formula's value is a whole number in C++, as those of the variables `whole` are.
/// Throws CodeError for a quotient of whole numbers, which is rounded, and for what no `int` holds.
[[nodiscard]] bool is_whole(const CodeFormula& formula, const std::vector<CodeName>& whole);

/// Whether a function of this name is read as the mathematical function.
[[nodiscard]] bool is_known_function(const std::string& name);

}  // namespace assur::generator::audit::code
