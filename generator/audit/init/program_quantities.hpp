// The positions, rates and matrices that the functions of a program give.
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

}  // namespace assur::generator::audit::init
