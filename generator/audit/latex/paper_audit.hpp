// Turns a paper in LaTeX and the map of its notation into a report: what its equations say against
// what is derived.
#pragma once

#include "audit/finding.hpp"

namespace assur::generator::audit::latex {

/// Audits the displayed equations of a paper. Throws InputError for a file that cannot be used; an
/// equation that cannot be read is a finding.
[[nodiscard]] AuditReport audit_paper(const std::string& paper, const std::string& map);
/// Audits text in the same way, with the files' names for messages.
[[nodiscard]] AuditReport audit_paper_text(const std::string& paper, const std::string& paper_file,
                                           const std::string& map, const std::string& map_file);

}  // namespace assur::generator::audit::latex
