#include "audit/run_statement.hpp"

#include <assur/text/suggestion.hpp>
#include <charconv>
#include <functional>
#include <map>

#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

using closures::FormulaError;
using closures::PlacedText;
using running::Language;

constexpr std::size_t most_points = 400;
constexpr double most_rounding = 0.01;

/// The number that the whole text spells; `expected` describes the allowed numbers in a message.
template <typename Number>
Number number(const PlacedText& text, Number least, Number most, const std::string& expected) {
  Number value = 0;
  const char* const end = text.text.data() + text.text.size();
  const auto [last, error] = std::from_chars(text.text.data(), end, value);
  if (error != std::errc() || last != end || !(value >= least && value <= most)) {
    throw FormulaError("expected " + expected + ", found '" + text.text + "'", text.place);
  }
  return value;
}

const std::map<std::string, Language>& languages() {
  static const std::map<std::string, Language> list = {{"c++", Language::cpp},
                                                       {"c", Language::c},
                                                       {"python", Language::python},
                                                       {"octave", Language::octave},
                                                       {"javascript", Language::javascript}};
  return list;
}

Language language_named(const PlacedText& name) {
  const auto found = languages().find(name.text);
  if (found == languages().end()) {
    throw FormulaError("expected c++, c, python, octave or javascript", name.place);
  }
  return found->second;
}

Language language_of(const std::filesystem::path& file, const PlacedText& at) {
  static const std::map<std::string, Language> endings = {
      {".cpp", Language::cpp},        {".cc", Language::cpp},        {".cxx", Language::cpp},
      {".hpp", Language::cpp},        {".h", Language::cpp},         {".c", Language::c},
      {".py", Language::python},      {".m", Language::octave},      {".js", Language::javascript},
      {".mjs", Language::javascript}, {".cjs", Language::javascript}};
  const auto found = endings.find(file.extension().string());
  if (found == endings.end()) {
    throw FormulaError("its language is not known; add a row such as 'language c++'", at.place);
  }
  return found->second;
}

}  // namespace

RunStatement read_run_statement(const std::filesystem::path& directory, const PlacedText& file,
                                const std::vector<PlacedText>& rows) {
  RunStatement run;
  running::UserProgram& program = run.program;
  bool language_said = false;
  const std::map<std::string, std::function<void(const PlacedText&)>> readers = {
      {"before", [&](const PlacedText& text) { program.before.push_back(text.text); }},
      {"result", [&](const PlacedText& text) { run.result = text; }},
      {"position", [&](const PlacedText& text) { run.position = text; }},
      {"entry", [&](const PlacedText& text) { program.entry = text.text; }},
      {"flags",
       [&](const PlacedText& text) {
         for (const PlacedText& word : closures::words(text)) {
           program.flags.push_back(word.text);
         }
       }},
      {"compiler", [&](const PlacedText& text) { program.tool = text.text; }},
      {"interpreter", [&](const PlacedText& text) { program.tool = text.text; }},
      {"language",
       [&](const PlacedText& text) {
         program.language = language_named(text);
         language_said = true;
       }},
      {"where", [&](const PlacedText& text) { run.where.push_back(text); }},
      {"points",
       [&](const PlacedText& text) {
         run.points = number(text, fewest_points, most_points,
                             "a whole number from " + std::to_string(fewest_points) + " to " +
                                 std::to_string(most_points));
       }},
      {"rounding", [&](const PlacedText& text) {
         run.rounding = number(text, 0.0, most_rounding, "a number from 0 to 0.01");
       }}};
  for (const PlacedText& row : rows) {
    PlacedText rest = row;
    const PlacedText key = closures::take_word(rest);
    const auto reader = readers.find(key.text);
    if (reader == readers.end()) {
      std::vector<std::string> known;
      for (const auto& [name, function] : readers) {
        known.push_back(name);
      }
      throw FormulaError("no row '" + key.text + "'" + text::suggestion_or_choice(key.text, known),
                         key.place);
    }
    if (rest.empty()) {
      throw FormulaError("a value is missing after '" + key.text + "'", key.place);
    }
    reader->second(rest);
  }
  std::error_code missing;
  program.file = std::filesystem::canonical(directory / file.text, missing);
  if (missing || !std::filesystem::is_regular_file(program.file)) {
    throw FormulaError(
        (directory / file.text).string() + ": cannot be read (does it exist, and is it a file?)",
        file.place);
  }
  if (run.result.empty()) {
    throw FormulaError("a row is missing: 'result FUNCTION(QUANTITY, ...)'", file.place);
  }
  program.result = run.result.text;
  program.directory = directory.empty() ? std::filesystem::path(".") : directory;
  if (!language_said) {
    program.language = language_of(program.file, file);
  }
  return run;
}

}  // namespace assur::generator::audit
