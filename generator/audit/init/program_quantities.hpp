// Positions, rates and matrices that a program computes, and which are derivatives of which.
#pragma once

#include "audit/init/program_outline.hpp"

namespace assur::generator::audit::init {

/// A result of a function, by its index there.
struct Quantity {
  std::size_t function;
  std::size_t given;
};

class ProgramQuantities {
 public:
  /// Throws InputError for a program that would take too long to read or has too many results.
  /// `file` is its name in messages.
  ProgramQuantities(const std::string& code, Language language, const std::string& file);

  [[nodiscard]] const ProgramOutline& outline() const { return outline_; }
  [[nodiscard]] const std::vector<Quantity>& all() const { return all_; }
  [[nodiscard]] const ProgramFunction& function(const Quantity& quantity) const {
    return outline_.functions[quantity.function];
  }
  [[nodiscard]] const Given& given(const Quantity& quantity) const {
    return function(quantity).given[quantity.given];
  }
  /// The label of a quantity in the rows of an audit file.
  [[nodiscard]] std::string label(const Quantity& quantity) const;

  /// Whether some function takes the sine or cosine of the symbol.
  [[nodiscard]] bool is_angle(const std::string& symbol) const { return angles_.contains(symbol); }
  /// The angles among the symbols of a function.
  [[nodiscard]] std::vector<std::string> angles_of(const ProgramFunction& function) const;
  /// The angles or the elements of a list, whichever have the number of the columns.
  [[nodiscard]] std::vector<std::string> columns_by_count(const ProgramFunction& function,
                                                          std::size_t columns) const;
  /// The symbols of the derivative that the position does not have.
  [[nodiscard]] std::vector<std::string> more_symbols(const Quantity& position,
                                                      const Quantity& derived) const;
  /// Whether a function of the program calls the one of that name.
  [[nodiscard]] bool is_called(const std::string& name) const;

 private:
  Language language_;
  ProgramOutline outline_;
  std::vector<Quantity> all_;
  std::set<std::string> angles_;
};

/// A derivative and the position that it is the derivative of.
struct DerivativePair {
  Quantity position;
  Quantity derived;
  std::vector<std::string> by;      ///< parameters; empty for rates
  std::vector<std::string> moving;  ///< symbols whose rates the derivative takes
  int order = 1;                    ///< of the rate
  bool guessed = false;             ///< from numbers of columns or names only
};

/// By the values that the functions compute; where these do not decide, by names and numbers of
/// columns.
[[nodiscard]] std::vector<DerivativePair> derivative_pairs(const ProgramQuantities& quantities);

/// Quantities without a pair that no other function of the file uses: their closures are elsewhere.
[[nodiscard]] std::vector<Quantity> without_pair(const ProgramQuantities& quantities,
                                                 const std::vector<DerivativePair>& pairs);

/// Whether an entry can be computed.
[[nodiscard]] bool is_computable(const ProgramFunction& function, const Given& given);

/// The symbols by which the columns of a matrix are derivatives of the position, as far as most of
/// the entries confirm it; empty for a column that is not one.
[[nodiscard]] std::vector<std::string> derived_by(const ProgramFunction& of, const Given& position,
                                                  const ProgramFunction& derived,
                                                  const Given& matrix);

/// Whether half of the numbers of a result are, up to sign, the first or second time derivatives of
/// the position, where `rates` are the parameters for the rates of the moving symbols and then for
/// their second rates.
[[nodiscard]] bool follows_rates(const ProgramFunction& of, const Given& position,
                                 const ProgramFunction& derived, const Given& column,
                                 const std::vector<std::string>& moving,
                                 const std::vector<std::string>& rates);

}  // namespace assur::generator::audit::init
