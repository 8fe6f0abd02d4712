// Turns arrays of parameters' values into the configurations of all of them, row by row.
#include <pybind11/stl.h>

#include <cstdint>

#include "arrays.hpp"
#include "errors.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "plan.hpp"

namespace assur::python {

namespace {

struct SolvedBatch : RowsView {
  std::vector<std::uint8_t> status;
  std::vector<std::int64_t> item, configuration, offsets;
};

/// Solves an item. An error names the item by its place.
void solve_item(const mechanism::Plan& plan, const Columns& columns, py::ssize_t item,
                mechanism::Values& values, mechanism::Solution& solution) {
  try {
    values.set(columns.row(item));
    plan.solve(values, solution);
  } catch (const mechanism::MechanismError& error) {
    throw mechanism::MechanismError("values[" + std::to_string(item) + "]", error.what());
  }
}

std::shared_ptr<SolvedBatch> solve_batch(const PlannedScene& planned,
                                         const py::object& given_values,
                                         const py::kwargs& keywords) {
  const Columns columns = columns_of(planned.plan.mechanism(), given(given_values, keywords));
  auto batch = std::make_shared<SolvedBatch>();
  const auto rows = std::make_shared<Rows>(planned.plan, planned.layout);
  LongCall call;
  in_scene(planned.scene->file, [&] {
    mechanism::Values values = planned.plan.values();
    mechanism::Solution solution;
    batch->status.reserve(static_cast<std::size_t>(columns.count));
    for (py::ssize_t item = 0; item < columns.count; ++item) {
      call.go_on();
      solve_item(planned.plan, columns, item, values, solution);
      batch->status.push_back(static_cast<std::uint8_t>(solution.status));
      batch->offsets.push_back(static_cast<std::int64_t>(rows->count()));
      if (item == 0) {
        rows->reserve(static_cast<std::size_t>(columns.count) * solution.configurations.size());
      }
      std::int64_t number = 0;
      for (const mechanism::Configuration& configuration : solution.configurations) {
        rows->add(configuration, values.spread());
        batch->item.push_back(item);
        batch->configuration.push_back(++number);
      }
    }
    batch->offsets.push_back(static_cast<std::int64_t>(rows->count()));
  });
  batch->rows = rows;
  return batch;
}

/// A property that is a view of a vector of the batch.
template <typename Number>
auto all_of(std::vector<Number> SolvedBatch::*member) {
  return [member](const py::object& self) {
    return view_of(self.cast<const SolvedBatch&>().*member, self);
  };
}

}  // namespace

void add_solve_batch(py::module_& module, PlanClass& plan) {
  py::class_<SolvedBatch, RowsView, std::shared_ptr<SolvedBatch>>(
      module, "Batch",
      "The configurations of many items, each of which is a set of values. The first axis of the\n"
      "arrays of links, joints and outputs has a row for each configuration of each item, item by\n"
      "item.")
      .def_property_readonly("status", all_of(&SolvedBatch::status),
                             "Array of shape (items,): the Status of each item.")
      .def_property_readonly(
          "offsets", all_of(&SolvedBatch::offsets),
          "Array of shape (items + 1,): item i has the rows from offsets[i] to offsets[i + 1].")
      .def_property_readonly("item", all_of(&SolvedBatch::item),
                             "Array of shape (rows,): the item of each row, from 0.")
      .def_property_readonly(
          "configuration", all_of(&SolvedBatch::configuration),
          "Array of shape (rows,): the number of each configuration in its item, from 1.")
      .def(
          "__len__", [](const SolvedBatch& batch) { return batch.status.size(); },
          "The number of items.");
  plan.def("solve_batch", solve_batch, ByPlace("values ") = py::none(), py::pos_only(),
           "solve_batch(self, values=None, /, **parameters)\n--\n\n"
           "Returns every configuration of many sets of values, as a Batch.\n\n"
           "values, and keywords: for parameters, by their names, arrays of one shape (items,), or "
           "numbers\n"
           "that all items share. Arrays of doubles are read without a copy.\n\n"
           "Raises ShapeError for arrays of other shapes, and as solve does, with the number of "
           "the item.\n"
           "Ctrl-C ends it.");
}

}  // namespace assur::python
