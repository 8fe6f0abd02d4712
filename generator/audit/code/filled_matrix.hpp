// Turns what straight-line code assigns to a matrix into the matrix's entries.
#pragma once

#include "audit/code/local_values.hpp"

namespace assur::generator::audit::code {

/// One entry: empty text stands for zero.
struct CodeEntry {
  closures::PlacedText text;  ///< a formula; its columns are counted across line ends
  closures::LocalNames locals;
  std::string source;  ///< as it stands in the code
};

/// The matrix in the code that is audited: its name and size.
struct AuditedMatrix {
  std::string array;
  std::size_t rows;
  std::size_t columns;

  [[nodiscard]] std::string size_text() const {
    return std::to_string(rows) + " by " + std::to_string(columns);
  }
};

class FilledMatrix {
 public:
  FilledMatrix(const AuditedMatrix& matrix, const std::string& code)
      : matrix_(matrix), code_(code), entries_(matrix.rows * matrix.columns) {}

  [[nodiscard]] const AuditedMatrix& matrix() const { return matrix_; }
  /// Assigns one entry, with indices from 0; formulas may use it as `name` from then on. Throws
  /// CodeError outside the matrix.
  void assign(std::size_t row, std::size_t column, const CodeName& name, Tokens value,
              LocalValues& locals);
  /// Assigns all entries, row by row. Throws CodeError unless there are as many values.
  void assign_all(const std::vector<Tokens>& values, closures::Place place,
                  const LocalValues& locals);
  void clear() {
    entries_.assign(entries_.size(), {});
    undefined_.reset();
  }
  /// The matrix is declared at this place and has no values before they are assigned.
  void begin_undefined(closures::Place place) { undefined_ = place; }
  /// Throws CodeError where nothing has been assigned, and where an entry has no value at all.
  [[nodiscard]] std::vector<CodeEntry> entries();

 private:
  [[nodiscard]] CodeEntry entry(Tokens value, const LocalValues& locals) const;

  const AuditedMatrix& matrix_;
  const std::string& code_;
  std::vector<CodeEntry> entries_;
  std::optional<closures::Place> first_;      ///< where it is first filled
  std::optional<closures::Place> undefined_;  ///< where it is declared without values
};

}  // namespace assur::generator::audit::code
