// Audits the printed numbers of a worked example against derived values.
#pragma once

#include <assur/text/expression.hpp>
#include <map>

#include "audit/finding.hpp"

namespace assur::generator::audit {

/// A chain of numbers: inputs, and printed results with one formula each. A formula is evaluated
/// with the derived values of its names, which gives the right result, and with the printed ones,
/// which shows the source of a difference.
class NumericExample {
 public:
  /// A value derived from a scene or a group.
  void define(const std::string& name, double value);
  /// A value derived by a formula in derived values. Throws FormulaError.
  void define(const std::string& name, const closures::PlacedText& formula);
  /// An input, taken as printed and exact. Throws FormulaError.
  void give(const std::string& name, const closures::PlacedText& number);
  /// A printed result: agrees if it is the derived value within half a unit of its last digit.
  /// Throws FormulaError if `number` is not a number.
  [[nodiscard]] Finding audit(const std::string& name, const closures::PlacedText& number,
                              const closures::PlacedText& formula);
  [[nodiscard]] bool is_known(const std::string& name) const { return values_.contains(name); }

 private:
  struct Value {
    double derived;
    double printed;
    double half_unit = 0;  ///< half a unit of the last printed digit; zero for exact numbers
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
