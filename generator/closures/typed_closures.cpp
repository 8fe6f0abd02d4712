#include "closures/typed_closures.hpp"

#include <algorithm>
#include <array>
#include <assur/text/input_file.hpp>
#include <assur/text/suggestion.hpp>
#include <string_view>

#include "closures/closure_reader.hpp"

namespace assur::generator::closures {

namespace {

/// Statements that compare with the derivation, and add nothing to it.
constexpr std::array<std::string_view, 5> of_the_audit = {"printed", "scene", "group", "given",
                                                          "value"};
constexpr std::array<std::string_view, 3> shown = {"let", "loop", "closure"};

template <typename List>
bool contains(const List& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

TypedClosures read_typed_closures(const std::string& file) {
  ClosureReader reader(file);
  TypedClosures typed{file, "", {}, {}};
  for (const Statement& statement : parse_statements(text::read_input_file(file), file)) {
    PlacedText rest = statement.head;
    const PlacedText keyword = take_word(rest);
    if (keyword.text == "model") {
      throw AuditSyntaxError(file, keyword.place,
                             "closures are emitted as they are typed; the C++ of a model is "
                             "written by assur emit --group GROUP --model N");
    }
    if (contains(of_the_audit, keyword.text)) {
      continue;
    }
    if (!reader.read(statement)) {
      reader.fail(keyword.place,
                  "no statement '" + keyword.text + "'" +
                      text::suggestion_or_choice(keyword.text, ClosureReader::keywords()));
    }
    if (contains(shown, keyword.text)) {
      typed.lines.push_back(joined(statement).text);
    }
  }
  typed.source = reader.source();
  typed.system = std::move(reader.system());
  if (typed.system.closures().empty()) {
    throw text::InputError(file +
                           ": there is no closure to emit; type one with 'closure' or 'loop'");
  }
  const auto& symbols = typed.system.symbols();
  if (std::none_of(symbols.begin(), symbols.end(),
                   [](const AuditSymbol& symbol) { return symbol.unknown; })) {
    throw text::InputError(file + ": no symbol is unknown; name the unknowns with 'unknown'");
  }
  return typed;
}

}  // namespace assur::generator::closures
