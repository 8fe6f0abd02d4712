// Turns the printed numbers of a worked example into findings against values derived anew.
#pragma once

#include <assur/text/expression.hpp>
#include <map>

#include "audit/finding.hpp"

namespace assur::generator::audit {

/// A chain of numbers: inputs, and results printed with a formula each. A formula has two readings:
/// with the derived values of what it names, which is the truth, and with the printed ones, which
/// shows where a difference comes from.
class NumericExample {
 public:
  /// A value that is derived, not printed: of a scene, or of a group.
  void define(const std::string& name, double value);
  /// A value derived by a formula in derived values. Throws FormulaError.
  void define(const std::string& name, const closures::PlacedText& formula);
  /// An input, taken as printed and exact. Throws FormulaError.
  void give(const std::string& name, const closures::PlacedText& number);
  /// A printed result: agrees if it is the derived value within half a unit of its last digit.
  /// Throws FormulaError for what is no number.
  [[nodiscard]] Finding audit(const std::string& name, const closures::PlacedText& number,
                              const closures::PlacedText& formula);
  [[nodiscard]] bool is_known(const std::string& name) const { return values_.contains(name); }

 private:
  struct Value {
    double derived;
    double printed;
    double half_unit = 0;  ///< half a unit of the last printed digit; zero for what is exact
    bool is_printed = false;
  };
  enum class Reading : unsigned char { derived, printed };

  [[nodiscard]] text::Expression read_tree(const closures::PlacedText& formula) const;
  [[nodiscard]] static Value read_number(const closures::PlacedText& number);
  [[nodiscard]] double evaluate(const text::Expression& formula, Reading reading,
                                const std::map<std::string, double>& replaced = {}) const;
  [[nodiscard]] std::string explanation(const text::Expression& formula, const Value& result) const;
  [[nodiscard]] std::string needed_inputs(const text::Expression& formula, double result,
                                          const std::vector<std::string>& inputs) const;

  std::map<std::string, Value> values_;
};

}  // namespace assur::generator::audit
