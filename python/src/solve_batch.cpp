// Solutions for arrays of parameter values, as rows of configurations.
#include <pybind11/stl.h>

#include <algorithm>
#include <assur/mechanism/continuation.hpp>
#include <assur/text/counts.hpp>
#include <cstdint>

#include "arrays.hpp"
#include "errors.hpp"
#include "following.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "pickling.hpp"
#include "results.hpp"
#include "tables.hpp"

namespace assur::python {

namespace {

using mechanism::ParameterIndex;

/// The status of an item whose values cannot be solved; mechanism::SolutionStatus has the others.
constexpr std::uint8_t refused = 3;

/// Adds an item, with a row for each of its configurations.
void add_item(const mechanism::Plan& plan, const Columns& columns, py::ssize_t item,
              mechanism::Values& values, mechanism::Solution& solution, Rows& rows,
              SolvedBatch& batch) {
  values.set(columns.row(item));
  plan.solve(values, solution);
  batch.status.push_back(static_cast<std::uint8_t>(solution.status));
  batch.gap.push_back(solution.configurations.empty() ? 1 : 0);
  batch.offsets.push_back(static_cast<std::int64_t>(rows.count()));
  if (item == 0) {
    rows.reserve(static_cast<std::size_t>(columns.count) * solution.configurations.size());
  }
  std::int64_t number = 0;
  for (const mechanism::Configuration& configuration : solution.configurations) {
    rows.add(configuration, values);
    batch.item.push_back(item);
    batch.configuration.push_back(++number);
  }
}

std::shared_ptr<SolvedBatch> solve_all(const SharedPlan& planned, const Columns& columns) {
  auto batch = std::make_shared<SolvedBatch>();
  const auto rows = std::make_shared<Rows>(planned->plan, planned->layout);
  LongCall call;
  in_scene(planned->scene->file, [&] {
    mechanism::Values values = planned->plan.values();
    mechanism::Solution solution;
    batch->status.reserve(static_cast<std::size_t>(columns.count));
    for (py::ssize_t item = 0; item < columns.count; ++item) {
      call.go_on();
      try {
        add_item(planned->plan, columns, item, values, solution, *rows, *batch);
      } catch (const mechanism::MechanismError& error) {
        throw mechanism::MechanismError("values[" + std::to_string(item) + "]", error.what());
      }
    }
    batch->offsets.push_back(static_cast<std::int64_t>(rows->count()));
  });
  batch->rows = rows;
  return batch;
}

/// Computes the rows of one branch through the items.
class BatchFollower {
 public:
  BatchFollower(const SharedPlan& planned, const Columns& columns, const Following& following)
      : planned_(planned),
        columns_(columns),
        following_(following),
        changing_(changing()),
        branches_(planned->scene->mechanism, planned->scene->request, changing_),
        values_(branches_.plan().values()),
        rows_(std::make_shared<Rows>(planned->plan, planned->layout)) {
    begin_at_place();
  }

  std::shared_ptr<SolvedBatch> run(LongCall& call) {
    rows_->reserve(static_cast<std::size_t>(columns_.count));
    for (py::ssize_t item = 0; item < columns_.count; ++item) {
      call.go_on();
      add(item);
    }
    batch_->offsets.push_back(columns_.count);
    batch_->rows = rows_;
    batch_->last = last_place();
    return batch_;
  }

 private:
  /// The parameters that have an array, or a different value at the start of the branch.
  [[nodiscard]] std::vector<ParameterIndex> changing() const {
    std::vector<ParameterIndex> result;
    for (const Columns::Column& column : columns_.columns) {
      if (column.stride != 0 || std::holds_alternative<Place>(following_)) {
        result.push_back(column.parameter);
      }
    }
    if (const Place* const place = std::get_if<Place>(&following_)) {
      for (const auto& [name, value] : place->replaced) {
        const ParameterIndex parameter = planned_->plan.mechanism().parameter_named(name);
        if (std::ranges::find(result, parameter) == result.end()) {
          result.push_back(parameter);
        }
      }
    }
    return result;
  }

  void begin_at_place() {
    const Place* const place = std::get_if<Place>(&following_);
    if (place == nullptr) {
      return;
    }
    std::vector<std::pair<ParameterIndex, double>> at;
    for (const ParameterIndex parameter : changing_) {
      at.emplace_back(parameter, values_.parameter(parameter));
    }
    unchanged_ = at;
    for (const auto& [name, value] : place->replaced) {
      const ParameterIndex parameter = planned_->plan.mechanism().parameter_named(name);
      std::ranges::find(at, parameter, [](const auto& one) { return one.first; })->second = value;
    }
    values_.set(at);
    branches_.solve(values_);
    last_ = place->number - 1;
    branches_.go_to();
    has_begun_ = true;
  }

  /// The values of an item; a parameter that the items do not name has its own value.
  [[nodiscard]] std::vector<std::pair<ParameterIndex, double>> row(py::ssize_t item) const {
    std::vector<std::pair<ParameterIndex, double>> row = columns_.row(item);
    for (const auto& one : unchanged_) {
      if (std::ranges::find(row, one.first, [](const auto& other) { return other.first; }) ==
          row.end()) {
        row.push_back(one);
      }
    }
    return row;
  }

  void add(py::ssize_t item) {
    batch_->item.push_back(item);
    batch_->offsets.push_back(item);
    std::string reason;
    try {
      values_.set(row(item));
      const mechanism::Solution& solution = branches_.solve(values_);
      batch_->status.push_back(static_cast<std::uint8_t>(solution.status));
      if (const std::optional<std::size_t> place = place_in(solution)) {
        rows_->add(solution.configurations[*place], values_);
        batch_->gap.push_back(0);
        batch_->configuration.push_back(static_cast<std::int64_t>(*place) + 1);
        return;
      }
      reason = reason_of(solution);
    } catch (const mechanism::MechanismError& error) {
      batch_->status.resize(static_cast<std::size_t>(item), 0);
      batch_->status.push_back(refused);
      reason = error.what();
    }
    rows_->add_gap();
    batch_->gap.push_back(1);
    batch_->configuration.push_back(0);
    batch_->reasons.emplace(item, reason);
  }

  /// The configuration of the branch in the last solution.
  [[nodiscard]] std::optional<std::size_t> place_in(const mechanism::Solution& solution) {
    std::optional<std::size_t> place;
    if (has_begun_) {
      place = branches_.next()[last_];
    } else if (const std::size_t* const number = std::get_if<std::size_t>(&following_)) {
      place = *number <= solution.configurations.size() ? std::optional(*number - 1) : std::nullopt;
    } else if (const auto nearest = branches_.plan().nearest(values_, solution)) {
      place = nearest->configuration;
    }
    if (place && branches_.go_to()) {
      has_begun_ = true;
      last_ = *place;
    }
    return place;
  }

  /// The start for a later batch.
  [[nodiscard]] std::optional<Place> last_place() const {
    const auto gap = std::ranges::find(batch_->gap.rbegin(), batch_->gap.rend(), 0);
    if (gap == batch_->gap.rend()) {
      return std::nullopt;
    }
    const auto item = batch_->gap.rend() - gap - 1;
    Place last{{}, static_cast<std::size_t>(batch_->configuration[static_cast<std::size_t>(item)])};
    for (const auto& [parameter, value] : row(item)) {
      last.replaced.emplace_back(planned_->plan.mechanism().parameters()[parameter].name, value);
    }
    return last;
  }

  [[nodiscard]] std::string reason_of(const mechanism::Solution& solution) const {
    if (solution.configurations.empty()) {
      return solution.reason.empty() ? "the links cannot reach" : solution.reason;
    }
    if (has_begun_) {
      return "no configuration continues the branch";
    }
    const std::size_t* const number = std::get_if<std::size_t>(&following_);
    return "there is no configuration " + std::to_string(number == nullptr ? 1 : *number);
  }

  const SharedPlan& planned_;
  const Columns& columns_;
  const Following& following_;
  std::vector<ParameterIndex> changing_;
  mechanism::Continuation branches_;
  mechanism::Values values_;
  std::shared_ptr<Rows> rows_;
  std::shared_ptr<SolvedBatch> batch_ = std::make_shared<SolvedBatch>();
  std::vector<std::pair<ParameterIndex, double>> unchanged_;
  bool has_begun_ = false;
  std::size_t last_ = 0;  ///< the branch's configuration among the present ones
};

std::shared_ptr<SolvedBatch> solve_batch(const SharedPlan& planned, const py::object& given_values,
                                         py::kwargs keywords) {
  const std::optional<Following> following = following_given(*planned, keywords);
  const Columns columns = columns_of(planned->plan.mechanism(), given(given_values, keywords));
  std::shared_ptr<SolvedBatch> batch;
  if (following) {
    LongCall call;
    batch = in_scene(planned->scene->file, [&] {
      if (std::holds_alternative<NearestToReference>(*following)) {
        (void)planned->plan.nearest(planned->plan.values(), {});  // throws without a reference
      }
      return BatchFollower(planned, columns, *following).run(call);
    });
  } else {
    batch = solve_all(planned, columns);
  }
  batch->planned = planned;
  return batch;
}

/// A property that is a view of a vector of the batch.
template <typename Number>
auto all_of(std::vector<Number> SolvedBatch::*member) {
  return [member](const py::object& self) {
    return view_of(self.cast<const SolvedBatch&>().*member, self);
  };
}

std::string reason_of_item(const SolvedBatch& batch, const py::object& of) {
  const std::uint64_t item = whole_number(of, "item");
  if (item >= batch.status.size()) {
    throw py::index_error("item " + std::to_string(item) + ": the number of items is " +
                          std::to_string(batch.status.size()));
  }
  const auto reason = batch.reasons.find(static_cast<std::int64_t>(item));
  return reason == batch.reasons.end() ? std::string() : reason->second;
}

}  // namespace

void add_solve_batch(py::module_& module, PlanClass& plan) {
  py::class_<SolvedBatch, RowsView, std::shared_ptr<SolvedBatch>> batches(
      module, "Batch",
      "The configurations of many items, each of which is a set of values. The first axis of the\n"
      "arrays of links, joints and outputs has a row for each configuration of each item, item by\n"
      "item; of a batch that follows a branch, one row for each item.");
  batches
      .def_property_readonly("status", all_of(&SolvedBatch::status),
                             "Array of shape (items,): the Status of each item.")
      .def_property_readonly(
          "gap",
          [](const py::object& self) {
            const auto& gap = self.cast<const SolvedBatch&>().gap;
            return view(py::dtype::of<bool>(), {static_cast<py::ssize_t>(gap.size())}, {1},
                        gap.data(), self);
          },
          "Array of shape (items,): whether an item has no configuration; of a batch that follows "
          "a\n"
          "branch, whether the item is not on it. The numbers of its row then are NaN.")
      .def_property_readonly(
          "offsets", all_of(&SolvedBatch::offsets),
          "Array of shape (items + 1,): item i has the rows from offsets[i] to offsets[i + 1].")
      .def_property_readonly("item", all_of(&SolvedBatch::item),
                             "Array of shape (rows,): the item of each row, from 0.")
      .def_property_readonly(
          "configuration", all_of(&SolvedBatch::configuration),
          "Array of shape (rows,): the number of each configuration in its item, from 1; zero in a "
          "gap.")
      .def("reason", reason_of_item, py::arg("item"), py::pos_only(),
           "reason(self, item, /)\n--\n\n"
           "Returns the reason, as str, why an item, from 0, is not on the branch that the batch "
           "follows;\n"
           "empty where it is. Raises IndexError beyond the last item.")
      .def(
          "__len__", [](const SolvedBatch& batch) { return batch.status.size(); },
          "The number of items.");
  batches
      .def(py::pickle(
          [](const SolvedBatch& batch) {
            return py::make_tuple(
                batch.planned, rows_state(batch), bytes_of(batch.status), bytes_of(batch.gap),
                bytes_of(batch.item), bytes_of(batch.configuration), bytes_of(batch.offsets),
                batch.reasons,
                batch.last ? py::object(py::make_tuple(batch.last->replaced, batch.last->number))
                           : py::none());
          },
          [](const py::tuple& state) {
            auto batch = std::make_shared<SolvedBatch>();
            batch->planned = state[0].cast<SharedPlan>();
            batch->rows = rows_in(*batch->planned, state[1]);
            batch->status = numbers_in<std::uint8_t>(state[2]);
            batch->gap = numbers_in<std::uint8_t>(state[3]);
            batch->item = numbers_in<std::int64_t>(state[4]);
            batch->configuration = numbers_in<std::int64_t>(state[5]);
            batch->offsets = numbers_in<std::int64_t>(state[6]);
            batch->reasons = state[7].cast<std::map<std::int64_t, std::string>>();
            if (!state[8].is_none()) {
              const auto last = state[8].cast<py::tuple>();
              batch->last = Place{last[0].cast<Replaced>(), last[1].cast<std::size_t>()};
            }
            return batch;
          }))
      .def("to_frame", frame_of, frame_doc)
      .def("__repr__", [](const SolvedBatch& batch) {
        return "<assur.Batch: " + text::with_noun(batch.status.size(), "item") + ", " +
               text::with_noun(batch.item.size(), "row") + ", " +
               text::with_noun(static_cast<std::size_t>(std::ranges::count(batch.gap, 1)), "gap") +
               ">";
      });
  plan.def(
      "solve_batch", solve_batch, ByPlace("values ") = py::none(), py::pos_only(),
      "solve_batch(self, values=None, /, *, branch=None, nearest=False, from_=None, "
      "**parameters)\n--\n\n"
      "Returns the configurations of many sets of values, as a Batch: every one of each set, or, "
      "with\n"
      "branch, nearest or from_, one branch through all sets.\n\n"
      "values, and keywords: for parameters, by their names, arrays of one shape (items,), or "
      "numbers\n"
      "that all items share. Arrays of doubles are read without a copy. The mapping alone takes\n"
      "parameters that are named branch, nearest or from_.\n"
      "branch: the number of a configuration, from 1; the branch begins with it, at the first item "
      "that\n"
      "has it. nearest: it begins with the configuration nearest to the scene's reference. from_: "
      "it\n"
      "continues a Configuration, or the last row of a Batch that follows a branch.\n\n"
      "A branch has one row for each item. An item is reached from the last regular one on the "
      "branch,\n"
      "along the straight line between their values; if the branch does not lead there, or the "
      "values\n"
      "cannot be solved, the row is a gap (see Batch.gap, Batch.reason), and nothing is raised.\n\n"
      "Raises ShapeError for arrays of other shapes, and without a branch as solve does, with the "
      "number\n"
      "of the item. Ctrl-C ends it.");
}

}  // namespace assur::python
