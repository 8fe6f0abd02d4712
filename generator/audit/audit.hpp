// Turns audit files into reports: what a source prints against what the derivation says.
#pragma once

#include "audit/finding.hpp"

namespace assur::generator {

/// Reads and audits one file; docs/audit_format.md tells its form. Other files that it names are
/// found from its own directory. Throws InputError with the place of what cannot be used; a printed
/// formula that cannot be read is a finding.
[[nodiscard]] AuditReport audit_file(const std::string& file);
/// The same from text; `file` is its name in messages.
[[nodiscard]] AuditReport audit_text(const std::string& text, const std::string& file);

}  // namespace assur::generator
