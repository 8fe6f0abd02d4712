#include "audit/audit.hpp"

#include <algorithm>
#include <assur/text/input_file.hpp>

#include "audit/auditor.hpp"
#include "audit/finding.hpp"

namespace assur::generator::audit {

namespace {

/// The closures that are printed with all signs reversed. The reversal applies to everything
/// printed, also before them, so they are found first.
std::set<std::string> turned_closures(const std::vector<closures::Statement>& statements,
                                      const std::string& file) {
  const SceneReader no_scenes;
  const RunPermission no_permission;
  Auditor auditor(file, no_scenes, no_permission);
  try {
    for (const closures::Statement& statement : statements) {
      auditor.read_signs(statement);
    }
  } catch (const text::InputError&) {
    return {};  // the audit meets the same error and reports it
  }
  return auditor.turned();
}

}  // namespace

bool AuditReport::agrees() const {
  return std::all_of(statements.begin(), statements.end(), [](const AuditedStatement& statement) {
    return std::all_of(statement.findings.begin(), statement.findings.end(),
                       [](const Finding& finding) { return finding.agrees(); });
  });
}

AuditReport audit_text(const std::string& text, const std::string& file, const SceneReader& scenes,
                       const RunPermission& run, const text::Progress& progress) {
  const std::vector<closures::Statement> statements = closures::parse_statements(text, file);
  Auditor auditor(file, scenes, run, turned_closures(statements, file));
  std::uint64_t done = 0;
  for (const closures::Statement& statement : statements) {
    auditor.read(statement);
    if (progress) {
      progress(++done, statements.size());
    }
  }
  AuditReport report = auditor.report();
  if (report.statements.empty()) {
    throw text::InputError(file + ": nothing to audit; say what the source prints with 'printed'");
  }
  quote_lines(report, text);
  return report;
}

AuditReport audit_file(const std::string& file, const SceneReader& scenes, const RunPermission& run,
                       const text::Progress& progress) {
  return audit_text(text::read_input_file(file), file, scenes, run, progress);
}

}  // namespace assur::generator::audit
