// Branches through the items of arrays of parameter values.
#include <assur/mechanism/continuation.hpp>

#include "errors.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "swept_rows.hpp"

namespace assur::python {

namespace {

class ItemSweeper {
 public:
  ItemSweeper(const SharedPlan& planned, const Columns& columns)
      : planned_(planned),
        columns_(columns),
        continuation_(planned->scene->mechanism, planned->scene->request, changing(columns)),
        values_(continuation_.plan().values()) {
    result_.parameter = "item";
    result_.unassigned = begun<Branch>(0);
    result_.events = begun<Events>(0);
  }

  SweptScene run(LongCall& call) && {
    for (py::ssize_t item = 0; item < columns_.count; ++item) {
      call.go_on();
      add(item);
    }
    for (auto& [number, branch] : result_.branches) {
      if (branch->step.back() + 1 < columns_.count) {
        branch->ends_at = branch->parameter.back();
      }
    }
    return std::move(result_);
  }

 private:
  static std::vector<mechanism::ParameterIndex> changing(const Columns& columns) {
    std::vector<mechanism::ParameterIndex> result;
    for (const Columns::Column& column : columns.columns) {
      if (column.stride != 0) {
        result.push_back(column.parameter);
      }
    }
    return result;
  }

  template <typename Kind>
  std::shared_ptr<Kind> begun(int number) {
    auto branch = std::make_shared<Kind>();
    branch->planned = planned_;
    rows_.push_back(std::make_shared<Rows>(planned_->plan, planned_->layout));
    branch->rows = rows_.back();
    if constexpr (std::is_same_v<Kind, Branch>) {
      branch->number = number;
      rows_of_[number] = rows_.back().get();
    }
    return branch;
  }

  void add(py::ssize_t item) {
    try {
      values_.set(columns_.row(item));
      add_rows(item, continuation_.solve(values_));
    } catch (const mechanism::MechanismError& error) {
      throw mechanism::MechanismError("values[" + std::to_string(item) + "]", error.what());
    }
  }

  void add_rows(py::ssize_t item, const mechanism::Solution& solution) {
    std::vector<int> numbers(solution.configurations.size(), 0);
    const mechanism::Continuation::Next next = continuation_.next();
    for (std::size_t place = 0; place < next.size(); ++place) {
      if (next[place]) {
        numbers[*next[place]] = here_[place];
      }
    }
    if (!solution.configurations.empty() && continuation_.go_to()) {
      for (int& number : numbers) {
        if (number == 0) {
          number = static_cast<int>(result_.branches.size()) + 1;
          result_.branches[number] = begun<Branch>(number);
        }
      }
      here_ = numbers;
    }
    for (std::size_t place = 0; place < numbers.size(); ++place) {
      const int number = numbers[place];
      Branch& branch = number == 0 ? *result_.unassigned : *result_.branches.at(number);
      rows_of_.at(number)->add(solution.configurations[place], values_);
      branch.step.push_back(static_cast<std::int32_t>(item));
      branch.configuration.push_back(static_cast<std::int32_t>(place) + 1);
      branch.parameter.push_back(static_cast<double>(item));
    }
  }

  const SharedPlan& planned_;
  const Columns& columns_;
  mechanism::Continuation continuation_;
  mechanism::Values values_;
  SweptScene result_;
  std::vector<std::shared_ptr<Rows>> rows_;
  std::map<int, Rows*> rows_of_;  ///< by branch number
  std::vector<int> here_;         ///< the branches of the present configurations
};

}  // namespace

SweptScene swept_through_items(const SharedPlan& planned, const Given& given) {
  const Columns columns = columns_of(planned->plan.mechanism(), given);
  LongCall call;
  return in_scene(planned->scene->file, [&] { return ItemSweeper(planned, columns).run(call); });
}

}  // namespace assur::python
