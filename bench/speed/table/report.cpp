#include "table/report.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "table/chart.hpp"
#include "table/targets.hpp"

namespace assur::speed {

namespace {

std::string text(const char* format, double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

/// Three digits, never in powers of ten.
std::string time_text(double ns) { return text(ns < 10 ? "%.2f" : ns < 100 ? "%.1f" : "%.0f", ns); }

std::string error_text(double error) { return std::isfinite(error) ? text("%.1e", error) : "-"; }

std::ofstream opened(const std::filesystem::path& path) {
  std::ofstream out(path);
  if (!out) {
    throw std::runtime_error("cannot write " + path.string());
  }
  return out;
}

/// One line per row, so that a changed figure is a changed line.
void write_json(const std::vector<Task>& tasks, std::ostream& out) {
  out << "[";
  const char* separator = "\n";
  for (const Task& task : tasks) {
    for (const Entry& entry : task.entries) {
      const Row& row = entry.row;
      nlohmann::ordered_json line;
      line["task"] = row.task;
      line["method"] = row.method;
      line["scalar"] = row.scalar;
      // Three digits; a quiet machine repeats two.
      line["ns"] = std::stod(text("%.3g", row.ns));
      const auto number = [](double error) {
        return std::isfinite(error) ? nlohmann::ordered_json(std::stod(text("%.2g", error)))
                                    : nlohmann::ordered_json(nullptr);
      };
      line["error"] = number(row.error);
      line["error_999"] = number(row.error_999);
      line["failures"] = row.failures;
      line["inputs"] = row.evaluated;
      if (row.unreported) {
        line["unreported"] = *row.unreported;
      }
      out << separator << line.dump();
      separator = ",\n";
    }
  }
  out << "\n]\n";
}

/// The verdict on a target, from a ratio divided by it.
std::string verdict(double share) {
  return share <= 1  ? "met"
         : share < 2 ? "missed by " + text("%.2g", 100 * (share - 1)) + " %"
                     : "missed by a factor of " + text("%.2f", share);
}

void write_targets(const std::vector<Task>& tasks, std::ostream& out) {
  out << "| task | ours | against | ratio of | target | measured | "
         "|\n|---|---|---|---|---|---|---|\n";
  for (const Target& target : targets()) {
    const Row* ours = find_row(tasks, target.task, target.method);
    const Row* peer = find_row(tasks, target.task, target.peer);
    out << "| " << target.task << " | " << target.method << " | " << target.peer << " | "
        << (target.measure == Measure::time ? "times" : "99.9th percentiles") << " | "
        << text("%.4g", target.at_most) << " | ";
    if (ours == nullptr || peer == nullptr) {
      out << "- | not measured: not in this run, or the peer is not installed |\n";
      continue;
    }
    const double ratio = measured(target, *ours, *peer);
    out << text("%.3g", ratio) << " | " << verdict(ratio / target.at_most) << " |\n";
  }
}

void write_rows(const std::vector<Task>& tasks, std::ostream& out) {
  for (const Task& task : tasks) {
    out << "\n### " << task.name << "\n\n"
        << "| method | scalar | ns | largest error | 99.9th percentile | failures | inputs |\n"
           "|---|---|---|---|---|---|---|\n";
    for (const Entry& entry : task.entries) {
      const Row& row = entry.row;
      out << "| " << row.method << " | " << row.scalar << " | " << time_text(row.ns) << " | "
          << error_text(row.error) << " | " << error_text(row.error_999) << " | " << row.failures
          << (row.unreported ? " (" + std::to_string(*row.unreported) + " unreported)" : "")
          << " | " << row.evaluated << " |\n";
    }
  }
}

}  // namespace

void write_report(const std::vector<Task>& tasks, const std::filesystem::path& directory) {
  std::ofstream json = opened(directory / "speed_accuracy.json");
  write_json(tasks, json);
  std::ofstream markdown = opened(directory / "speed_accuracy.md");
  markdown << "## Targets\n\n";
  write_targets(tasks, markdown);
  markdown << "\n## All rows\n";
  write_rows(tasks, markdown);
  std::ofstream columns = opened(directory / "speed_accuracy.dat");
  write_chart_columns(tasks, columns);
  std::ofstream summary = opened(directory / "speed_summary.dat");
  write_summary_columns(tasks, summary);
}

}  // namespace assur::speed
