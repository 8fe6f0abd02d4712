// Reads tokens of a paper as expressions in the quantities of its map.
#pragma once

#include "audit/latex/paper_map.hpp"

namespace assur::generator::audit::latex {

using closures::FormulaError;
using closures::Place;
using generator::latex::Meaning;

/// A quantity that the paper should define, and that is not defined yet.
struct NotDefined : FormulaError {
  NotDefined(const std::string& what, Place at, std::string name_in)
      : FormulaError(what, at), name(std::move(name_in)) {}
  std::string name;  ///< its name in formulas
};

/// The formulas of a paper and their definitions.
class PaperFormulas {
 public:
  PaperFormulas(const std::string& paper, PaperMap& map)
      : paper_(paper), map_(map), reading_(map.reading()), points_(map.reader().system()) {}
  PaperFormulas(const PaperFormulas&) = delete;
  PaperFormulas& operator=(const PaperFormulas&) = delete;

  [[nodiscard]] const PaperMap& map() const { return map_; }
  [[nodiscard]] closures::ClosurePoints& points() { return points_; }
  [[nodiscard]] closures::ClosureSystem& system() { return points_.system(); }
  [[nodiscard]] bool blanks_are_zero() const { return reading_.blanks_are_zero; }

  /// The expression of tokens; `place` is where a missing formula should stand. Throws
  /// FormulaError, and NotDefined for the first quantity that the paper should define and does not.
  [[nodiscard]] GiNaC::ex expression(const Tokens& tokens, Place place);
  /// The tokens as written in the file, on one line.
  [[nodiscard]] std::string source(const Tokens& tokens) const;

 private:
  const std::string& paper_;
  PaperMap& map_;
  generator::latex::Reading reading_;
  closures::ClosurePoints points_;
};

}  // namespace assur::generator::audit::latex
