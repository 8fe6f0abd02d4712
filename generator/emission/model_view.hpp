// Turns the parts of a model into the views that the templates show.
#pragma once

#include <kainjow/mustache.hpp>
#include <map>
#include <string>
#include <vector>

#include "elimination/eliminate.hpp"
#include "emission/model_functions.hpp"
#include "solution/structured_jacobian.hpp"

namespace assur::generator {

[[nodiscard]] std::string boolean(bool value);

template <typename Items, typename Text>
[[nodiscard]] std::string joined(const Items& items, const std::string& separator, Text text) {
  std::string result;
  for (const auto& item : items) {
    result += (result.empty() ? "" : separator) + text(item);
  }
  return result;
}

/// A text of a user's for a comment: on one line, without a backslash that would continue it.
[[nodiscard]] std::string comment_text(std::string text);

/// A template without the ends of lines that hold nothing but a tag. The library keeps these ends
/// where a section is hidden, which leaves a blank line.
[[nodiscard]] std::string without_tag_lines(const char* text);

/// A template filled in, with its lines broken at 100 columns.
[[nodiscard]] std::string rendered(const std::string& text, const kainjow::mustache::data& view);

/// The templates that others contain.
void show_partials(kainjow::mustache::data& view);

/// C++ spellings of the symbols that a model's programs read. Rates keep their own names: the
/// function's first lines take them out of the vectors.
class ModelSpelling {
 public:
  /// The inputs are those that the vectors of their rates hold.
  ModelSpelling(const std::deque<Variable>& unknowns, const std::deque<Variable>& dimensions,
                const std::deque<Variable>& inputs) {
    add(unknowns, "q");
    add(dimensions, "d");
    add(inputs, "u");
  }

  /// A symbol that is an entry of a parameter and is taken out of it, as rates are.
  void take_out(const GiNaC::symbol& symbol, const std::string& entry) {
    rates_[symbol.get_name()] = entry;
  }

  [[nodiscard]] std::string spell(const std::string& symbol) const {
    const auto found = members_.find(symbol);
    return found == members_.end() ? symbol : found->second;
  }
  /// `const Scalar omega_BCG = q_rate(0);`, or nothing for a symbol that is no entry.
  [[nodiscard]] std::string taken_out(const std::string& symbol) const {
    const auto found = rates_.find(symbol);
    return found == rates_.end() ? "" : "const Scalar " + symbol + " = " + found->second + ";";
  }

 private:
  void add(const std::deque<Variable>& variables, const std::string& argument);

  std::map<std::string, std::string> members_;
  std::map<std::string, std::string> rates_;
};

/// What is said of the unknowns, dimensions or inputs: `<kind>s` is the list of name, type and
/// meaning and, for unknowns, owner; `<kind>_names` the names, `<kind>_count` their number.
void show_variables(const std::deque<Variable>& variables, const std::string& kind,
                    kainjow::mustache::data& view, const std::vector<int>& owners = {});
/// The links with their joints and frames.
[[nodiscard]] kainjow::mustache::data link_list(const ClosureEquations& equations);
[[nodiscard]] kainjow::mustache::data line_list(const std::vector<std::string>& lines,
                                                const std::string& indentation);
/// Whether results that are zero, of outputs that are not cleared, are assigned or left out: the
/// numbers of a mechanism may make zero what the reader of a general model knows to be none.
enum class ZeroResults : unsigned char { left_out, assigned };

[[nodiscard]] kainjow::mustache::data function_view(const ModelFunction& function,
                                                    const Program& program,
                                                    const ModelSpelling& spelling,
                                                    ZeroResults zeros = ZeroResults::left_out);
/// The vector equations, and what the angles must satisfy beside them, a line each.
[[nodiscard]] std::vector<std::string> closure_lines(const ClosureEquations& equations);
/// How the closed form comes about, a line a step.
[[nodiscard]] std::vector<std::string> elimination_steps(const Elimination& elimination);

/// What the runtime reads of a rigid model: its pivots and its closed form.
void show_solution(const StructuredJacobian& structured, const ClosureEquations& equations,
                   const Elimination& elimination, kainjow::mustache::data& view);

}  // namespace assur::generator
