#include "audit/latex/paper_map.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>
#include <assur/text/input_file.hpp>
#include <assur/text/names.hpp>
#include <assur/text/suggestion.hpp>
#include <filesystem>

#include "latex/rows.hpp"

namespace assur::generator::audit::latex {

namespace {

using closures::PlacedText;

/// `1..13` as the numbers from 1 to 13, `f1..4` as f1, f2, f3, f4, and a word without dots
/// unchanged. Throws FormulaError for an empty range, or one beyond 999.
std::vector<std::string> spread(const std::string& word, closures::Place place) {
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
    throw closures::FormulaError(
        "expected a range such as 1..4, upwards and of numbers below 1000, found '" + word + "'",
        place);
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

/// The rest of a text that begins with a word.
std::optional<PlacedText> behind(const PlacedText& text, const std::string& word) {
  PlacedText rest = text;
  if (closures::take_word(rest).text != word) {
    return std::nullopt;
  }
  return rest;
}

/// Statements of audit files that a map may not have, since the paper itself holds what is printed.
const std::vector<std::string> of_the_audit = {"printed", "scene", "group", "given", "value"};

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
  expect_known_names();
}

void PaperMap::fail(closures::Place place, const std::string& what) const {
  throw closures::AuditSyntaxError(file_, closures::place_in(statement_, place), what);
}

void PaperMap::read(const closures::Statement& statement) {
  statement_ = statement;
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
  if (!notation && contains(of_the_audit, keyword.text)) {
    fail(keyword.place,
         "'" + keyword.text +
             "' is a statement of audit files, and a map has none of them; leave it out");
  }
  read_notation(line);
}

void PaperMap::read_closures(const PlacedText& file) {
  if (file.empty()) {
    fail(file.place, "the name of a file is missing");
  }
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
      throw closures::AuditSyntaxError(
          path, keyword.place,
          "no statement '" + keyword.text + "'" +
              text::suggestion_or_choice(keyword.text, closures::ClosureReader::keywords()));
    }
  }
}

/// `\numbered{EQUATION}{NUMBER}`
void PaperMap::read_display(const PlacedText& rest) {
  const Tokens tokens = generator::latex::tokens_of(rest.text, file_, rest.place);
  if (tokens.empty() || !tokens[0].is_command()) {
    fail(rest.place, "expected 'display \\COMMAND{EQUATION}{NUMBER}'");
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
    fail(rest.place, "expected 'display \\COMMAND{EQUATION}{NUMBER}'");
  }
  if (!commands_.emplace(tokens[0].text, command).second) {
    fail(rest.place, "the command '" + tokens[0].text + "' is given twice; leave one out");
  }
}

void PaperMap::read_index(const PlacedText& rest,
                          std::map<std::string, std::vector<std::string>>& list) {
  const auto [name, range] = closures::cut(rest, '=');
  std::vector<std::string> values;
  for (const PlacedText& word : closures::words(range)) {
    const std::vector<std::string> some = spread(word.text, word.place);
    values.insert(values.end(), some.begin(), some.end());
  }
  if (name.text.size() != 1 || values.empty()) {
    fail(rest.place, "expected an index and its values, such as j = 1..4");
  }
  if (indices_.contains(name.text) || summed_.contains(name.text)) {
    fail(name.place, "the index '" + name.text + "' is given twice; leave one out");
  }
  list[name.text] = values;
  if (sums_itself(name.text)) {
    fail(rest.place, "the values of the index '" + name.text +
                         "' contain it again, so that the sum would not end; use another letter");
  }
}

/// Whether the terms of a sum over the index contain the index again, directly or through the index
/// of another sum: such a sum would never end.
bool PaperMap::sums_itself(const std::string& index) const {
  std::vector<std::string> reached = {index};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const auto found = summed_.find(reached[next]);
    if (found == summed_.end()) {
      continue;
    }
    for (const char letter : text::joined(found->second, "")) {
      if (std::string(1, letter) == index) {
        return true;
      }
      if (!contains(reached, std::string(1, letter))) {
        reached.emplace_back(1, letter);
      }
    }
  }
  return false;
}

void PaperMap::read_skip(const PlacedText& rest) {
  if (const std::optional<PlacedText> sections = behind(rest, "sections")) {
    std::vector<PlacedText> parts = closures::split(*sections, ',');
    for (PlacedText& part : parts) {
      if (part.empty()) {
        fail(part.place, "the title of a section is missing");
      }
      part.place = closures::place_in(statement_, part.place);
    }
    section_lists_.push_back(std::move(parts));
    return;
  }
  if (rest.empty()) {
    fail(rest.place, "expected equations, such as 'skip (2) (9)', or 'skip sections TITLE, ...'");
  }
  for (const PlacedText& label : closures::words(rest)) {
    skipped_.emplace(label.text, closures::place_in(statement_, label.place));
  }
}

void PaperMap::find_skipped(const std::set<std::string>& labels,
                            const std::set<std::string>& sections) {
  for (const auto& [label, place] : skipped_) {
    if (!labels.contains(label)) {
      throw closures::AuditSyntaxError(
          file_, place, "the paper has no equation " + label + " that could be skipped");
    }
  }
  for (const std::vector<PlacedText>& parts : section_lists_) {
    for (std::size_t from = 0; from < parts.size();) {
      from = skip_section(parts, from, sections);
    }
  }
}

std::size_t PaperMap::skip_section(const std::vector<PlacedText>& parts, std::size_t from,
                                   const std::set<std::string>& sections) {
  std::size_t longest = 0;
  for (const std::string& section : sections) {
    longest = std::max(longest, section.size());
  }
  std::string found;
  std::size_t behind_found = from;
  std::string title;
  for (std::size_t to = from; to < parts.size() && title.size() <= longest; ++to) {
    title += (to == from ? "" : ", ") + parts[to].text;
    if (sections.contains(title)) {
      found = title;
      behind_found = to + 1;
    }
  }
  if (behind_found > from) {
    skipped_sections_.insert(found);
    return behind_found;
  }
  const PlacedText& missing = parts[from];
  throw closures::AuditSyntaxError(
      file_, missing.place,
      "the paper has no section '" + missing.text + "' that could be skipped" +
          text::suggestion(missing.text, {sections.begin(), sections.end()}));
}

void PaperMap::expect_new(const PlacedText& notation, const Tokens& tokens) const {
  const std::vector<std::string> symbols = generator::latex::symbols_of(tokens);
  if (symbols.empty()) {
    fail(notation.place,
         "the notation '" + notation.text + "' has no symbol; write the one that the paper prints");
  }
  if (notations_.contains(tokens) ||
      std::any_of(matrices_.begin(), matrices_.end(),
                  [&](const Matrix& matrix) { return matrix.pattern == symbols; })) {
    fail(notation.place, "the notation '" + notation.text + "' is given twice; leave one out");
  }
}

void PaperMap::read_notation(const PlacedText& line) {
  const auto [notation, meaning] = closures::cut(line, '=');
  if (meaning.empty() || notation.empty()) {
    fail(line.place, "expected NOTATION = QUANTITY, or a statement of a map" +
                         text::suggestion(line.text, own_keywords));
  }
  const Tokens tokens = generator::latex::tokens_of(notation.text, file_, notation.place);
  generator::latex::expect_readable_size(tokens);
  expect_new(notation, tokens);
  if (meaning.text == "as printed") {
    notations_.add(tokens, "");
    return;
  }
  if (const std::optional<PlacedText> matrix = behind(meaning, "matrix")) {
    Matrix added{generator::latex::symbols_of(tokens), {}, {}, statement_, {}};
    if (matrix->text != "by its titles") {
      const std::size_t by = matrix->text.find(" by ");
      if (!matrix->text.starts_with("of ") || by == std::string::npos) {
        fail(meaning.place, "expected 'matrix of ROWS by COLUMNS' or 'matrix by its titles'");
      }
      added.rows = closures::trimmed({matrix->text.substr(3, by - 3), matrix->at(4)});
      added.columns = closures::trimmed({matrix->text.substr(by + 4), matrix->at(by + 5)});
      if (added.rows.empty() || added.columns.empty()) {
        fail((added.rows.empty() ? added.rows : added.columns).place, "the names are missing");
      }
      const auto has_wildcard = [](const std::string& text) {
        return text.find('?') != std::string::npos;
      };
      if (has_wildcard(added.columns.text) &&
          std::none_of(added.pattern.begin(), added.pattern.end(), has_wildcard)) {
        fail(added.columns.place, "the notation has no '?' for which the one here could stand");
      }
    }
    matrices_.push_back(std::move(added));
    return;
  }
  try {
    static_cast<void>(
        text::parse_expression(generator::latex::filled(meaning.text, {"1"}, meaning.place),
                               closures::formula_functions()));
  } catch (const text::ExpressionError& error) {
    fail(meaning.at(error.column), error.what());
  }
  notations_.add(tokens, meaning.text);
  formulas_.push_back({statement_, meaning});
}

void PaperMap::expect_known_names() {
  const auto fail_in = [&](const closures::Statement& statement,
                           const closures::FormulaError& error) {
    throw closures::AuditSyntaxError(file_, closures::place_in(statement, error.place),
                                     error.what());
  };
  for (const Formula& formula : formulas_) {
    if (formula.text.text.find('?') != std::string::npos) {
      continue;  // filled in by the paper's notation
    }
    try {
      expect_known_names(text::parse_expression(formula.text.text, closures::formula_functions()),
                         formula.text);
    } catch (const closures::FormulaError& error) {
      fail_in(formula.statement, error);
    }
  }
  for (Matrix& matrix : matrices_) {
    try {
      matrix.row_names = rows_in(matrix.rows, reader_.system(),
                                 [this](const PlacedText& word) { return names(word, false); });
      PrintedMatrix frame{matrix.row_names, {}, {}};
      for (const PlacedText& word : closures::words(matrix.columns)) {
        if (word.text != "?") {
          frame.columns = names(word, true);
          expect_parameters(frame, system(), word.place);
        }
      }
    } catch (const closures::FormulaError& error) {
      fail_in(matrix.statement, error);
    }
  }
}

void PaperMap::expect_known_names(const text::Expression& tree, const PlacedText& formula) const {
  if (tree.kind == text::Expression::Kind::name && !system().is_known(tree.name)) {
    throw closures::FormulaError("no symbol named '" + tree.name + "'" +
                                     text::suggestion_or_choice(tree.name, system().names()),
                                 formula.at(tree.column));
  }
  for (const text::Expression& argument : tree.arguments) {
    expect_known_names(argument, formula);
  }
}

std::vector<std::string> PaperMap::names(const PlacedText& list, bool symbols_only) const {
  std::vector<std::string> all;
  for (const PlacedText& word : closures::words(list)) {
    for (const std::string& name : spread(word.text, word.place)) {
      const bool known = system().is_known(name);
      if (known && symbols_only && system().symbol_named(name) == nullptr) {
        throw closures::FormulaError("'" + name + "' is not the name of a length or an angle",
                                     word.place);
      }
      if (!known) {
        throw closures::FormulaError(
            "no symbol named '" + name + "'" + text::suggestion_or_choice(name, system().names()),
            word.place);
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
      if (matrix.rows.empty()) {
        return PrintedMatrix{};
      }
      // A `?` among the columns is a quantity in the paper's notation.
      std::vector<std::string> columns;
      for (const PlacedText& word : closures::words(matrix.columns)) {
        if (word.text != "?") {
          const std::vector<std::string> some = names(word, true);
          columns.insert(columns.end(), some.begin(), some.end());
          continue;
        }
        columns.push_back(quantity_named((*captured)[0], notation));
      }
      PrintedMatrix frame{matrix.row_names, columns, {}};
      expect_parameters(frame, system(), notation[0].place);
      return frame;
    }
  }
  return std::nullopt;
}

}  // namespace assur::generator::audit::latex
