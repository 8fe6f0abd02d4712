#include "audit/auditor.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "audit/audit.hpp"
#include "audit/code_matrix.hpp"
#include "audit/code_text.hpp"
#include "audit/kind_audit.hpp"
#include "audit/scene_values.hpp"
#include "closures/formula.hpp"
#include "input_file.hpp"
#include "scene/suggestion.hpp"

namespace assur::generator {

namespace {

/// The text after a word that must come next, which is taken off.
bool take_keyword(PlacedText& text, const std::string& keyword) {
  PlacedText rest = text;
  if (take_word(rest).text != keyword) {
    return false;
  }
  text = rest;
  return true;
}

PlacedText after_words(PlacedText text, int count) {
  for (; count > 0; --count) {
    static_cast<void>(take_word(text));
  }
  return text;
}

/// The parts of a text before and after a word; the second is empty where there is none.
std::pair<PlacedText, PlacedText> cut_at_word(const PlacedText& text, const std::string& word) {
  const std::string padded = text.text + " ";
  const std::size_t at = padded.find(" " + word + " ");
  if (at == std::string::npos) {
    return {text, {}};
  }
  return {trimmed({text.text.substr(0, at), text.place}),
          trimmed({padded.substr(at + word.size() + 2), text.at(at + word.size() + 3)})};
}

}  // namespace

bool AuditReport::agrees() const {
  return std::all_of(statements.begin(), statements.end(), [](const AuditedStatement& statement) {
    return std::all_of(statement.findings.begin(), statement.findings.end(),
                       [](const Finding& finding) { return finding.agrees(); });
  });
}

AuditReport audit_text(const std::string& text, const std::string& file) {
  Auditor auditor(file);
  for (const Statement& statement : parse_statements(text, file)) {
    auditor.read(statement);
  }
  AuditReport report = auditor.report();
  if (report.statements.empty()) {
    throw InputError(file + ": nothing to audit; say what the source prints with 'printed'");
  }
  return report;
}

AuditReport audit_file(const std::string& file) { return audit_text(read_input_file(file), file); }

AuditReport Auditor::report() const { return {reader_.file(), reader_.source(), statements_}; }

void Auditor::expect_no_rows(const Statement& statement) const {
  if (!statement.rows.empty()) {
    reader_.fail(statement.rows[0].place, "this statement has no rows");
  }
}

void Auditor::read(const Statement& statement) {
  if (reader_.read(statement)) {
    return;
  }
  try {
    read_own(statement);
  } catch (const FormulaError& error) {
    reader_.fail(error.place, error.what());
  }
}

void Auditor::read_own(const Statement& statement) {
  using Reader = void (Auditor::*)(const PlacedText&);
  static const std::map<std::string, Reader> readers = {{"scene", &Auditor::read_scene},
                                                        {"group", &Auditor::read_group},
                                                        {"given", &Auditor::read_given},
                                                        {"value", &Auditor::read_value}};
  PlacedText rest = statement.head;
  const PlacedText keyword = take_word(rest);
  if (keyword.text == "printed") {
    read_printed(statement, rest);
  } else if (const auto reader = readers.find(keyword.text); reader != readers.end()) {
    (this->*reader->second)(after_words(joined(statement), 1));
  } else {
    std::vector<std::string> known = ClosureReader::keywords();
    known.emplace_back("printed");
    for (const auto& [name, function] : readers) {
      known.push_back(name);
    }
    reader_.fail(keyword.place,
                 "no statement '" + keyword.text + "'" + suggestion(keyword.text, known));
  }
}

void Auditor::define(const std::string& name, double value) {
  numbers_.define(name, value);
  reader_.reserve(name);
}

void Auditor::read_scene(const PlacedText& rest) {
  PlacedText after = rest;
  const PlacedText file = take_word(after);
  int configuration = 1;
  if (take_keyword(after, "branch")) {
    const PlacedText number = take_word(after);
    const char* const last = number.text.data() + number.text.size();
    const auto [end, error] = std::from_chars(number.text.data(), last, configuration);
    if (error != std::errc() || end != last) {
      reader_.fail(number.place, "expected the number of a configuration");
    }
  }
  if (file.empty() || !after.empty()) {
    reader_.fail(rest.place, "expected scene FILE [branch N]");
  }
  const std::string path = (directory_ / file.text).string();
  for (const auto& [name, value] : scene_values(path, configuration, settings_)) {
    define(name, value);
  }
}

void Auditor::read_group(const PlacedText& rest) {
  for (const auto& [name, value] : group_numbers(group_by_name(rest))) {
    define(name, value);
  }
}

const Group& Auditor::group_by_name(const PlacedText& name) const {
  for (const Group& group : known_groups()) {
    if (group.name() == name.text) {
      return group;
    }
  }
  reader_.fail(name.place, "no group named '" + name.text + "'; there are dyad, triad and tetrad");
}

void Auditor::read_given(const PlacedText& rest) {
  for (const PlacedText& each : split(rest, ',')) {
    const auto [name, number] = cut(each, '=');
    reader_.expect_new(name);
    PlacedText value = number;
    const PlacedText first = take_word(value);
    numbers_.give(name.text, first);
    reader_.reserve(name.text);
    settings_.push_back(name.text + "=" + first.text);
  }
}

void Auditor::read_value(const PlacedText& rest) {
  const auto [name, definition] = cut(rest, '=');
  reader_.expect_new(name);
  numbers_.define(name.text, definition);
  reader_.reserve(name.text);
}

void Auditor::answer(const std::string& label, Place place, std::size_t columns,
                     std::vector<Finding> findings) {
  if (columns == 0 && !statements_.empty() && statements_.back().label == label) {
    std::move(findings.begin(), findings.end(), std::back_inserter(statements_.back().findings));
  } else {
    statements_.push_back({label, reader_.place_in_file(place), columns, std::move(findings), ""});
  }
}

void Auditor::read_printed(const Statement& statement, PlacedText rest) {
  const PlacedText what = take_word(rest);
  if (what.text == "number") {
    expect_no_rows(statement);
    read_printed_number(rest);
    return;
  }
  PlacedText after = rest;
  const PlacedText label = take_word(after);
  if (what.text == "matrix") {
    read_printed_matrix(statement, label, after);
  } else if (what.text == "kinds") {
    read_printed_kinds(statement, label, after);
  } else {
    after = after_words(joined(statement), 3);  // printed WHAT LABEL
    if (what.text == "closure") {
      read_printed_closure(label, after);
    } else if (what.text == "code") {
      read_printed_code(label, after);
    } else if (what.text == "equation") {
      read_printed_equation(label, after);
    } else {
      reader_.fail(what.place,
                   "expected closure, matrix, code, equation, kinds or number after 'printed'");
    }
  }
}

void Auditor::read_printed_closure(const PlacedText& label, PlacedText rest) {
  const PlacedText name = take_word(rest);
  if (reader_.system().closure_named(name.text) == nullptr) {
    reader_.fail(name.place, "no closure named '" + name.text + "' is derived");
  }
  if (!rest.empty() && rest.text[0] == ':') {
    rest = trimmed({rest.text.substr(1), rest.at(2)});
  }
  Finding finding = audit_closure(points_, name.text, rest);
  finding.place = reader_.place_in_file(finding.place);
  answer("closure " + label.text, label.place, 0, {finding});
}

PrintedMatrix Auditor::matrix_frame(const PlacedText& rest) {
  const auto [head, columns] = cut_at_word(rest, "by");
  PlacedText rows = head;
  if (!take_keyword(rows, "of") || columns.empty()) {
    reader_.fail(rest.place, "expected of ROWS by COLUMNS");
  }
  return {reader_.known_names(rows, false), reader_.known_names(columns, true), {}};
}

void Auditor::read_printed_matrix(const Statement& statement, const PlacedText& label,
                                  const PlacedText& rest) {
  PrintedMatrix matrix = matrix_frame(rest);
  if (statement.rows.size() != matrix.rows.size()) {
    reader_.fail(statement.head.place, "expected " + std::to_string(matrix.rows.size()) +
                                           " rows, found " + std::to_string(statement.rows.size()));
  }
  for (const PlacedText& row : statement.rows) {
    const std::vector<PlacedText> entries = split(row, ',');
    if (entries.size() != matrix.columns.size()) {
      reader_.fail(row.place, "expected " + std::to_string(matrix.columns.size()) +
                                  " entries, found " + std::to_string(entries.size()));
    }
    for (const PlacedText& entry : entries) {
      matrix.entries.push_back({entry, {}});
    }
  }
  answer("matrix " + label.text, label.place, matrix.columns.size(), audit_matrix(points_, matrix));
}

void Auditor::read_printed_code(const PlacedText& label, PlacedText rest) {
  const PlacedText file = take_word(rest);
  const PlacedText array = take_word(rest);
  if (!is_identifier(array.text)) {
    reader_.fail(array.place, "expected the name of a matrix in the code");
  }
  PrintedMatrix matrix = matrix_frame(rest);
  const std::string path = (directory_ / file.text).string();
  std::string code;
  try {
    code = read_input_file(path);
  } catch (const InputError& error) {
    reader_.fail(file.place, error.what());
  }
  matrix.entries = read_code_matrix(code, path, array.text, matrix.rows.size(),
                                    matrix.columns.size(), reader_.system());
  std::vector<Finding> findings = audit_matrix(points_, matrix);
  for (std::size_t place = 0; place < findings.size(); ++place) {
    Finding& finding = findings[place];
    finding.place = place_in_code(code, finding.place);
    if (matrix.entries[place].text.empty() && !finding.agrees()) {
      finding.note = "nothing is assigned to it, so it counts as zero";
    }
  }
  answer("code " + label.text + " (" + file.text + ")", label.place, matrix.columns.size(),
         std::move(findings));
  statements_.back().file = path;
}

void Auditor::read_printed_equation(const PlacedText& label, PlacedText rest) {
  PlacedText loops;
  if (take_keyword(rest, "for")) {
    std::tie(loops, rest) = cut(rest, ':');
  } else if (!rest.empty() && rest.text[0] == ':') {
    rest = trimmed({rest.text.substr(1), rest.at(2)});
  }
  const auto [left, right] = cut(rest, '=');
  if (right.empty()) {
    reader_.fail(rest.place, "expected an equation LEFT = RIGHT");
  }
  std::vector<LocalNames> cases = {{}};
  for (const PlacedText& loop : loops.empty() ? std::vector<PlacedText>{} : split(loops, ',')) {
    const auto [variable, list] = cut_at_word(loop, "in");
    reader_.expect_new(variable);
    std::vector<LocalNames> more;
    for (const LocalNames& one : cases) {
      for (const std::string& name : reader_.known_names(list, false)) {
        more.push_back(one);
        more.back().stands_for[variable.text] = name;
      }
    }
    cases = more;
  }
  std::vector<Finding> findings;
  for (const LocalNames& one : cases) {
    std::string item;
    for (const auto& [variable, name] : one.stands_for) {
      item += (item.empty() ? "" : ", ") + variable + " = " + name;
    }
    findings.push_back(audit_equation(points_, item, left, right, one));
    findings.back().place = reader_.place_in_file(findings.back().place);
  }
  answer("equation " + label.text, label.place, 0, std::move(findings));
}

void Auditor::read_printed_kinds(const Statement& statement, const PlacedText& label,
                                 PlacedText rest) {
  if (!take_keyword(rest, "of")) {
    reader_.fail(rest.place, "expected printed kinds LABEL of GROUP");
  }
  answer("kinds " + label.text, label.place, 0,
         audit_kinds(group_by_name(rest), statement.rows, reader_.file()));
}

void Auditor::read_printed_number(const PlacedText& rest) {
  const auto [head, formula] = cut_at_word(rest, "is");
  const auto [left, right] = cut(head, '=');
  std::vector<PlacedText> names = words(left);
  PlacedText unit = right;
  const PlacedText number = take_word(unit);
  if (formula.empty() || right.empty() || names.empty()) {
    reader_.fail(rest.place, "expected printed number [LABEL] NAME = NUMBER [UNIT] is FORMULA");
  }
  const PlacedText name = names.back();
  reader_.expect_new(name);
  Finding finding = numbers_.audit(name.text, number, formula);
  reader_.reserve(name.text);
  finding.item += unit.empty() ? "" : ", " + unit.text;
  answer("number " + (names.size() > 1 ? names[0].text : name.text), name.place, 0, {finding});
}

}  // namespace assur::generator
