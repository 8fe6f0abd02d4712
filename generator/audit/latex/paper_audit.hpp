// Audits the equations of a paper in LaTeX, read by a map of its notation.
#pragma once

#include "audit/finding.hpp"

namespace assur::generator::audit::latex {

/// Audits the displayed equations of a paper. Throws InputError for a file that cannot be used; an
/// equation that cannot be read is a finding.
[[nodiscard]] AuditReport audit_paper(const std::string& paper, const std::string& map);
/// Audits text in the same way; the files' names are for messages.
[[nodiscard]] AuditReport audit_paper_text(const std::string& paper, const std::string& paper_file,
                                           const std::string& map, const std::string& map_file);

}  // namespace assur::generator::audit::latex
