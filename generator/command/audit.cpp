#include "command/audit.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <sstream>

#include "audit/audit.hpp"
#include "audit/audit_report.hpp"
#include "audit/latex/paper_audit.hpp"
#include "audit/scene/scene_values.hpp"
#include "command/output.hpp"
#include "command/progress.hpp"

namespace assur::generator::command {

bool run_audit(const AuditOptions& options) {
  audit::RunPermission run;
  run.given = options.run;
  run.limits.seconds = options.seconds;
  std::istringstream flags(options.flags);
  for (std::string flag; flags >> flag;) {
    run.flags.push_back(flag);
  }
  std::vector<audit::AuditReport> reports;
  ProgressBar bar;
  const auto show = [&bar](std::uint64_t done, std::uint64_t count) { bar.show(done, count); };
  for (const std::string& file : options.files) {
    if (options.map.empty() && file.ends_with(".tex")) {
      throw text::InputError(file + ": say what its notation stands for, in a file: --map FILE");
    }
    if (!options.map.empty() && file.ends_with(".audit")) {
      throw text::InputError(file + ": a map belongs to a paper (.tex); leave --map out");
    }
    reports.push_back(options.map.empty()
                          ? audit::audit_file(file, audit::scene::scene_values, run, show)
                          : audit::latex::audit_paper(file, options.map));
  }
  print(options.format == "json"       ? audit::audit_report_json(reports)
        : options.format == "markdown" ? audit::audit_report_markdown(reports)
        : options.format == "github"   ? audit::audit_report_github(reports)
                                       : audit::audit_report_text(reports));
  return std::all_of(reports.begin(), reports.end(),
                     [](const audit::AuditReport& report) { return report.agrees(); });
}

}  // namespace assur::generator::command
