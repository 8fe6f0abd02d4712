// The command `assur audit`: audits, and drafts of audit files.
#include "audit/audit.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/input_file.hpp>
#include <filesystem>
#include <sstream>

#include "audit/audit_report.hpp"
#include "audit/init/draft.hpp"
#include "audit/latex/paper_audit.hpp"
#include "audit/scene/scene_values.hpp"
#include "campaign/partial_file.hpp"
#include "command/commands.hpp"
#include "command/output.hpp"

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
    const std::string& filled = options.map.empty() ? file : options.map;
    audit::init::expect_filled_in(text::read_input_file(filled), filled);
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

void draft_audit(const AuditOptions& options) {
  if (options.files.size() != 1) {
    throw text::InputError("--init writes one audit file; give one program or paper");
  }
  const std::string& file = options.files[0];
  const std::filesystem::path output = options.output;
  if (output.empty()) {
    print(audit::init::draft_of(file, file));
    return;
  }
  campaign::expect_writable(output);
  campaign::expect_other(output, {file});
  campaign::expect_new(output, options.force);
  // File names in an audit file are relative to its directory.
  const std::filesystem::path directory = std::filesystem::absolute(output).parent_path();
  std::error_code none;
  const std::filesystem::path named = std::filesystem::relative(file, directory, none);
  const std::string draft = audit::init::draft_of(file, none ? file : named.string());
  campaign::PartialFile written(output);
  written.write(draft);
  written.flush();
  campaign::PartialFile::take_names({&written});
}

}  // namespace assur::generator::command
