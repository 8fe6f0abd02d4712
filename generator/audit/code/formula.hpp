// Turns a C++ expression into the formula that it is, character by character in the same place.
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

/// The longest name that tokens begin with, and of how many tokens it is; none for a function.
struct LeadingName {
  CodeName name;
  std::size_t tokens = 0;
};
[[nodiscard]] LeadingName leading_name(Tokens tokens);

struct CodeFormula {
  closures::PlacedText text;  ///< its columns count on over the ends of lines
  std::vector<CodeName> names;
  std::vector<CodeName> unknown_calls;  ///< of functions that formulas do not have
};

/// What languages write alike and mean otherwise.
struct Dialect {
  bool caret_is_power = false;
  bool pi_is_known = false;
  bool whole_quotients_round = true;
};

/// `std::`, `this->` and the suffixes of numbers go and become spaces. Throws CodeError for what
/// means something else in C++: casts, `^`, `++`, `=`, octal numbers.
[[nodiscard]] CodeFormula code_formula(Tokens tokens, const Dialect& dialect = {});

/// Whether the formula's value is a whole number in C++, where `whole` are such variables. Throws
/// CodeError for a quotient of two, which is rounded, and for what no `int` can hold.
[[nodiscard]] bool is_whole(const CodeFormula& formula, const std::vector<CodeName>& whole);

/// Whether a function of this name is read as the one of mathematics.
[[nodiscard]] bool is_known_function(const std::string& name);

}  // namespace assur::generator::audit::code
