// The tasks of the table with the errors of every method; the times are filled in later.
#pragma once

#include "table/row.hpp"

namespace assur::speed {

struct TaskSizes {
  std::size_t inputs = 10000;
  std::size_t near_singular = 2000;
  std::size_t phc_inputs = 20;  ///< positions that PHCpack solves, a process each
};

[[nodiscard]] std::vector<Task> derivative_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> position_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> tracking_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> scene_tasks();
[[nodiscard]] std::vector<Task> sweep_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> batch_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> everyday_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> force_tasks(const TaskSizes& sizes);
[[nodiscard]] std::vector<Task> group_tasks(const TaskSizes& sizes);

}  // namespace assur::speed
