// The positions, rates and matrices that the functions of a program give, their values, and which
// of them are derivatives of which.
#pragma once

#include "audit/init/program_outline.hpp"

namespace assur::generator::audit::init {

/// One thing that a function gives, by its index there.
struct Quantity {
  std::size_t function;
  std::size_t given;
};

class ProgramQuantities {
 public:
  /// Throws InputError for a program that takes too long to read or gives too much. `file` is what
  /// messages call it.
  ProgramQuantities(const std::string& code, Language language, const std::string& file);

  [[nodiscard]] const ProgramOutline& outline() const { return outline_; }
  [[nodiscard]] const std::vector<Quantity>& all() const { return all_; }
  [[nodiscard]] const ProgramFunction& function(const Quantity& quantity) const {
    return outline_.functions[quantity.function];
  }
  [[nodiscard]] const Given& given(const Quantity& quantity) const {
    return function(quantity).given[quantity.given];
  }
  /// What the rows of an audit file call it.
  [[nodiscard]] std::string label(const Quantity& quantity) const;

  /// Whether some function takes the sine or cosine of the symbol.
  [[nodiscard]] bool is_angle(const std::string& symbol) const { return angles_.contains(symbol); }
  /// The angles among the symbols of a function.
  [[nodiscard]] std::vector<std::string> angles_of(const ProgramFunction& function) const;
  /// The angles or the elements of a list, whichever are as many as the columns.
  [[nodiscard]] std::vector<std::string> columns_by_count(const ProgramFunction& function,
                                                          std::size_t columns) const;
  /// The symbols of the derivative that the position does not take.
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
  std::vector<std::string> moving;  ///< whose rates the derivative takes
  int order = 1;                    ///< of the rate
  bool guessed = false;             ///< from numbers of names alone
};

/// By the values that the functions compute; where these say nothing, by names and numbers of
/// columns.
[[nodiscard]] std::vector<DerivativePair> derivative_pairs(const ProgramQuantities& quantities);

/// What no pair has, and no other function of the file calls: its closures are not in the file.
[[nodiscard]] std::vector<Quantity> without_pair(const ProgramQuantities& quantities,
                                                 const std::vector<DerivativePair>& pairs);

/// Whether an entry can be computed at all.
[[nodiscard]] bool is_computable(const ProgramFunction& function, const Given& given);

/// The symbols that the columns of a matrix are derivatives of the position by, as far as most of
/// the entries say so; empty where a column is none.
[[nodiscard]] std::vector<std::string> derived_by(const ProgramFunction& of, const Given& position,
                                                  const ProgramFunction& derived,
                                                  const Given& matrix);

/// Whether half of the numbers that a function gives are, up to their signs, the first or second
/// derivatives of the position by the time, where `rates` are its parameters for the rates of the
/// moving symbols and then for their second rates.
[[nodiscard]] bool follows_rates(const ProgramFunction& of, const Given& position,
                                 const ProgramFunction& derived, const Given& column,
                                 const std::vector<std::string>& moving,
                                 const std::vector<std::string>& rates);

}  // namespace assur::generator::audit::init
