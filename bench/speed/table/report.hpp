// Writes measured rows as JSON, Markdown tables and the columns of the chart.
#pragma once

#include <filesystem>

#include "table/row.hpp"

namespace assur::speed {

/// Writes speed_accuracy.json, speed_accuracy.md (targets, then all rows) and the chart's columns
/// into the directory.
void write_report(const std::vector<Task>& tasks, const std::filesystem::path& directory);

}  // namespace assur::speed
