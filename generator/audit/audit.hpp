// Audits of files and text: what a source prints against what is derived.
#pragma once

#include <assur/text/progress.hpp>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "audit/finding.hpp"
#include "audit/running/program_values.hpp"

namespace assur::generator::audit {

/// Returns the values of one configuration of a scene file by name. `configuration` counts from 1;
/// `settings` (NAME=EXPR) replace parameters of the scene.
using SceneReader = std::function<std::map<std::string, double>(
    const std::string& file, int configuration, const std::vector<std::string>& settings)>;

/// Permission to run the programs that audit files name, and the settings for it.
struct RunPermission {
  bool given = false;
  std::vector<std::string> flags;  ///< in addition to those of the audit file
  running::RunLimits limits;
};

/// Reads and audits one file in the format of docs/reference/audit_format.md. Names of other files
/// in it are relative to its directory; `scenes` reads scenes. Throws InputError with the place of
/// an error; a printed formula that cannot be read is a finding. Progress counts statements.
[[nodiscard]] AuditReport audit_file(const std::string& file, const SceneReader& scenes,
                                     const RunPermission& run = {},
                                     const text::Progress& progress = {});
/// Audits text in the same way; `file` is its name in messages, and `scenes` may be empty.
[[nodiscard]] AuditReport audit_text(const std::string& text, const std::string& file,
                                     const SceneReader& scenes = {}, const RunPermission& run = {},
                                     const text::Progress& progress = {});

}  // namespace assur::generator::audit
