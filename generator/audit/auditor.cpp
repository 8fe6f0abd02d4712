#include "audit/auditor.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "audit/audit.hpp"
#include "audit/code_matrix.hpp"
#include "audit/code_text.hpp"
#include "audit/kind_audit.hpp"
#include "audit/model_symbols.hpp"
#include "audit/scene_values.hpp"
#include "scene/expression.hpp"
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

/// The parts of a text before and after a word.
std::pair<PlacedText, PlacedText> cut_at_word(const PlacedText& text, const std::string& word) {
  const std::string padded = text.text + " ";
  for (std::size_t at = padded.find(" " + word + " "); at != std::string::npos;) {
    const PlacedText before = trimmed({text.text.substr(0, at), text.place});
    const PlacedText after =
        trimmed({padded.substr(at + word.size() + 2), text.at(at + word.size() + 3)});
    return {before, after};
  }
  return {text, {}};
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
  return auditor.report();
}

AuditReport audit_file(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw InputError(file + ": cannot be read");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return audit_text(text.str(), file);
}

void Auditor::fail(Place place, const std::string& what) const {
  throw AuditSyntaxError(report_.file, place, what);
}

GiNaC::ex Auditor::formula(const PlacedText& text) {
  try {
    return read_formula(text, system_);
  } catch (const FormulaError& error) {
    fail(error.place, error.what());
  }
}

void Auditor::expect_new(const PlacedText& name) const {
  if (!is_identifier(name.text) || is_reserved_name(name.text)) {
    fail(name.place, "'" + name.text + "' cannot be a name");
  }
  if (system_.is_known(name.text) || numbers_.is_known(name.text)) {
    fail(name.place, "'" + name.text + "' is declared already");
  }
}

void Auditor::expect_no_rows(const Statement& statement) const {
  if (!statement.rows.empty()) {
    fail(statement.rows[0].place, "this statement has no rows");
  }
}

std::vector<std::string> Auditor::known_names(const PlacedText& list, bool symbols_only) {
  std::vector<std::string> names;
  for (const PlacedText& name : words(list)) {
    const bool known =
        symbols_only ? system_.symbol_named(name.text) != nullptr : system_.is_known(name.text);
    if (!known) {
      fail(name.place,
           "no symbol named '" + name.text + "'" + suggestion(name.text, system_.names()));
    }
    names.push_back(name.text);
  }
  if (names.empty()) {
    fail(list.place, "names are missing");
  }
  return names;
}

std::string Auditor::read_file_beside(const PlacedText& name) const {
  std::ifstream stream(directory_ / name.text);
  if (!stream) {
    fail(name.place, "'" + name.text + "' cannot be read");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void Auditor::read(const Statement& statement) {
  using Reader = void (Auditor::*)(const PlacedText&);
  static const std::map<std::string, Reader> readers = {
      {"model", &Auditor::read_model},   {"unknown", &Auditor::read_unknowns},
      {"moving", &Auditor::read_moving}, {"let", &Auditor::read_abbreviation},
      {"loop", &Auditor::read_loop},     {"closure", &Auditor::read_closure},
      {"scene", &Auditor::read_scene},   {"group", &Auditor::read_group},
      {"given", &Auditor::read_given},   {"value", &Auditor::read_value}};
  PlacedText rest = statement.head;
  const PlacedText keyword = take_word(rest);
  if (keyword.text == "printed") {
    read_printed(statement, rest);
    return;
  }
  // Other statements go on over their rows.
  for (const PlacedText& row : statement.rows) {
    rest.text += std::string(row.place.column, ' ') + row.text;
  }
  if (keyword.text == "source") {
    report_.source = rest.text;
  } else if (keyword.text == "angle" || keyword.text == "length") {
    read_symbols(rest, keyword.text == "angle");
  } else if (const auto reader = readers.find(keyword.text); reader != readers.end()) {
    (this->*reader->second)(rest);
  } else {
    std::vector<std::string> known = {"source", "angle", "length", "printed"};
    for (const auto& [name, function] : readers) {
      known.push_back(name);
    }
    fail(keyword.place, "no statement '" + keyword.text + "'" + suggestion(keyword.text, known));
  }
}

void Auditor::read_model(const PlacedText& kind) {
  try {
    declare_model(kind.text, system_);
  } catch (const InputError& error) {
    fail(kind.place, error.what());
  }
}

void Auditor::read_symbols(const PlacedText& rest, bool angles) {
  const auto [names, meaning] = cut(rest, ':');
  for (const PlacedText& name : words(names)) {
    expect_new(name);
    system_.declare(name.text, angles, meaning.text);
  }
}

void Auditor::read_unknowns(const PlacedText& rest) {
  for (const std::string& name : known_names(rest, true)) {
    system_.symbol_named(name)->unknown = true;
  }
}

void Auditor::read_moving(const PlacedText& rest) {
  for (const std::string& name : known_names(rest, true)) {
    system_.symbol_named(name)->moving = true;
  }
}

void Auditor::read_abbreviation(const PlacedText& rest) {
  const auto [name, definition] = cut(rest, '=');
  expect_new(name);
  system_.abbreviate(name.text, formula(definition));
}

void Auditor::read_loop(const PlacedText& rest) {
  const auto [names, vectors] = cut(rest, '=');
  const std::vector<PlacedText> both = words(names);
  if (both.size() != 2) {
    fail(names.place, "expected loop X_CLOSURE Y_CLOSURE = VECTOR");
  }
  expect_new(both[0]);
  expect_new(both[1]);
  try {
    const Vector2 sum = read_vector(vectors, system_);
    system_.close(both[0].text, sum.x);
    system_.close(both[1].text, sum.y);
  } catch (const FormulaError& error) {
    fail(error.place, error.what());
  }
}

void Auditor::read_closure(const PlacedText& rest) {
  const std::vector<PlacedText> parts = split(rest, '=');
  if (parts.size() < 2 || parts.size() > 3) {
    fail(rest.place, "expected closure NAME = EXPRESSION [= EXPRESSION]");
  }
  expect_new(parts[0]);
  const GiNaC::ex left = formula(parts[1]);
  system_.close(parts[0].text, parts.size() == 3 ? left - formula(parts[2]) : left);
}

void Auditor::read_scene(const PlacedText& rest) {
  PlacedText after = rest;
  const PlacedText file = take_word(after);
  int configuration = 1;
  if (take_keyword(after, "branch")) {
    const PlacedText number = take_word(after);
    configuration = std::atoi(number.text.c_str());
  }
  if (file.empty() || !after.empty()) {
    fail(rest.place, "expected scene FILE [branch N]");
  }
  const std::string path = (directory_ / file.text).string();
  for (const auto& [name, value] : scene_values(path, configuration, settings_)) {
    numbers_.define(name, value);
  }
}

void Auditor::read_group(const PlacedText& rest) {
  for (const auto& [name, value] : group_numbers(group_by_name(rest))) {
    numbers_.define(name, value);
  }
}

const Group& Auditor::group_by_name(const PlacedText& name) const {
  for (const Group& group : known_groups()) {
    if (group.name() == name.text) {
      return group;
    }
  }
  fail(name.place, "no group named '" + name.text + "'; there are dyad, triad and tetrad");
}

void Auditor::read_given(const PlacedText& rest) {
  for (const PlacedText& each : split(rest, ',')) {
    const auto [name, number] = cut(each, '=');
    expect_new(name);
    PlacedText value = number;
    const PlacedText first = take_word(value);
    numbers_.give(name.text, first);
    settings_.push_back(name.text + "=" + first.text);
  }
}

void Auditor::read_value(const PlacedText& rest) {
  const auto [name, definition] = cut(rest, '=');
  expect_new(name);
  numbers_.define(name.text, definition);
}

void Auditor::answer(const std::string& label, Place place, std::size_t columns,
                     std::vector<Finding> findings) {
  std::vector<AuditedStatement>& statements = report_.statements;
  if (columns == 0 && !statements.empty() && statements.back().label == label) {
    std::move(findings.begin(), findings.end(), std::back_inserter(statements.back().findings));
  } else {
    statements.push_back({label, place, columns, std::move(findings), ""});
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
    for (const PlacedText& row : statement.rows) {
      after.text += " " + row.text;
    }
    if (what.text == "closure") {
      read_printed_closure(label, after);
    } else if (what.text == "code") {
      read_printed_code(label, after);
    } else if (what.text == "equation") {
      read_printed_equation(label, after);
    } else {
      fail(what.place, "expected closure, matrix, code, equation, kinds or number after 'printed'");
    }
  }
}

void Auditor::read_printed_closure(const PlacedText& label, PlacedText rest) {
  const PlacedText name = take_word(rest);
  if (system_.closure_named(name.text) == nullptr) {
    fail(name.place, "no closure named '" + name.text + "' is derived");
  }
  if (!rest.empty() && rest.text[0] == ':') {
    rest = trimmed({rest.text.substr(1), rest.at(2)});
  }
  answer("closure " + label.text, label.place, 0, {audit_closure(system_, name.text, rest)});
}

PrintedMatrix Auditor::matrix_frame(const PlacedText& rest) {
  const auto [head, columns] = cut_at_word(rest, "by");
  PlacedText rows = head;
  if (!take_keyword(rows, "of") || columns.empty()) {
    fail(rest.place, "expected of ROWS by COLUMNS");
  }
  return {known_names(rows, false), known_names(columns, true), {}};
}

void Auditor::read_printed_matrix(const Statement& statement, const PlacedText& label,
                                  const PlacedText& rest) {
  PrintedMatrix matrix = matrix_frame(rest);
  if (statement.rows.size() != matrix.rows.size()) {
    fail(statement.head.place, "expected " + std::to_string(matrix.rows.size()) + " rows, found " +
                                   std::to_string(statement.rows.size()));
  }
  for (const PlacedText& row : statement.rows) {
    const std::vector<PlacedText> entries = split(row, ',');
    if (entries.size() != matrix.columns.size()) {
      fail(row.place, "expected " + std::to_string(matrix.columns.size()) + " entries, found " +
                          std::to_string(entries.size()));
    }
    for (const PlacedText& entry : entries) {
      matrix.entries.push_back({entry, {}});
    }
  }
  answer("matrix " + label.text, label.place, matrix.columns.size(), audit_matrix(system_, matrix));
}

void Auditor::read_printed_code(const PlacedText& label, PlacedText rest) {
  const PlacedText file = take_word(rest);
  const PlacedText array = take_word(rest);
  if (!is_identifier(array.text)) {
    fail(array.place, "expected the name of a matrix in the code");
  }
  PrintedMatrix matrix = matrix_frame(rest);
  const std::string code = read_file_beside(file);
  const std::string path = (directory_ / file.text).string();
  matrix.entries =
      read_code_matrix(code, path, array.text, matrix.rows.size(), matrix.columns.size(), system_);
  std::vector<Finding> findings = audit_matrix(system_, matrix);
  for (std::size_t place = 0; place < findings.size(); ++place) {
    Finding& finding = findings[place];
    finding.place = place_in_code(code, finding.place);
    if (matrix.entries[place].text.empty() && !finding.agrees()) {
      finding.note = "nothing is assigned to it, so it counts as zero";
    }
  }
  answer("code " + label.text + " (" + file.text + ")", label.place, matrix.columns.size(),
         std::move(findings));
  report_.statements.back().file = path;
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
    fail(rest.place, "expected an equation LEFT = RIGHT");
  }
  std::vector<LocalNames> cases = {{}};
  for (const PlacedText& loop : loops.empty() ? std::vector<PlacedText>{} : split(loops, ',')) {
    const auto [variable, list] = cut_at_word(loop, "in");
    expect_new(variable);
    std::vector<LocalNames> more;
    for (const LocalNames& one : cases) {
      for (const std::string& name : known_names(list, false)) {
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
    findings.push_back(audit_equation(system_, item, left, right, one));
  }
  answer("equation " + label.text, label.place, 0, std::move(findings));
}

void Auditor::read_printed_kinds(const Statement& statement, const PlacedText& label,
                                 PlacedText rest) {
  if (!take_keyword(rest, "of")) {
    fail(rest.place, "expected printed kinds LABEL of GROUP");
  }
  answer("kinds " + label.text, label.place, 0,
         audit_kinds(group_by_name(rest), statement.rows, report_.file));
}

void Auditor::read_printed_number(const PlacedText& rest) {
  const auto [head, formula] = cut_at_word(rest, "is");
  const auto [left, right] = cut(head, '=');
  std::vector<PlacedText> names = words(left);
  PlacedText unit = right;
  const PlacedText number = take_word(unit);
  if (formula.empty() || right.empty() || names.empty()) {
    fail(rest.place, "expected printed number [LABEL] NAME = NUMBER [UNIT] is FORMULA");
  }
  const PlacedText name = names.back();
  expect_new(name);
  Finding finding = numbers_.audit(name.text, number, formula);
  finding.item += unit.empty() ? "" : ", " + unit.text;
  answer("number " + (names.size() > 1 ? names[0].text : name.text), name.place, 0, {finding});
}

}  // namespace assur::generator
