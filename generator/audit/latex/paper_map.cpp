#include "audit/latex/paper_map.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/suggestion.hpp>
#include <filesystem>

#include "latex/rows.hpp"

namespace assur::generator::audit::latex {

namespace {

using closures::PlacedText;

/// `1..13` as the numbers from 1 to 13; any other word as it is. `f1..4` as f1, f2, f3, f4.
std::vector<std::string> spread(const std::string& word) {
  const std::size_t dots = word.find("..");
  if (dots == std::string::npos) {
    return {word};
  }
  std::size_t from = dots;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  while (from > 0 && is_digit(word[from - 1])) {
    --from;
  }
  const std::string first = word.substr(from, dots - from);
  const std::string last = word.substr(dots + 2);
  const bool good = !first.empty() && first.size() < 4 && !last.empty() && last.size() < 4 &&
                    std::all_of(last.begin(), last.end(), is_digit);
  if (!good || std::stoi(first) > std::stoi(last)) {
    return {word};
  }
  std::vector<std::string> list;
  for (int number = std::stoi(first); number <= std::stoi(last); ++number) {
    list.push_back(word.substr(0, from) + std::to_string(number));
  }
  return list;
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// The part of a text behind a word that it begins with.
std::optional<PlacedText> behind(const PlacedText& text, const std::string& word) {
  PlacedText rest = text;
  if (closures::take_word(rest).text != word) {
    return std::nullopt;
  }
  return rest;
}

const std::vector<std::string> own_keywords = {"closures", "display",  "index", "sum",
                                               "skip",     "brackets", "blanks"};

}  // namespace

PaperMap::PaperMap(const std::string& text, const std::string& file)
    : file_(file),
      reader_(file),
      notations_([this](const std::string& name) { return system().is_known(name); }) {
  for (const closures::Statement& statement : closures::parse_statements(text, file)) {
    try {
      read(statement);
    } catch (const closures::FormulaError& error) {
      fail(error.place, error.what());
    }
  }
}

void PaperMap::fail(closures::Place place, const std::string& what) const {
  throw closures::AuditSyntaxError(file_, place, what);
}

void PaperMap::read(const closures::Statement& statement) {
  PlacedText rest = closures::joined(statement);
  const PlacedText line = rest;
  const PlacedText keyword = closures::take_word(rest);
  // A quantity may have the name of a keyword: `s = s`, `index = i`.
  const bool notation = rest.text.starts_with("=");
  if (!notation && contains(own_keywords, keyword.text)) {
    if (keyword.text == "closures") {
      read_closures(rest);
    } else if (keyword.text == "display") {
      read_display(rest);
    } else if (keyword.text == "index") {
      read_index(rest, indices_);
    } else if (keyword.text == "sum") {
      read_index(behind(rest, "over").value_or(rest), summed_);
    } else if (keyword.text == "skip") {
      read_skip(rest);
    } else if (line.text == "brackets multiply") {
      brackets_multiply_ = true;
    } else if (line.text == "blanks are zero") {
      blanks_are_zero_ = true;
    } else {
      fail(line.place, "expected 'brackets multiply' or 'blanks are zero'");
    }
    return;
  }
  if (!notation && reader_.read(statement)) {
    return;
  }
  read_notation(line);
}

void PaperMap::read_closures(const PlacedText& file) {
  static const std::vector<std::string> of_the_audit = {"printed", "scene", "group", "given",
                                                        "value"};
  const std::string path = (std::filesystem::path(file_).parent_path() / file.text).string();
  std::string text;
  try {
    text = text::read_input_file(path);
  } catch (const text::InputError& error) {
    fail(file.place, error.what());
  }
  for (const closures::Statement& statement : closures::parse_statements(text, path)) {
    PlacedText rest = statement.head;
    const PlacedText keyword = closures::take_word(rest);
    if (!contains(of_the_audit, keyword.text) && !reader_.read(statement)) {
      throw closures::AuditSyntaxError(path, keyword.place, "no statement '" + keyword.text + "'");
    }
  }
}

/// `\numbered{EQUATION}{NUMBER}`
void PaperMap::read_display(const PlacedText& rest) {
  const Tokens tokens = generator::latex::tokens_of(rest.text, file_);
  if (tokens.empty() || !tokens[0].is_command()) {
    fail(rest.place, "expected display \\COMMAND{EQUATION}{NUMBER}");
  }
  DisplayCommand command{0, 0, 0};
  for (std::size_t at = 1; at < tokens.size();) {
    const std::string argument =
        generator::latex::letters_of(generator::latex::take_argument(tokens, at));
    ++command.arguments;
    if (argument == "EQUATION") {
      command.equation = command.arguments;
    } else if (argument == "NUMBER") {
      command.number = command.arguments;
    }
  }
  if (command.equation == 0) {
    fail(rest.place, "expected display \\COMMAND{EQUATION}{NUMBER}");
  }
  commands_[tokens[0].text] = command;
}

void PaperMap::read_index(const PlacedText& rest,
                          std::map<std::string, std::vector<std::string>>& list) {
  const auto [name, range] = closures::cut(rest, '=');
  std::vector<std::string> values;
  for (const PlacedText& word : closures::words(range)) {
    const std::vector<std::string> some = spread(word.text);
    values.insert(values.end(), some.begin(), some.end());
  }
  if (name.text.size() != 1 || values.empty()) {
    fail(rest.place, "expected an index and its values, such as j = 1..4");
  }
  list[name.text] = values;
}

void PaperMap::read_skip(const PlacedText& rest) {
  if (const std::optional<PlacedText> sections = behind(rest, "sections")) {
    for (const PlacedText& title : closures::split(*sections, ',')) {
      skipped_sections_.insert(title.text);
    }
    return;
  }
  for (const PlacedText& label : closures::words(rest)) {
    skipped_.emplace(label.text, label.place);
  }
}

void PaperMap::expect_skipped(const std::set<std::string>& labels) const {
  for (const auto& [label, place] : skipped_) {
    if (!labels.contains(label)) {
      fail(place, "the paper has no equation " + label + " that could be skipped");
    }
  }
}

void PaperMap::read_notation(const PlacedText& line) {
  const auto [notation, meaning] = closures::cut(line, '=');
  if (meaning.empty() || notation.empty()) {
    fail(line.place, "expected NOTATION = QUANTITY, or a statement of a map" +
                         text::suggestion(line.text, own_keywords));
  }
  const Tokens tokens = generator::latex::tokens_of(notation.text, file_);
  if (meaning.text == "as printed") {
    notations_.add(tokens, "");
    return;
  }
  if (const std::optional<PlacedText> matrix = behind(meaning, "matrix")) {
    Matrix added{generator::latex::symbols_of(tokens), "", ""};
    if (matrix->text != "by its titles") {
      const std::size_t by = matrix->text.find(" by ");
      if (!matrix->text.starts_with("of ") || by == std::string::npos) {
        fail(meaning.place, "expected matrix of ROWS by COLUMNS, or matrix by its titles");
      }
      added.rows = matrix->text.substr(3, by - 3);
      added.columns = matrix->text.substr(by + 4);
    }
    matrices_.push_back(std::move(added));
    return;
  }
  try {
    static_cast<void>(
        text::parse_expression(generator::latex::filled(meaning.text, {"1", "1", "1", "1"}),
                               closures::formula_functions()));
  } catch (const text::ExpressionError& error) {
    fail(meaning.at(error.column), error.what());
  }
  notations_.add(tokens, meaning.text);
}

std::vector<std::string> PaperMap::names(const std::string& list, bool symbols_only,
                                         closures::Place place) const {
  std::vector<std::string> all;
  for (const PlacedText& word : closures::words({list, place})) {
    for (const std::string& name : spread(word.text)) {
      if (symbols_only ? system().symbol_named(name) == nullptr : !system().is_known(name)) {
        throw closures::FormulaError(
            "no symbol named '" + name + "'" + text::suggestion_or_choice(name, system().names()),
            place);
      }
      all.push_back(name);
    }
  }
  return all;
}

std::string PaperMap::quantity_named(const std::string& symbol, const Tokens& tokens) const {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const auto atom = generator::latex::read_atom(tokens, at);
    if (!atom || generator::latex::symbols_of(generator::latex::slice(tokens, at, atom->end)) !=
                     std::vector<std::string>{symbol}) {
      continue;
    }
    const auto meaning = notations_.at(tokens, at);
    if (meaning && system().symbol_named(meaning->formula) != nullptr) {
      return meaning->formula;
    }
  }
  throw closures::FormulaError("no quantity is known as '" + symbol + "'", tokens[0].place);
}

std::optional<generator::latex::Meaning> PaperMap::quantity(const Tokens& side) const {
  Tokens plain = side;
  std::erase_if(plain, [](const generator::latex::Token& token) {
    return generator::latex::is_layout(token) || generator::latex::is_thin_space(token);
  });
  if (plain.empty()) {
    return std::nullopt;
  }
  const std::optional<generator::latex::Meaning> meaning = notations_.at(plain, 0);
  const bool whole =
      meaning && meaning->end == plain.size() && meaning->power.empty() && meaning->dots == 0;
  return whole ? meaning : std::nullopt;
}

std::optional<PrintedMatrix> PaperMap::matrix_frame(const Tokens& notation) const {
  const std::vector<std::string> symbols = generator::latex::symbols_of(notation);
  for (const Matrix& matrix : matrices_) {
    if (const auto captured = generator::latex::matched(matrix.pattern, symbols)) {
      const closures::Place place = notation[0].place;
      if (matrix.rows.empty()) {
        return PrintedMatrix{};
      }
      // A `?` of the columns is a notation of the paper.
      std::vector<std::string> columns;
      for (const PlacedText& word : closures::words({matrix.columns, place})) {
        if (word.text != "?") {
          const std::vector<std::string> some = names(word.text, true, place);
          columns.insert(columns.end(), some.begin(), some.end());
          continue;
        }
        columns.push_back(quantity_named((*captured)[0], notation));
      }
      return PrintedMatrix{names(matrix.rows, false, place), columns, {}};
    }
  }
  return std::nullopt;
}

}  // namespace assur::generator::audit::latex
