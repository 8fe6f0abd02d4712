// The values that a C++ function returns, or sets through its output parameters.
#pragma once

#include "audit/code/cpp_scope.hpp"

namespace assur::generator::audit::code {

/// Reads them from the variables of the scope, which must outlive this object.
class CppGivenValues {
 public:
  explicit CppGivenValues(CppScope& scope) : scope_(scope) {}

  /// A parameter through which the function may set a value.
  void add_output(const std::string& name) { outputs_.push_back(name); }
  /// The returned value: `{a, b}`, `Pair{a, b}`, `std::make_tuple(a, b)`, a variable, or one
  /// number. `result` is the declared return type.
  void give_returned(Tokens value, const Type& result);
  /// `*x = EXPR` for a parameter x, which may not be read afterwards.
  void set_pointed(Tokens statement);
  /// The values that the function has set through its parameters, in their order.
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
