#include "closures/closure_reader.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/expression.hpp>
#include <assur/text/suggestion.hpp>

#include "closures/read_formula.hpp"
#include "equations/closure.hpp"
#include "structure/kind.hpp"

namespace assur::generator::closures {

namespace {

const structure::Model& model_that_has(const std::string& text) {
  for (const structure::Group& group : structure::known_groups()) {
    if (const std::optional<structure::Kind> kind = structure::parse_kind(group, text)) {
      return structure::model_of(group, *kind);
    }
  }
  throw text::InputError("no group has a kind '" + text + "'; a tetrad's is spelled like RRP-RRR");
}

/// Declares the variables of the kind's model under their own names, the unknowns as unknown and
/// the inputs as moving, and its scalar closures as f1, f2, ... Throws InputError if no group has
/// the kind.
void declare_model(const std::string& kind, ClosureSystem& system) {
  const equations::ClosureEquations equations = equations::closure_equations(model_that_has(kind));
  GiNaC::exmap in_angles;
  for (const auto* list : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      if (system.is_known(variable.name)) {
        throw text::InputError("the model's '" + variable.name + "' is declared already");
      }
      AuditSymbol& symbol = system.declare(variable.name, variable.is_angle());
      symbol.unknown = list == &equations.unknowns;
      symbol.moving = list == &equations.inputs;
      if (variable.is_angle()) {
        in_angles[variable.cosine] = GiNaC::cos(symbol.symbol);
        in_angles[variable.sine] = GiNaC::sin(symbol.symbol);
      } else {
        in_angles[variable.value] = symbol.symbol;
      }
    }
  }
  int number = 0;
  for (const GiNaC::ex& residual : equations.residuals) {
    system.close("f" + std::to_string(++number),
                 equations.vocabulary.expand(residual).subs(in_angles));
  }
}

}  // namespace

struct ClosureReader::Keyword {
  std::string word;
  void (ClosureReader::*read)(const PlacedText&);
};

const std::vector<ClosureReader::Keyword>& ClosureReader::readers() {
  static const std::vector<Keyword> list = {
      {"source", &ClosureReader::read_source},     {"model", &ClosureReader::read_model},
      {"angle", &ClosureReader::read_angles},      {"length", &ClosureReader::read_lengths},
      {"unknown", &ClosureReader::read_unknowns},  {"moving", &ClosureReader::read_moving},
      {"constant", &ClosureReader::read_constant}, {"let", &ClosureReader::read_abbreviation},
      {"loop", &ClosureReader::read_loop},         {"closure", &ClosureReader::read_closure}};
  return list;
}

std::vector<std::string> ClosureReader::keywords() {
  std::vector<std::string> words;
  for (const Keyword& keyword : readers()) {
    words.push_back(keyword.word);
  }
  return words;
}

bool ClosureReader::read(const Statement& statement) {
  statement_ = statement;
  PlacedText rest = joined(statement);
  const PlacedText first = take_word(rest);
  const auto found = std::find_if(readers().begin(), readers().end(), [&](const Keyword& keyword) {
    return keyword.word == first.text;
  });
  if (found == readers().end()) {
    return false;
  }
  try {
    (this->*found->read)(rest);
  } catch (const FormulaError& error) {
    fail(error.place, error.what());
  }
  return true;
}

void ClosureReader::fail(Place joined, const std::string& what) const {
  throw AuditSyntaxError(file_, place_in_file(joined), what);
}

void ClosureReader::expect_new(const PlacedText& name) const {
  if (name.empty()) {
    fail(name.place, "a name is missing");
  }
  if (!text::is_identifier(name.text)) {
    fail(name.place, "'" + name.text +
                         "' cannot be a name; use letters, digits and underscores, but no digit "
                         "first");
  }
  if (text::is_reserved_name(name.text)) {
    fail(name.place, "'" + name.text + "' cannot be a name: formulas give it a meaning");
  }
  if (system_.is_known(name.text) || reserved_.contains(name.text)) {
    fail(name.place, "'" + name.text + "' is declared already");
  }
}

void ClosureReader::expect_new_in_formulas(const PlacedText& name) const {
  const auto functions = formula_functions();
  if (std::any_of(functions.begin(), functions.end(), [&](const auto& function) {
        return function.name == name.text && !function.may_be_name;
      })) {
    fail(name.place, "'" + name.text + "' cannot be a name: formulas have a function of that name");
  }
  expect_new(name);
}

std::vector<std::string> ClosureReader::known_names(const PlacedText& list, bool symbols_only) {
  std::vector<std::string> names;
  for (const PlacedText& name : words(list)) {
    const bool known =
        symbols_only ? system_.symbol_named(name.text) != nullptr : system_.is_known(name.text);
    if (!known && system_.is_known(name.text)) {
      fail(name.place, "'" + name.text + "' is not the name of a length or an angle");
    }
    if (!known) {
      fail(name.place, "no symbol named '" + name.text + "'" +
                           text::suggestion_or_choice(name.text, system_.names()));
    }
    names.push_back(name.text);
  }
  if (names.empty()) {
    fail(list.place, "the names are missing");
  }
  return names;
}

void ClosureReader::read_model(const PlacedText& kind) {
  if (kind.empty()) {
    fail(kind.place, "a kind is missing");
  }
  try {
    declare_model(kind.text, system_);
  } catch (const text::InputError& error) {
    fail(kind.place, error.what());
  }
}

void ClosureReader::read_symbols(const PlacedText& rest, bool angles) {
  const auto [names, meaning] = cut(rest, ':');
  if (names.empty()) {
    fail(names.place, "the names are missing");
  }
  for (const PlacedText& name : words(names)) {
    expect_new_in_formulas(name);
    system_.declare(name.text, angles, meaning.text);
  }
}

void ClosureReader::read_unknowns(const PlacedText& rest) {
  for (const std::string& name : known_names(rest, true)) {
    system_.symbol_named(name)->unknown = true;
  }
}

void ClosureReader::read_moving(const PlacedText& rest) {
  for (const std::string& name : known_names(rest, true)) {
    system_.symbol_named(name)->moving = true;
  }
}

/// `constant rate(th)`
void ClosureReader::read_constant(const PlacedText& rest) {
  if (rest.empty()) {
    fail(rest.place, "expected 'constant rate(NAME) ...'");
  }
  for (const PlacedText& word : words(rest)) {
    const std::string& text = word.text;
    if (!text.starts_with("rate(") || !text.ends_with(")")) {
      fail(word.place, "expected 'constant rate(NAME) ...', found '" + text + "'");
    }
    const PlacedText name = trimmed({text.substr(5, text.size() - 6), word.at(6)});
    AuditSymbol& symbol = *system_.symbol_named(known_names(name, true)[0]);
    if (!symbol.moving) {
      fail(name.place,
           symbol.unknown
               ? "'" + symbol.name + "' is an unknown, whose rate the closures determine"
               : "'" + symbol.name + "' does not move; declare 'moving " + symbol.name + "' first");
    }
    symbol.steady = true;
  }
}

void ClosureReader::read_abbreviation(const PlacedText& rest) {
  const auto [name, definition] = cut(rest, '=');
  expect_new_in_formulas(name);
  system_.abbreviate(name.text, read_formula(definition, system_));
}

void ClosureReader::read_loop(const PlacedText& rest) {
  const auto [names, vectors] = cut(rest, '=');
  const std::vector<PlacedText> both = words(names);
  if (both.size() != 2) {
    fail(names.place, "expected 'loop X_CLOSURE Y_CLOSURE = VECTOR'");
  }
  expect_new_in_formulas(both[0]);
  expect_new_in_formulas(both[1]);
  const equations::Vector2 sum = read_vector(vectors, system_);
  system_.close(both[0].text, sum.x);
  system_.close(both[1].text, sum.y);
}

void ClosureReader::read_closure(const PlacedText& rest) {
  const std::vector<PlacedText> parts = split(rest, '=');
  if (parts.size() < 2 || parts.size() > 3) {
    fail(rest.place, "expected 'closure NAME = EXPRESSION [= EXPRESSION]'");
  }
  expect_new_in_formulas(parts[0]);
  const GiNaC::ex left = read_formula(parts[1], system_);
  system_.close(parts[0].text, parts.size() == 3 ? left - read_formula(parts[2], system_) : left);
}

}  // namespace assur::generator::closures
