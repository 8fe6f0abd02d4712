// Turns the places of findings into the lines that stand there.
#pragma once

#include "audit/finding.hpp"

namespace assur::generator::audit {

/// Fills the findings' lines; `text` is that of the report's own file.
void quote_lines(AuditReport& report, const std::string& text);

}  // namespace assur::generator::audit
