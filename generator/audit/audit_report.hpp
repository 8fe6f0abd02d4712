// Audit reports as text, as Markdown, as JSON, or as annotations for GitHub.
#pragma once

#include <string>
#include <vector>

#include "audit/finding.hpp"

namespace assur::generator::audit {

[[nodiscard]] std::string audit_report_text(const std::vector<AuditReport>& reports);
[[nodiscard]] std::string audit_report_markdown(const std::vector<AuditReport>& reports);
/// One `::error file=...,line=...,col=...::` for each finding that disagrees.
[[nodiscard]] std::string audit_report_github(const std::vector<AuditReport>& reports);
[[nodiscard]] std::string audit_report_json(const std::vector<AuditReport>& reports);

}  // namespace assur::generator::audit
