// Turns the places of findings into the lines that stand there.
#pragma once

#include "audit/finding.hpp"

namespace assur::generator::audit {

/// The offset of the first byte that is not part of a letter in UTF-8; the text's size if all are.
[[nodiscard]] std::size_t first_byte_outside_utf8(const std::string& text);

/// Fills the findings' lines; `text` is that of the report's own file.
void quote_lines(AuditReport& report, const std::string& text);

}  // namespace assur::generator::audit
