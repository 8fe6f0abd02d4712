#include "audit/code_matrix.hpp"

#include <regex>

namespace assur::generator {

namespace {

/// Comments become spaces, so that places stay.
std::string without_comments(std::string code) {
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t at = from; at < to && at < code.size(); ++at) {
      code[at] = code[at] == '\n' ? '\n' : ' ';
    }
  };
  for (std::size_t at = 0; at + 1 < code.size(); ++at) {
    if (code.compare(at, 2, "//") == 0) {
      blank(at, std::min(code.find('\n', at), code.size()));
    } else if (code.compare(at, 2, "/*") == 0) {
      const std::size_t end = code.find("*/", at + 2);
      blank(at, end == std::string::npos ? code.size() : end + 2);
    }
  }
  return code;
}

/// The statements between ; { and }, on one line each.
std::vector<PlacedText> statements_of(const std::string& code) {
  std::vector<PlacedText> list;
  Place place{1, 1};
  PlacedText current;
  for (const char letter : code) {
    if (letter == ';' || letter == '{' || letter == '}') {
      list.push_back(trimmed(current));
      current = {};
    } else {
      if (current.text.empty() && std::isspace(static_cast<unsigned char>(letter)) == 0) {
        current.place = place;
      }
      if (!current.text.empty() || std::isspace(static_cast<unsigned char>(letter)) == 0) {
        current.text += letter == '\n' ? ' ' : letter;
      }
    }
    place = letter == '\n' ? Place{place.line + 1, 1} : Place{place.line, place.column + 1};
  }
  return list;
}

/// The formula that a C++ expression is. Columns move where something is skipped.
std::string as_formula(std::string code) {
  code = std::regex_replace(code, std::regex(R"(\bstd::)"), "");
  code = std::regex_replace(code, std::regex(R"((\w+)\s*\[\s*(\d+)\s*\])"), "$1_$2");
  return std::regex_replace(code, std::regex(R"(([A-Za-z_]\w*)\.([A-Za-z_]\w*))"), "$1_$2");
}

}  // namespace

std::vector<PrintedEntry> read_code_matrix(const std::string& code, const std::string& file,
                                           const std::string& array, std::size_t rows,
                                           std::size_t columns, ClosureSystem& system) {
  const std::regex entry_form(
      "^" + array +
      R"(\s*(?:\(\s*(\d+)\s*,\s*(\d+)\s*\)|\[\s*(\d+)\s*\]\s*\[\s*(\d+)\s*\])"
      R"()\s*=\s*([^=].*)$)");
  const std::regex other_form("^" + array + R"(\s*(\(|\[|<<|=|\+=|-=|\*=).*$)");
  const std::regex local_form(
      R"(^(?:(?:const|constexpr|auto|double|float|long)\s+)+(\w+)\s*=\s*(.*)$)");
  std::vector<PrintedEntry> entries(rows * columns);
  LocalNames locals;
  bool found = false;
  for (const PlacedText& statement : statements_of(without_comments(code))) {
    std::smatch match;
    if (std::regex_match(statement.text, match, local_form)) {
      const PlacedText formula{as_formula(match[2]), statement.place};
      try {
        locals.meanings[match[1]] = read_formula(formula, system, locals);
      } catch (const FormulaError&) {
        locals.meanings.erase(match[1]);  // an entry that uses it says that it is not known
      }
    } else if (std::regex_match(statement.text, match, entry_form)) {
      const auto index = [&](std::size_t one, std::size_t other) {
        return std::stoul(match[match[one].matched ? one : other]);
      };
      const std::size_t row = index(1, 3);
      const std::size_t column = index(2, 4);
      if (row >= rows || column >= columns) {
        throw AuditSyntaxError(file, statement.place,
                               array + " is audited as " + std::to_string(rows) + " by " +
                                   std::to_string(columns) + ", and this entry is outside");
      }
      found = true;
      entries[row * columns + column] = {{as_formula(match[5]), statement.place}, locals};
    } else if (std::regex_match(statement.text, match, other_form)) {
      throw AuditSyntaxError(
          file, statement.place,
          "cannot read this use of " + array + "; write " + array + "(i, j) = EXPRESSION");
    }
  }
  if (!found) {
    throw AuditSyntaxError(file, {1, 1}, "nothing is assigned to " + array);
  }
  return entries;
}

}  // namespace assur::generator
