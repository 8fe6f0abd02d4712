// The entries that code assigns to a matrix, or returns, in a form that can be compared.
#pragma once

#include "audit/code/variables.hpp"

namespace assur::generator::audit::code {

/// One entry; empty text means zero.
struct CodeEntry {
  closures::PlacedText text;  ///< as written in the code, possibly on several lines
  Cell cell;

  /// Throws FormulaError if the text is not a formula.
  [[nodiscard]] GiNaC::ex value() const;
};

/// The audited quantity of the code, a matrix or the result of a function, and its size.
struct AuditedMatrix {
  std::string array;
  std::size_t rows;
  std::size_t columns;
  bool is_c = false;  ///< the code is C, where `auto` does not mean the type of the value

  [[nodiscard]] std::string size_text() const {
    return std::to_string(rows) + " by " + std::to_string(columns);
  }
};

/// Reads expressions of one source into cells with their texts.
class CodeReader {
 public:
  CodeReader(const std::string& code, const AuditedMatrix& audited, closures::ClosureSystem& system,
             Language language)
      : code_(code), audited_(audited), variables_(system, language) {}

  /// A cell with the value of an expression, or with the reason why it cannot be read. Throws
  /// CodeError for an expression that may have side effects.
  [[nodiscard]] Cell cell_of(Tokens value, std::vector<Spelled>* used = nullptr);
  /// Sets an entry of the matrix, with indices from 0. Throws CodeError outside the matrix.
  void set_entry(std::size_t row, std::size_t column, const Spelled& entry, Cell cell);
  /// The matrix's entries. Throws CodeError where an entry was never set.
  [[nodiscard]] std::vector<CodeEntry> entries_of(const Variable& matrix, std::size_t first_index);
  /// One entry for each cell. Throws CodeError unless their number is the audited one.
  [[nodiscard]] std::vector<CodeEntry> entries_of(const std::vector<Cell>& cells,
                                                  closures::Place place) const;
  /// Notes the place where the whole matrix is assigned.
  void note_filled(closures::Place place) { filled_ = place; }

 protected:
  const std::string& code_;
  const AuditedMatrix& audited_;
  Variables variables_;
  TypeNames types_;
  std::optional<closures::Place> filled_;  ///< where the matrix is first filled
};

}  // namespace assur::generator::audit::code
