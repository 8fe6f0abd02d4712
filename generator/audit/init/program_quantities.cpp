#include "audit/init/program_quantities.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/expression.hpp>
#include <assur/text/names.hpp>

namespace assur::generator::audit::init {

namespace {

/// More quantities than this do not fit one draft.
constexpr std::size_t most_quantities = 60;
constexpr std::size_t most_words = 200'000;
constexpr std::size_t most_nested = 200;

/// Throws InputError for a program that would take too long to read.
void expect_readable(Words words, const std::string& file) {
  std::size_t depth = 0;
  std::size_t deepest = 0;
  for (const Word& word : words) {
    depth += word.is("(") || word.is("[") || word.is("{") ? 1 : 0;
    depth -= depth > 0 && (word.is(")") || word.is("]") || word.is("}")) ? 1 : 0;
    deepest = std::max(depth, deepest);
  }
  if (words.size() > most_words || deepest > most_nested) {
    throw text::InputError(file + ": this is more than --init reads (" +
                           std::to_string(most_words) + " words, " + std::to_string(most_nested) +
                           " brackets in one another); put what is to be audited into a file of "
                           "its own");
  }
}

/// Whether it has results and symbols, all with names that formulas can have.
bool can_be_audited(const ProgramFunction& function) {
  return !function.given.empty() && !function.symbols().empty() &&
         std::all_of(function.arguments.begin(), function.arguments.end(),
                     [](const Argument& each) {
                       return each.name.empty() || text::is_identifier(each.name);
                     }) &&
         text::is_identifier("_" + text::joined(function.symbols(), "_"));
}

}  // namespace

ProgramQuantities::ProgramQuantities(const std::string& code, Language language,
                                     const std::string& file)
    : language_(language) {
  expect_readable(program_words(code, language), file);
  outline_ = program_outline(code, language);
  std::erase_if(outline_.functions,
                [](const ProgramFunction& function) { return !can_be_audited(function); });
  for (std::size_t at = 0; at < outline_.functions.size(); ++at) {
    const ProgramFunction& function = outline_.functions[at];
    angles_.insert(function.angles.begin(), function.angles.end());
    for (std::size_t one = 0; one < function.given.size(); ++one) {
      all_.push_back({at, one});
    }
  }
  if (all_.size() > most_quantities) {
    throw text::InputError(file + ": this has more than " + std::to_string(most_quantities) +
                           " functions that can be audited; put those of interest into a file "
                           "of their own");
  }
}

std::string ProgramQuantities::label(const Quantity& quantity) const {
  const std::string& name = function(quantity).name;
  return name.empty() || function(quantity).given.size() > 1
             ? given(quantity).name.empty() ? name : given(quantity).name
             : name;
}

std::vector<std::string> ProgramQuantities::angles_of(const ProgramFunction& function) const {
  std::vector<std::string> list = function.symbols();
  std::erase_if(list, [&](const std::string& name) { return !is_angle(name); });
  return list;
}

std::vector<std::string> ProgramQuantities::columns_by_count(const ProgramFunction& function,
                                                             std::size_t columns) const {
  std::vector<std::vector<std::string>> candidates;
  for (const Argument& argument : function.arguments) {
    if (argument.kind == Argument::Kind::list) {
      candidates.push_back(argument.parts);
    }
  }
  candidates.push_back(angles_of(function));
  const auto found = std::find_if(candidates.begin(), candidates.end(),
                                  [&](const auto& list) { return list.size() == columns; });
  return found == candidates.end() ? std::vector<std::string>() : *found;
}

std::vector<std::string> ProgramQuantities::more_symbols(const Quantity& position,
                                                         const Quantity& derived) const {
  std::vector<std::string> list = function(derived).symbols();
  const std::vector<std::string> known = function(position).symbols();
  std::erase_if(list, [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  });
  return list;
}

bool ProgramQuantities::is_called(const std::string& name) const {
  std::size_t mentions = 0;
  for (std::size_t at = 0; at + 1 < outline_.words.size(); ++at) {
    const bool is_mention = outline_.words[at].is(name.c_str()) && outline_.words[at + 1].is("(");
    const bool is_declaration =
        is_mention && at > 0 &&
        (outline_.words[at - 1].is("def") || outline_.words[at - 1].is("function"));
    mentions += is_mention && !is_declaration ? 1 : 0;
  }
  const bool declared_after_equals = language_ == Language::matlab;
  return mentions > (is_c_or_cpp(language_) || declared_after_equals ? 1U : 0U);
}

}  // namespace assur::generator::audit::init
