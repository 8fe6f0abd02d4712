// The values that a C++ function returns, or sets through its parameters.
#pragma once

#include "audit/code/cpp_scope.hpp"

namespace assur::generator::audit::code {

/// Reads them from the variables of the scope, which has to live on.
class CppGivenValues {
 public:
  explicit CppGivenValues(CppScope& scope) : scope_(scope) {}

  /// A parameter through which the function may set a value.
  void add_output(const std::string& name) { outputs_.push_back(name); }
  /// What the function returns: `{a, b}`, `Pair{a, b}`, `std::make_tuple(a, b)`, a variable, or one
  /// number. `result` is the type in its head.
  void give_returned(Tokens value, const Type& result);
  /// `*x = EXPR` of a parameter, which is not read from then on.
  void set_pointed(Tokens statement);
  /// What the function has set through its parameters, in their order.
  void give_outputs(const Token& function);

  [[nodiscard]] const std::vector<Cell>& cells() const { return given_; }
  [[nodiscard]] closures::Place place() const { return given_at_; }

 private:
  [[noreturn]] void refuse_returned() const;
  [[nodiscard]] bool is_several(const Token& name) const;
  void expect_values(const Type& type, std::size_t count) const;
  void collect(const Variable& variable, const Token& name);

  CppScope& scope_;
  std::vector<Cell> given_;
  closures::Place given_at_{1, 1};
  std::vector<std::string> outputs_;
};

}  // namespace assur::generator::audit::code
