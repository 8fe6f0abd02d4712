#include "audit/finding.hpp"

#include <assur/text/input_file.hpp>
#include <sstream>

namespace assur::generator::audit {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) {
      line.pop_back();
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

void quote_lines(AuditReport& report, const std::string& text) {
  const std::vector<std::string> own = lines_of(text);
  for (AuditedStatement& statement : report.statements) {
    const std::vector<std::string> lines =
        statement.file.empty() ? own : lines_of(text::read_input_file(statement.file));
    for (Finding& finding : statement.findings) {
      if (finding.place.line >= 1 && finding.place.line <= lines.size()) {
        finding.line = lines[finding.place.line - 1];
      }
    }
  }
}

}  // namespace assur::generator::audit
