// Turns the beginning of a C++ declaration into its type's length and the sort of its values.
#pragma once

#include <map>

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

/// How many tokens of a declaration are its type; zero for a statement that declares nothing.
[[nodiscard]] std::size_t type_length(Tokens tokens);

/// What a type's values are to a formula: real numbers, whole ones, numbers that are rounded or
/// wrapped round when they are stored, or anything else.
enum class ValueSort : unsigned char { real, whole, rounded, unknown };

/// The types to which some code gives names of its own, and what their values are.
class TypeNames {
 public:
  [[nodiscard]] ValueSort sort_of(Tokens type) const;
  /// `NAME = TYPE`: another name for a type.
  void define(const std::string& name, Tokens type);
  /// A template's type, which is taken as one of real numbers.
  void add_real(const std::string& name) { named_[name] = ValueSort::real; }

 private:
  [[nodiscard]] ValueSort sort_of(const Token& token) const;

  std::map<std::string, ValueSort> named_ = {{"double", ValueSort::real},
                                             {"auto", ValueSort::real},
                                             {"Scalar", ValueSort::real}};  // of an Eigen matrix
};

/// Why values of this sort are not read, as the end of a message.
[[nodiscard]] const char* why_not_read(ValueSort sort);

}  // namespace assur::generator::audit::code
