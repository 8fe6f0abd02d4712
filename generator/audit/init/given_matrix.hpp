// Sizes and entries of the matrices and columns that a function returns.
#pragma once

#include "audit/init/function_arguments.hpp"

namespace assur::generator::audit::init {

/// A result of a function: a column, or a matrix.
struct Given {
  std::string name;  ///< of the variable that holds it; empty if it has none
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Words> entries;      ///< row by row; empty if unknown
  std::vector<std::string> names;  ///< variables that are its entries; may be empty
  std::vector<std::string> by;     ///< the symbols x of a matrix `f.jacobian(x)`
};

/// Reads variables and expressions of one function as matrices. The arguments of the constructor
/// must outlive it.
class MatrixReader {
 public:
  MatrixReader(Language language, const std::vector<Argument>& arguments,
               const Assignments& assignments)
      : language_(language), arguments_(arguments), set_(assignments) {}

  [[nodiscard]] std::optional<Given> variable(const std::string& name, int hops = 0) const;
  /// The value of an expression as far as it can be read: lists are matrices or columns, and
  /// anything without brackets around it is a number.
  [[nodiscard]] std::optional<Given> value(Words words, int hops = 0) const;
  /// `P.jacobian([a, b])`
  [[nodiscard]] std::optional<Given> jacobian(Words words) const;

 private:
  [[nodiscard]] std::optional<Given> cleared(Words words) const;
  [[nodiscard]] std::optional<Given> list_of(Words content) const;
  [[nodiscard]] std::optional<Given> list_within(Words words) const;

  Language language_;
  const std::vector<Argument>& arguments_;
  const Assignments& set_;
};

/// Where the size is known, a matrix of that size; without entries if their number differs.
[[nodiscard]] std::optional<Given> with_size(std::optional<Given> given,
                                             std::optional<MatrixSize> size);

}  // namespace assur::generator::audit::init
