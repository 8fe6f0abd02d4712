#include "audit/source_lines.hpp"

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

std::size_t first_byte_outside_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t ahead) {
      return at + ahead < text.size() ? static_cast<unsigned char>(text[at + ahead]) : 0U;
    };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    bool valid = length > 0;
    for (std::size_t ahead = 1; ahead < length; ++ahead) {
      valid = valid && (byte(ahead) & 0xC0U) == 0x80U;
    }
    // Longer spellings than need be, halves of pairs, and what is behind the last letter.
    valid = valid && !(first == 0xE0 && byte(1) < 0xA0) && !(first == 0xED && byte(1) > 0x9F) &&
            !(first == 0xF0 && byte(1) < 0x90) && !(first == 0xF4 && byte(1) > 0x8F);
    if (!valid) {
      return at;
    }
    at += length;
  }
  return text.size();
}

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
