// The values that code has given to a matrix, or returns, as entries that can be compared.
#pragma once

#include "audit/code/variables.hpp"

namespace assur::generator::audit::code {

/// One entry: empty text stands for zero.
struct CodeEntry {
  closures::PlacedText text;  ///< as it stands in the code, which may be several lines
  Cell cell;

  /// Throws FormulaError where it is no formula.
  [[nodiscard]] GiNaC::ex value() const;
};

/// What is audited in the code: a matrix, or what a function gives, and its size.
struct AuditedMatrix {
  std::string array;
  std::size_t rows;
  std::size_t columns;
  bool is_c = false;  ///< the code is C, where `auto` does not mean the type of the value

  [[nodiscard]] std::string size_text() const {
    return std::to_string(rows) + " by " + std::to_string(columns);
  }
};

/// Turns expressions of one code into cells with their sources.
class CodeReader {
 public:
  CodeReader(const std::string& code, const AuditedMatrix& audited, closures::ClosureSystem& system,
             Language language)
      : code_(code), audited_(audited), variables_(system, language) {}

  /// A cell that holds the value of an expression, or why it cannot be read. Throws CodeError for
  /// what may do more than give a value.
  [[nodiscard]] Cell cell_of(Tokens value, std::vector<Spelled>* used = nullptr);
  /// Sets an entry of the matrix, with indices from 0. Throws CodeError outside the matrix.
  void set_entry(std::size_t row, std::size_t column, const Spelled& entry, Cell cell);
  /// The matrix's entries. Throws CodeError where one has no value at all.
  [[nodiscard]] std::vector<CodeEntry> entries_of(const Variable& matrix, std::size_t first_index);
  /// One entry for each cell. Throws CodeError unless there are as many as the audit asks for.
  [[nodiscard]] std::vector<CodeEntry> entries_of(const std::vector<Cell>& cells,
                                                  closures::Place place) const;
  /// The whole matrix is given values at a place.
  void note_filled(closures::Place place) { filled_ = place; }

 protected:
  const std::string& code_;
  const AuditedMatrix& audited_;
  Variables variables_;
  TypeNames types_;
  std::optional<closures::Place> filled_;  ///< where the matrix is first filled
};

}  // namespace assur::generator::audit::code
