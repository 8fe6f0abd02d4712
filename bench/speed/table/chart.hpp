// The columns that speed_accuracy.gp draws.
#pragma once

#include <ostream>
#include <vector>

#include "table/row.hpp"

namespace assur::speed {

/// A block per task, a line per row: ns, error, failures, label, family, scalar, task, height of
/// the label, lowest and highest error of the panel. Families and scalars are numbered as in the
/// chart's legend.
void write_chart_columns(const std::vector<Task>& tasks, std::ostream& out);
/// The same for the four main tasks, with at most eight methods each.
void write_summary_columns(const std::vector<Task>& tasks, std::ostream& out);

}  // namespace assur::speed
