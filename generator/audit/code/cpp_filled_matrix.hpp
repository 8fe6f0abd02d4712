// The matrix that C++ code declares, clears and fills, entry by entry or as a whole.
#pragma once

#include "audit/code/cpp_scope.hpp"

namespace assur::generator::audit::code {

/// The entries are stored in the variables of the scope, which must outlive this object.
class CppFilledMatrix {
 public:
  explicit CppFilledMatrix(CppScope& scope) : scope_(scope) {}

  /// A parameter, cleared by the caller.
  void take_parameter(const Declarator& declared);
  /// `J`, `J(2, 2)`, `J = Matrix::Zero()`, `J[2][2] = {}`.
  void declare(const Declarator& declared);
  /// `J(0, 0) = EXPR`, `J << EXPR, ...`, `J.setZero()`.
  void fill(Tokens statement);
  /// `Eigen::Matrix2d::Zero()` and the like.
  [[nodiscard]] bool is_zero(Tokens value) const;

  /// Whether it is a local variable of the function, which must then return it.
  [[nodiscard]] bool is_own() const { return own_; }
  [[nodiscard]] closures::Place declared_at() const { return declared_at_; }

 private:
  Variable& declare_variable(const Declarator& declared);
  void expect_shape(std::optional<std::size_t> rows, std::optional<std::size_t> columns,
                    const Token& at) const;
  void set_all(const std::vector<Tokens>& values, const Token& first);
  [[nodiscard]] bool clears(Tokens rest) const;

  CppScope& scope_;
  bool round_ = true;   ///< entries may be spelled J(0, 0)
  bool square_ = true;  ///< entries may be spelled J[0][0]
  bool own_ = false;
  closures::Place declared_at_{1, 1};
};

}  // namespace assur::generator::audit::code
