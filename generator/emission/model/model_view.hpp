// Fills the views of the templates with the parts of a model.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "elimination/eliminate.hpp"
#include "emission/cpp/page.hpp"
#include "emission/model/model_functions.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::emission::model {

/// C++ spellings of the symbols that a model's programs read. Rates keep their own names: the first
/// lines of a function read them from the vectors.
class ModelSpelling {
 public:
  /// The inputs must be in the order of the vectors of their rates.
  ModelSpelling(const std::deque<equations::Variable>& unknowns,
                const std::deque<equations::Variable>& dimensions,
                const std::deque<equations::Variable>& inputs) {
    add(unknowns, "q");
    add(dimensions, "d");
    add(inputs, "u");
  }

  /// What a symbol stands for: the number at a place, or its absolute value.
  struct Source {
    program::Place place;
    bool is_size = false;
  };

  /// Declares that a symbol is read from an entry of a parameter, as rates are.
  void take_out(const GiNaC::symbol& symbol, const program::Place& entry) {
    rates_[symbol.get_name()] = entry;
  }

  /// Declares a name that is a member of a variable, `g.t01`.
  void put_in(const std::string& name, const program::Place& member) { members_[name] = {member}; }

  [[nodiscard]] std::string spell(const std::string& symbol) const;
  /// Where a symbol that is not taken out is found; none for a local variable.
  [[nodiscard]] std::optional<Source> source(const std::string& symbol) const {
    const auto found = members_.find(symbol);
    return found == members_.end() ? std::nullopt : std::optional(found->second);
  }
  /// The entry from which a symbol is read, such as `q_rate(0)`, if it is taken out.
  [[nodiscard]] std::optional<program::Place> taken_out(const std::string& symbol) const {
    const auto found = rates_.find(symbol);
    return found == rates_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  void add(const std::deque<equations::Variable>& variables, const std::string& argument);

  std::map<std::string, Source> members_;
  std::map<std::string, program::Place> rates_;
};

/// Shows the unknowns, dimensions or inputs: `<kind>s` is the list of name, type and
/// meaning and, for unknowns, owner; `<kind>_names` the names, `<kind>_count` their number.
void show_variables(const std::deque<equations::Variable>& variables, const std::string& kind,
                    cpp::View& view, const std::vector<equations::Owner>& owners = {});
/// The links with their joints and frames.
[[nodiscard]] cpp::View::List link_list(const equations::ClosureEquations& equations);
/// Whether zero results of outputs that are not cleared are assigned or left out. Which results of
/// a general model are zero is known beforehand; the numbers of a mechanism may make more zero.
enum class ZeroResults : unsigned char { left_out, assigned };

/// Statements before all others, and the parameters that they read.
struct FirstStatements {
  std::vector<std::string> lines;
  std::set<std::string> reads;
};

[[nodiscard]] cpp::View function_view(const ModelFunction& function,
                                      const program::Program& program,
                                      const ModelSpelling& spelling,
                                      ZeroResults zeros = ZeroResults::left_out,
                                      const FirstStatements& first = {});
/// Whether an output has zero entries; then it is cleared before the others are assigned.
[[nodiscard]] bool is_cleared(const ModelFunction& function, const Parameter& output);
/// The name of a function in its header's list, and its number of operations.
void show_operations(const std::string& name, const program::OperationCount& count,
                     cpp::View& view);
/// The vector equations, and the further conditions on the angles, one line each.
[[nodiscard]] std::vector<std::string> closure_lines(const equations::ClosureEquations& equations);
/// The steps of the elimination, one line each.
[[nodiscard]] std::vector<std::string> elimination_steps(
    const elimination::Elimination& elimination);

/// Shows the values that the runtime reads from a rigid model: its pivots and its closed form.
void show_solution(const pivoting::StructuredJacobian& structured,
                   const equations::ClosureEquations& equations,
                   const elimination::Elimination& elimination, cpp::View& view);

}  // namespace assur::generator::emission::model
