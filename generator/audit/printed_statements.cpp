// Reads the `printed` statements of an audit file and finds their verdicts.
#include <assur/text/counts.hpp>
#include <assur/text/input_file.hpp>
#include <set>

#include "audit/auditor.hpp"
#include "audit/code/code_matrix.hpp"
#include "audit/kind_audit.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

/// The parts of a text before and after a word; if the word is absent, the second is empty and lies
/// at the end of the text.
std::pair<closures::PlacedText, closures::PlacedText> cut_at_word(const closures::PlacedText& text,
                                                                  const std::string& word) {
  const std::string padded = text.text + " ";
  const std::size_t at = padded.find(" " + word + " ");
  if (at == std::string::npos) {
    return {text, {"", text.at(text.text.size() + 1)}};
  }
  return {closures::trimmed({text.text.substr(0, at), text.place}),
          closures::trimmed({padded.substr(at + word.size() + 2), text.at(at + word.size() + 3)})};
}

}  // namespace

closures::PlacedText Auditor::take_code_file(closures::PlacedText& rest) const {
  closures::PlacedText file = closures::take_file(rest);
  if (file.empty()) {
    reader_.fail(file.place, "the name of a file is missing");
  }
  return file;
}

void Auditor::answer(const std::string& label, closures::Place place, std::size_t columns,
                     std::vector<Finding> findings) {
  if (columns == 0 && !statements_.empty() && statements_.back().label == label) {
    std::move(findings.begin(), findings.end(), std::back_inserter(statements_.back().findings));
  } else {
    statements_.push_back({label, reader_.place_in_file(place), columns, std::move(findings), ""});
  }
}

void Auditor::read_printed(const closures::Statement& statement, closures::PlacedText rest) {
  const closures::PlacedText what = closures::take_word(rest);
  if (what.text == "number") {
    expect_no_rows(statement);
    read_printed_number(rest);
    return;
  }
  closures::PlacedText after = rest;
  const closures::PlacedText label = closures::take_word(after);
  if (what.text == "matrix") {
    read_printed_matrix(statement, label, after);
  } else if (what.text == "run") {
    read_printed_run(statement, label, after);
  } else if (what.text == "kinds") {
    read_printed_kinds(statement, label, after);
  } else {
    after = closures::after_words(closures::joined(statement), 3);  // printed WHAT LABEL
    if (what.text == "closure") {
      read_printed_closure(label, after);
    } else if (what.text == "code") {
      read_printed_code(label, after);
    } else if (what.text == "equation") {
      read_printed_equation(label, after);
    } else {
      reader_.fail(
          what.place,
          "expected closure, matrix, code, run, equation, kinds or number after 'printed'");
    }
  }
}

void Auditor::read_printed_closure(const closures::PlacedText& label, closures::PlacedText rest) {
  const closures::PlacedText name = closures::take_word(rest);
  if (name.empty()) {
    reader_.fail(name.place, "the name of a closure is missing");
  }
  if (reader_.system().closure_named(name.text) == nullptr) {
    reader_.fail(name.place, "no closure named '" + name.text + "' is derived");
  }
  if (!rest.empty() && rest.text[0] == ':') {
    rest = closures::trimmed({rest.text.substr(1), rest.at(2)});
  }
  Finding finding = audit_closure(points_, name.text, rest);
  const bool first = !printed_closures_.contains(name.text);
  printed_closures_[name.text] = is_turned(finding) && (first || printed_closures_[name.text]);
  finding.place = reader_.place_in_file(finding.place);
  answer("closure " + label.text, label.place, 0, {finding});
}

PrintedMatrix Auditor::matrix_frame(const closures::PlacedText& rest) {
  const auto [head, columns] = cut_at_word(rest, "by");
  closures::PlacedText rows = head;
  const bool is_transposed = closures::take_keyword(rows, "transpose");
  if (!closures::take_keyword(rows, "of") || columns.empty()) {
    reader_.fail(rest.place, "expected 'of ROWS by COLUMNS' or 'transpose of ROWS by COLUMNS'");
  }
  if (rows.empty()) {
    reader_.fail(rows.place, "the names are missing");
  }
  PrintedMatrix matrix{
      rows_in(rows, reader_.system(),
              [&](const closures::PlacedText& name) { return reader_.known_names(name, false); }),
      reader_.known_names(columns, true),
      {},
      is_transposed};
  if (matrix.rows.size() * matrix.columns.size() > most_entries) {
    reader_.fail(rest.place, "the matrix has more than " + std::to_string(most_entries) +
                                 " entries; divide it");
  }
  expect_parameters(matrix, reader_.system(), columns.place);
  return matrix;
}

void Auditor::read_printed_matrix(const closures::Statement& statement,
                                  const closures::PlacedText& label,
                                  const closures::PlacedText& rest) {
  PrintedMatrix matrix = matrix_frame(rest);
  if (statement.rows.size() != matrix.height()) {
    reader_.fail(statement.head.place, "expected " + text::with_noun(matrix.height(), "row") +
                                           ", found " + std::to_string(statement.rows.size()));
  }
  for (const closures::PlacedText& row : statement.rows) {
    const std::vector<closures::PlacedText> entries = closures::split(row, ',');
    if (entries.size() != matrix.width()) {
      reader_.fail(row.place, "expected " + text::with_noun(matrix.width(), "entry") + ", found " +
                                  std::to_string(entries.size()));
    }
    for (const closures::PlacedText& entry : entries) {
      matrix.entries.push_back({entry, {}});
    }
  }
  answer("matrix " + label.text, label.place, matrix.width(), audit_matrix(points_, matrix));
}

void Auditor::read_printed_code(const closures::PlacedText& label, closures::PlacedText rest) {
  const closures::PlacedText file = take_code_file(rest);
  const closures::PlacedText array = closures::take_word(rest);
  if (!text::is_identifier(array.text)) {
    reader_.fail(array.place, "expected the name of a matrix in the code");
  }
  PrintedMatrix matrix = matrix_frame(rest);
  const std::string path = (directory_ / file.text).string();
  std::string source;
  try {
    source = text::read_input_file(path);
  } catch (const text::InputError& error) {
    reader_.fail(file.place, error.what());
  }
  const std::string ending = std::filesystem::path(path).extension().string();
  static const std::set<std::string> cpp = {".cpp", ".cc",  ".cxx", ".c++", ".c",   ".h",  ".hpp",
                                            ".hh",  ".hxx", ".ipp", ".inl", ".tpp", ".cu", ".ino"};
  const bool matlab = ending == ".m";
  if (!matlab && !cpp.contains(ending)) {
    reader_.fail(file.place, "C++ (.cpp, .hpp, ...) and MATLAB (.m) are read, and '" + ending +
                                 "' is neither" + code::by_running);
  }
  const code::AuditedMatrix audited{array.text, matrix.height(), matrix.width(), ending == ".c"};
  try {
    for (const code::CodeEntry& entry :
         matlab ? code::read_matlab_matrix(source, audited, reader_.system())
                : code::read_cpp_matrix(source, audited, reader_.system())) {
      matrix.entries.push_back({entry.text, [entry] { return entry.value(); }});
    }
  } catch (const code::CodeError& error) {
    throw closures::AuditSyntaxError(path, error.place, error.what());
  }
  std::vector<Finding> findings = audit_matrix(points_, matrix);
  for (std::size_t place = 0; place < findings.size(); ++place) {
    Finding& finding = findings[place];
    if (matrix.entries[place].text.empty() && !finding.agrees()) {
      finding.note = "nothing is assigned to it, so it counts as zero";
    }
  }
  answer("code " + label.text + " (" + file.text + ")", label.place, matrix.width(),
         std::move(findings));
  statements_.back().file = path;
}

/// `[transpose] of ROWS by COLUMNS`, or `of FORMULA, FORMULA, ...`.
ExpectedMatrix Auditor::expected_matrix(const closures::PlacedText& frame) {
  ExpectedMatrix expected;
  closures::PlacedText formulas = frame;
  if (cut_at_word(frame, "by").second.empty()) {
    if (!closures::take_keyword(formulas, "of")) {
      reader_.fail(frame.place, "expected 'of ROWS by COLUMNS' or 'of FORMULA, FORMULA, ...'");
    }
    // A closure is zero where the closures hold, so it is compared elsewhere.
    expected.on_closures = !reader_.system().closures().empty();
    for (const closures::PlacedText& formula : closures::split(formulas, ',')) {
      expected.items.push_back(formula.text);
      expected.derived.push_back(closures::read_formula(formula, reader_.system()));
      expected.on_closures =
          expected.on_closures && reader_.system().closure_named(formula.text) == nullptr;
    }
    expected.size = {expected.items.size(), 1};
    return expected;
  }
  const PrintedMatrix matrix = matrix_frame(frame);
  expected.size = {matrix.height(), matrix.width()};
  expected.on_closures = !reader_.system().closures().empty();
  for (std::size_t place = 0; place < matrix.rows.size() * matrix.columns.size(); ++place) {
    const DerivedEntry entry = derived_entry(reader_.system(), matrix, place);
    expected.items.push_back(entry.item);
    expected.derived.push_back(entry.value);
  }
  return expected;
}

/// `[transpose] of NAMES by PARAMETERS`, or `of rate(NAME), ...`, with the names of a position.
OwnDerivatives Auditor::own_derivatives(const closures::PlacedText& frame) const {
  auto [rows, columns] = cut_at_word(frame, "by");
  const bool is_transposed = !columns.empty() && closures::take_keyword(rows, "transpose");
  if (!closures::take_keyword(rows, "of") || rows.empty()) {
    reader_.fail(frame.place,
                 "expected 'of NAMES by PARAMETERS' or 'of rate(NAME), ...' before 'against'");
  }
  return read_own_derivatives(columns, rows, is_transposed, reader_.system());
}

void Auditor::read_printed_run(const closures::Statement& statement,
                               const closures::PlacedText& label, closures::PlacedText rest) {
  const closures::PlacedText file = take_code_file(rest);
  RunStatement run = read_run_statement(directory_, file, statement.rows);
  if (!run_.given) {
    reader_.fail(file.place,
                 "this runs " + file.text + " on your machine, and nothing is run without --run");
  }
  if (reader_.system().symbol_named("result") != nullptr) {
    reader_.fail(file.place,
                 "a quantity is named 'result', as is what the program gives; rename it");
  }
  run.program.flags.insert(run.program.flags.end(), run_.flags.begin(), run_.flags.end());
  const auto [frame, against] = cut_at_word(rest, "against");
  if (against.empty() != run.position.empty() ||
      (!against.empty() && against.text != "own position")) {
    reader_.fail(against.place,
                 "a comparison with own positions has 'against own position' here and a row "
                 "'position EXPRESSION'");
  }
  RunAnswer answered;
  std::size_t columns = 0;
  if (against.empty()) {
    const ExpectedMatrix expected = expected_matrix(frame);
    DerivedReference reference(points_, expected, run.rounding);
    answered = audit_run(points_, expected, reference, run, run_.limits);
    columns = expected.size.columns;
  } else {
    const OwnDerivatives own = own_derivatives(frame);
    OwnPosition reference(reader_.system(), own, run, run_.limits);
    answered = audit_run(points_, own.expected, reference, run, run_.limits);
    columns = own.expected.size.columns;
  }
  answer("run " + label.text + " (" + file.text + ")", label.place, columns,
         std::move(answered.findings));
  statements_.back().remark = answered.remark;
}

void Auditor::read_printed_equation(const closures::PlacedText& label, closures::PlacedText rest) {
  closures::PlacedText loops;
  if (closures::take_keyword(rest, "for")) {
    std::tie(loops, rest) = closures::cut(rest, ':');
  } else if (!rest.empty() && rest.text[0] == ':') {
    rest = closures::trimmed({rest.text.substr(1), rest.at(2)});
  }
  const auto [left, right] = closures::cut(rest, '=');
  std::vector<closures::LocalNames> cases = {{}};
  for (const closures::PlacedText& loop :
       loops.empty() ? std::vector<closures::PlacedText>{} : closures::split(loops, ',')) {
    const auto [variable, list] = cut_at_word(loop, "in");
    reader_.expect_new(variable);
    const std::vector<std::string> names = reader_.known_names(list, false);
    const std::size_t count = cases.size() * names.size();
    const bool many = count > most_cases;
    if (many || count * (left.text.size() + right.text.size()) > most_letters_of_cases) {
      reader_.fail(loops.place, "the names make more than " +
                                    (many ? std::to_string(most_cases) + " equations"
                                          : std::to_string(most_letters_of_cases) + " letters") +
                                    " of this one; leave some out");
    }
    std::vector<closures::LocalNames> more;
    for (const closures::LocalNames& one : cases) {
      for (const std::string& name : names) {
        more.push_back(one);
        more.back().stands_for[variable.text] = name;
      }
    }
    cases = more;
  }
  std::vector<Finding> findings;
  for (const closures::LocalNames& one : cases) {
    std::string item;
    for (const auto& [variable, name] : one.stands_for) {
      item += (item.empty() ? "" : ", ") + variable + " = " + name;
    }
    findings.push_back(audit_equation(points_, item, left, right, one));
    findings.back().place = reader_.place_in_file(findings.back().place);
  }
  answer("equation " + label.text, label.place, 0, std::move(findings));
}

void Auditor::read_printed_kinds(const closures::Statement& statement,
                                 const closures::PlacedText& label, closures::PlacedText rest) {
  if (!closures::take_keyword(rest, "of")) {
    reader_.fail(rest.place, "expected 'printed kinds LABEL of GROUP'");
  }
  const structure::Group& group = group_by_name(rest);
  if (statement.rows.empty()) {  // there is nothing to compare
    reader_.fail(statement.head.place, "expected rows 'NUMBER : KIND, KIND, ... [: FAMILY]'");
  }
  answer("kinds " + label.text, label.place, 0, audit_kinds(group, statement.rows, reader_.file()));
}

void Auditor::read_printed_number(const closures::PlacedText& rest) {
  const auto [head, formula] = cut_at_word(rest, "is");
  const auto [left, right] = closures::cut(head, '=');
  std::vector<closures::PlacedText> names = closures::words(left);
  closures::PlacedText unit = right;
  const closures::PlacedText number = closures::take_word(unit);
  if (formula.empty() || right.empty() || names.empty()) {
    reader_.fail(rest.place, "expected 'printed number [LABEL] NAME = NUMBER [UNIT] is FORMULA'");
  }
  const closures::PlacedText name = names.back();
  reader_.expect_new(name);
  Finding finding = numbers_.audit(name.text, number, formula);
  reader_.reserve(name.text);
  finding.item += unit.empty() ? "" : ", " + unit.text;
  answer("number " + (names.size() > 1 ? names[0].text : name.text), name.place, 0, {finding});
}

}  // namespace assur::generator::audit
