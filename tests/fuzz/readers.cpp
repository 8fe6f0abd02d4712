#include "readers.hpp"

#include <assur/mechanism/imported_scene.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/error.hpp>
#include <assur/text/expression.hpp>
#include <stdexcept>

#include "audit/audit.hpp"
#include "audit/code/code_matrix.hpp"
#include "audit/code/tokens.hpp"
#include "audit/latex/paper_audit.hpp"
#include "closures/closure_reader.hpp"

namespace assur::test::fuzz {

using namespace generator;

namespace {

/// A refusal is one line; Error is the parser's exception.
template <typename Error, typename Read>
void expect_answer_or_line(const Read& read) {
  std::string line;
  try {
    read();
    return;
  } catch (const Error& error) {
    line = error.what();
  }
  if (line.empty() || line.find('\n') != std::string::npos) {
    throw std::logic_error("a refusal is not one line: '" + line + "'");
  }
}

/// The part of a text before the first line that is `divider`, and the part behind it.
std::pair<std::string, std::string> divided(const std::string& text, const std::string& divider) {
  const std::size_t at = text.find(divider);
  return at == std::string::npos ? std::pair(text, std::string())
                                 : std::pair(text.substr(0, at), text.substr(at + divider.size()));
}

/// The statements of an audit file that type closures.
closures::ClosureReader closures_of(const std::string& text) {
  closures::ClosureReader reader("fuzz.audit");
  for (const closures::Statement& statement : closures::parse_statements(text, "fuzz.audit")) {
    (void)reader.read(statement);
  }
  return reader;
}

}  // namespace

void read_scene_text(const std::string& text) {
  expect_answer_or_line<text::InputError>(
      [&] { (void)mechanism::parse_scene(text, "fuzz.json", {}); });
}

void read_import_text(const std::string& text) {
  // The written scene can be read, or is refused as one that cannot be built.
  expect_answer_or_line<text::InputError>([&] {
    (void)mechanism::parse_scene(mechanism::import_scene(text, "fuzz").text, "fuzz.json", {});
  });
}

void read_expression_text(const std::string& text) {
  expect_answer_or_line<text::ExpressionError>([&] {
    const text::Expression expression = text::parse_expression(text);
    if (text::is_constant(expression)) {
      (void)text::constant_value(expression);
    }
  });
}

void read_closures_text(const std::string& text) {
  expect_answer_or_line<text::InputError>([&] { (void)closures_of(text); });
}

void read_audit_text(const std::string& text) {
  expect_answer_or_line<text::InputError>([&] { (void)audit::audit_text(text, "fuzz.audit"); });
}

void read_code_text(const std::string& text) {
  const auto [language, code] = divided(text, "\n");
  closures::ClosureReader reader =
      closures_of("length l s\nangle q\nunknown q s\nclosure f = l*cos(q) - s\n");
  const audit::code::AuditedMatrix matrix{"J", 2, 2};
  expect_answer_or_line<audit::code::CodeError>([&, &language = language, &code = code] {
    (void)(language == "m" ? audit::code::read_matlab_matrix(code, matrix, reader.system())
                           : audit::code::read_cpp_matrix(code, matrix, reader.system()));
  });
}

void read_paper_text(const std::string& text) {
  const auto [paper, map] = divided(text, "\n---\n");
  expect_answer_or_line<text::InputError>([&paper = paper, &map = map] {
    (void)audit::latex::audit_paper_text(paper, "fuzz.tex", map, "fuzz.map");
  });
}

}  // namespace assur::test::fuzz
