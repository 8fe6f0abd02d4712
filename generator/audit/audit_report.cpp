#include "audit/audit_report.hpp"

#include <algorithm>
#include <assur/text/json.hpp>

namespace assur::generator::audit {

namespace {

using text::Json;

std::size_t agreeing(const AuditedStatement& statement) {
  std::size_t count = 0;
  for (const Finding& finding : statement.findings) {
    count += finding.agrees() ? 1 : 0;
  }
  return count;
}

std::string counted(std::size_t agree, std::size_t all) {
  return agree == all ? (all == 1 ? "agrees" : "all " + std::to_string(all) + " agree")
                      : std::to_string(agree) + " of " + std::to_string(all) + " agree";
}

/// The number of findings that agree, and the branch on which all others hold if there is one.
std::string counted(const AuditedStatement& statement) {
  const std::size_t agree = agreeing(statement);
  std::string branch;
  for (const Finding& finding : statement.findings) {
    const std::string& one = finding.comparison.branch;
    if (finding.agrees()) {
      continue;
    }
    if (one.empty() || (!branch.empty() && branch != one)) {
      return counted(agree, statement.findings.size());
    }
    branch = one;
  }
  return branch.empty() ? counted(agree, statement.findings.size())
         : agree == 0   ? branch
                        : counted(agree, statement.findings.size()) + ", the rest " + branch;
}

/// One letter for each entry of a matrix, so that the wrong ones are seen at a glance.
char mark(const Finding& finding) {
  switch (finding.comparison.verdict) {
    case Verdict::agrees:
      return '.';
    case Verdict::differs_by_sign:
      return '-';
    case Verdict::differs:
      return 'x';
    case Verdict::on_one_branch:
      return '/';
    case Verdict::unreadable:
      return '!';
    case Verdict::fails:
      return '#';
    case Verdict::undecided:
      break;
  }
  return '?';
}

std::string place_text(const std::string& file, closures::Place place) {
  return file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

/// The line with a mark under the place; empty if the line is unknown.
std::string quoted_line(const Finding& finding) {
  if (finding.line.empty()) {
    return "";
  }
  constexpr std::size_t most = 160;
  const std::size_t column = finding.place.column - 1;
  // A long line is quoted only near the place.
  std::size_t from = column > most / 2 && finding.line.size() > most ? column - most / 2 : 0;
  const auto is_inside_a_letter = [&](std::size_t at) {
    return at > 0 && at < finding.line.size() && (finding.line[at] & 0xC0) == 0x80;
  };
  std::size_t to = std::min(from + most, finding.line.size());
  for (; is_inside_a_letter(from); --from) {
  }
  for (; is_inside_a_letter(to); --to) {
  }
  std::string under;
  for (std::size_t at = from; at < std::min(column, finding.line.size()); ++at) {
    if (!is_inside_a_letter(at)) {
      under += finding.line[at] == '\t' ? '\t' : ' ';
    }
  }
  return "    " + finding.line.substr(from, to - from) + "\n    " + under + "^\n";
}

/// The details of a disagreement, as pairs of a title and a text.
std::vector<std::pair<std::string, std::string>> details(const Finding& finding) {
  const Comparison& comparison = finding.comparison;
  std::vector<std::pair<std::string, std::string>> lines;
  const auto add = [&](const char* word, const std::string& text) {
    if (!text.empty()) {
      lines.emplace_back(word, text);
    }
  };
  add("printed", finding.printed);
  add("derived", finding.derived);
  add("difference", comparison.difference);
  add("at", comparison.point);
  const bool unanswered = comparison.verdict == Verdict::unreadable ||
                          comparison.verdict == Verdict::undecided ||
                          comparison.verdict == Verdict::on_one_branch;
  add("because", unanswered ? comparison.evidence : "");
  add("note", finding.note);
  return lines;
}

std::string statement_text(const AuditReport& report, const AuditedStatement& statement) {
  const std::size_t agree = agreeing(statement);
  const std::string& file = statement.file.empty() ? report.file : statement.file;
  const bool computed = std::ranges::any_of(
      statement.findings, [](const Finding& one) { return one.comparison.is_computed; });
  std::string text = statement.label + ": " + counted(statement) +
                     (computed ? ", at " + closures::computed_sort : "") +
                     (statement.remark.empty() ? "" : ", " + statement.remark) + "\n";
  if (agree == statement.findings.size()) {
    return text;
  }
  if (statement.columns > 0) {
    for (std::size_t place = 0; place < statement.findings.size(); ++place) {
      text += place % statement.columns == 0 ? "    " : " ";
      text += mark(statement.findings[place]);
      text += (place + 1) % statement.columns == 0 ? "\n" : "";
    }
  }
  // Cases of one equation, and entries of a program, that fail in the same way are reported in full
  // only once.
  const Finding* told = nullptr;
  for (const Finding& finding : statement.findings) {
    if (finding.agrees()) {
      continue;
    }
    const bool fails = finding.comparison.verdict == Verdict::fails;
    const bool alike = told != nullptr && finding.printed == told->printed &&
                       (fails || finding.derived == told->derived) && finding.note == told->note &&
                       finding.comparison.verdict == told->comparison.verdict;
    text += "  " + finding.item + (finding.item.empty() ? "" : ": ") +
            verdict_text(finding.comparison.verdict) +
            (alike ? " likewise\n" : " (" + place_text(file, finding.place) + ")\n");
    if (alike) {
      continue;
    }
    told = &finding;
    text += quoted_line(finding);
    for (const auto& [word, detail] : details(finding)) {
      text += "    " + word + std::string(12 - word.size(), ' ') + detail + "\n";
    }
  }
  return text;
}

std::pair<std::size_t, std::size_t> totals(const AuditReport& report) {
  std::size_t agree = 0;
  std::size_t all = 0;
  for (const AuditedStatement& statement : report.statements) {
    agree += agreeing(statement);
    all += statement.findings.size();
  }
  return {agree, all};
}

/// Text escaped for GitHub's workflow commands; a property may not contain ':' or ','.
std::string escaped(const std::string& text, bool property) {
  std::string result;
  for (const char letter : text) {
    const bool special = letter == '%' || letter == '\n' || letter == '\r' ||
                         (property && (letter == ':' || letter == ','));
    result += special ? letter == '%'    ? "%25"
                        : letter == '\n' ? "%0A"
                        : letter == '\r' ? "%0D"
                        : letter == ':'  ? "%3A"
                                         : "%2C"
                      : std::string(1, letter);
  }
  return result;
}

std::string in_cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) {
    text.replace(at, 1, "\\|");
  }
  return text.empty() ? "" : "`" + text + "`";
}

}  // namespace

std::string audit_report_text(const std::vector<AuditReport>& reports) {
  std::string text;
  for (const AuditReport& report : reports) {
    const auto [agree, all] = totals(report);
    text += report.file + (report.source.empty() ? "" : ": " + report.source) + "\n";
    for (const AuditedStatement& statement : report.statements) {
      text += statement_text(report, statement);
    }
    text += "in all: " + counted(agree, all) + "\n";
  }
  return text;
}

std::string audit_report_markdown(const std::vector<AuditReport>& reports) {
  std::string text;
  for (const AuditReport& report : reports) {
    const auto [agree, all] = totals(report);
    text += "## " + (report.source.empty() ? report.file : report.source) + "\n\n" +
            counted(agree, all) + ".\n\n| what | agree |\n|---|---|\n";
    for (const AuditedStatement& statement : report.statements) {
      text += "| " + statement.label + " | " + std::to_string(agreeing(statement)) + " of " +
              std::to_string(statement.findings.size()) + " |\n";
    }
    if (agree == all) {
      continue;
    }
    text +=
        "\n| where | verdict | printed | derived | difference | note "
        "|\n|---|---|---|---|---|---|\n";
    for (const AuditedStatement& statement : report.statements) {
      for (const Finding& finding : statement.findings) {
        if (finding.agrees()) {
          continue;
        }
        const Comparison& comparison = finding.comparison;
        const std::string at = comparison.point.empty() ? "" : " at " + comparison.point;
        text += "| " + statement.label + " " + finding.item + " | " +
                verdict_text(comparison.verdict) + " | " + in_cell(finding.printed) + " | " +
                in_cell(finding.derived) + " | " + comparison.difference + at + " | " +
                finding.note + " |\n";
      }
    }
    text += "\n";
  }
  return text;
}

std::string audit_report_github(const std::vector<AuditReport>& reports) {
  std::string text;
  for (const AuditReport& report : reports) {
    for (const AuditedStatement& statement : report.statements) {
      const std::string& file = statement.file.empty() ? report.file : statement.file;
      for (const Finding& finding : statement.findings) {
        if (finding.agrees()) {
          continue;
        }
        std::string message = verdict_text(finding.comparison.verdict);
        for (const auto& [word, detail] : details(finding)) {
          message += std::string("\n") + word + ": " + detail;
        }
        text += "::error file=" + escaped(file, true) +
                ",line=" + std::to_string(finding.place.line) +
                ",col=" + std::to_string(finding.place.column) +
                ",title=" + escaped(statement.label + " " + finding.item, true) +
                "::" + escaped(message, false) + "\n";
      }
    }
    const auto [agree, all] = totals(report);
    text += report.file + ": " + counted(agree, all) + "\n";
  }
  return text;
}

std::string audit_report_json(const std::vector<AuditReport>& reports) {
  Json files = Json::array();
  bool agrees = true;
  for (const AuditReport& report : reports) {
    Json statements = Json::array();
    for (const AuditedStatement& statement : report.statements) {
      Json findings = Json::array();
      for (const Finding& finding : statement.findings) {
        const Comparison& comparison = finding.comparison;
        Json entry = {
            {"item", finding.item},           {"verdict", verdict_text(comparison.verdict)},
            {"line", finding.place.line},     {"column", finding.place.column},
            {"printed", finding.printed},     {"derived", finding.derived},
            {"evidence", comparison.evidence}};
        if (!comparison.difference.empty()) {
          entry["difference"] = comparison.difference;
        }
        if (!comparison.difference.empty() || !comparison.point.empty()) {
          entry["point"] = comparison.point;
        }
        if (!comparison.branch.empty()) {
          entry["branch"] = comparison.branch;
        }
        if (!finding.note.empty()) {
          entry["note"] = finding.note;
        }
        if (!finding.agrees() && !finding.line.empty()) {
          entry["text"] = finding.line;
        }
        findings.push_back(std::move(entry));
      }
      Json audited = {{"statement", statement.label}};
      if (!statement.file.empty()) {
        audited["file"] = statement.file;  // the lines and columns refer to it
      }
      if (!statement.remark.empty()) {
        audited["remark"] = statement.remark;
      }
      audited["findings"] = std::move(findings);
      statements.push_back(std::move(audited));
    }
    agrees = agrees && report.agrees();
    files.push_back({{"file", report.file},
                     {"source", report.source},
                     {"agrees", report.agrees()},
                     {"statements", std::move(statements)}});
  }
  return Json{{"agrees", agrees}, {"files", std::move(files)}}.dump() + "\n";
}

}  // namespace assur::generator::audit
