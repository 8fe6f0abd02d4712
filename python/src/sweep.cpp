// Sweeps: rows for each branch, and rows for the events between them.
#include <pybind11/stl.h>

#include <assur/mechanism/sweep.hpp>
#include <assur/text/counts.hpp>
#include <cstdint>
#include <map>

#include "arrays.hpp"
#include "errors.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "pickling.hpp"
#include "swept_rows.hpp"
#include "tables.hpp"

namespace assur::python {

namespace {

/// Collects what a sweep reports.
class Collector {
 public:
  /// `values` hold all parameters except the swept one.
  Collector(const SharedPlan& planned, mechanism::Values values)
      : planned_(planned), values_(std::move(values)) {
    result_.events = empty<Events>();
    result_.unassigned = empty<Branch>();
  }

  [[nodiscard]] mechanism::SweepObserver observer(LongCall& call) {
    mechanism::SweepObserver observer;
    observer.record = [this](const mechanism::SweepRecord& record) { add(record); };
    observer.solved = [&call](double, const mechanism::Solution&) { call.go_on(); };
    observer.circuits = [this](const mechanism::Circuits& circuits) {
      for (const auto& [number, branch] : result_.branches) {
        branch->circuit = circuits.of(number);
      }
    };
    return observer;
  }
  /// The result, with branches in the order of their numbers.
  [[nodiscard]] SweptScene result() && {
    const auto& sweep = planned_->plan.request().sweep;
    result_.parameter = planned_->plan.mechanism().parameters()[sweep->parameter].name;
    return std::move(result_);
  }

 private:
  template <typename Kind>
  [[nodiscard]] std::shared_ptr<Kind> empty() {
    auto rows = std::make_shared<Kind>();
    growing_.push_back(std::make_shared<Rows>(planned_->plan, planned_->layout));
    rows->planned = planned_;
    rows->rows = growing_.back();
    rows_of_[rows.get()] = growing_.back().get();
    return rows;
  }

  void add(const mechanism::SweepRecord& record) {
    if (!record.event.empty()) {
      append(record, *result_.events);
      return;
    }
    if (record.branch == 0) {
      append(record, *result_.unassigned);
      return;
    }
    std::shared_ptr<Branch>& branch = result_.branches[record.branch];
    if (branch == nullptr) {
      branch = empty<Branch>();
      branch->number = record.branch;
    }
    append(record, *branch);
  }

  void append(const mechanism::SweepRecord& record, SweptRows& to) {
    if (record.event.empty() && planned_->plan.request().want.forces) {
      values_.set(planned_->plan.request().sweep->parameter, record.parameter);
      rows_of_[&to]->add(*record.state, values_);
    } else {
      rows_of_[&to]->add_without_forces(*record.state, *record.spread);
    }
    to.step.push_back(record.step);
    to.configuration.push_back(record.configuration);
    to.parameter.push_back(record.parameter);
    if (!record.event.empty()) {
      to.event.push_back(record.event);
    }
  }

  const SharedPlan& planned_;
  mechanism::Values values_;
  SweptScene result_;
  std::vector<std::shared_ptr<Rows>> growing_;
  std::map<const SweptRows*, Rows*> rows_of_;
};

/// Throws MechanismError for a value of the swept parameter, which the sweep itself sets.
void expect_others(const PlannedScene& planned, const Replaced& replaced) {
  const auto& sweep = planned.plan.request().sweep;
  for (const auto& [name, value] : replaced) {
    if (sweep && planned.plan.mechanism().parameters()[sweep->parameter].name == name) {
      throw mechanism::MechanismError(
          name, "the sweep gives '" + name + "' its values; leave this out, or change the sweep");
    }
  }
}

SweptScene swept(const SharedPlan& planned, const py::object& values, const py::kwargs& keywords) {
  const Given all = given(values, keywords);
  if (has_arrays(all)) {
    return swept_through_items(planned, all);
  }
  const auto replaced = numbers_of(planned->plan.mechanism(), all);
  LongCall call;
  return in_scene(planned->scene->file, [&] {
    expect_others(*planned, replaced);
    const mechanism::Values at = planned->plan.values(replaced);
    Collector collector(planned, at);
    mechanism::sweep(planned->plan, at, collector.observer(call));
    return std::move(collector).result();
  });
}

std::shared_ptr<Branch> swept_branch(const SharedPlan& planned, const py::object& of,
                                     const py::object& values, const py::kwargs& keywords) {
  const int number = place_number(of, "number");
  const auto replaced = numbers_of(planned->plan.mechanism(), given(values, keywords));
  std::optional<double> end;
  SweptScene result;
  {
    LongCall call;
    in_scene(planned->scene->file, [&] {
      expect_others(*planned, replaced);
      const mechanism::Values at = planned->plan.values(replaced);
      Collector collector(planned, at);
      end = mechanism::sweep_branch(planned->plan, at, static_cast<std::size_t>(number),
                                    collector.observer(call));
      result = std::move(collector).result();
    });
  }
  std::shared_ptr<Branch> branch =
      result.branches.empty() ? result.unassigned : result.branches.begin()->second;
  branch->number = number;
  branch->ends_at = end;
  return branch;
}

std::optional<int> nearest_branch(const PlannedScene& planned) {
  const OthersRun others_run;
  return in_scene(planned.scene->file, [&] {
    return mechanism::nearest_branch(planned.scene->mechanism, planned.scene->request);
  });
}

template <typename Kind, typename Number>
auto all_of(std::vector<Number> SweptRows::*member) {
  return
      [member](const py::object& self) { return view_of(self.cast<const Kind&>().*member, self); };
}

/// The common part of the classes of branches and events.
template <typename Kind>
py::class_<Kind, RowsView, std::shared_ptr<Kind>> swept_class(py::module_& module, const char* name,
                                                              const char* doc) {
  return py::class_<Kind, RowsView, std::shared_ptr<Kind>>(module, name, doc)
      .def_property_readonly(
          "step", all_of<Kind>(&SweptRows::step),
          "Array of shape (rows,): the number of the step, from 0; for an event\n"
          "the last step that is not beyond it.")
      .def_property_readonly("parameter", all_of<Kind>(&SweptRows::parameter),
                             "Array of shape (rows,): the value of the swept parameter.")
      .def("to_frame", frame_of, frame_doc)
      .def(
          "__len__", [](const Kind& rows) { return rows.step.size(); }, "The number of rows.");
}

/// The pickled state of branches and events: rows, steps, configurations, values of the parameter.
py::tuple swept_state(const SweptRows& rows) {
  return py::make_tuple(rows.planned, rows_state(rows), bytes_of(rows.step),
                        bytes_of(rows.configuration), bytes_of(rows.parameter));
}

template <typename Kind>
std::shared_ptr<Kind> swept_in(const py::tuple& state) {
  auto rows = std::make_shared<Kind>();
  rows->planned = state[0].cast<SharedPlan>();
  rows->rows = rows_in(*rows->planned, state[1]);
  rows->step = numbers_in<std::int32_t>(state[2]);
  rows->configuration = numbers_in<std::int32_t>(state[3]);
  rows->parameter = numbers_in<double>(state[4]);
  return rows;
}

void bind_rows(py::module_& module) {
  swept_class<Branch>(module, "Branch",
                      "One branch of a sweep. Its rows are the first axis of every array.")
      .def_readonly("number", &Branch::number,
                    "int: the number of the branch, from 1; zero for configurations without a "
                    "branch, and for\n"
                    "the branch nearest to the reference.")
      .def_property_readonly(
          "configuration", all_of<Branch>(&SweptRows::configuration),
          "Array of shape (rows,): the number of the configuration at its step;\n"
          "zero where that is not known.")
      .def("__repr__",
           [](const Branch& branch) {
             return "<assur.Branch " + std::to_string(branch.number) + ": " +
                    text::with_noun(branch.step.size(), "row") + ">";
           })
      .def(py::pickle(
          [](const Branch& branch) {
            return py::make_tuple(swept_state(branch), branch.number, branch.ends_at,
                                  branch.circuit);
          },
          [](const py::tuple& state) {
            auto branch = swept_in<Branch>(state[0].cast<py::tuple>());
            branch->number = state[1].cast<int>();
            branch->ends_at = state[2].cast<std::optional<double>>();
            branch->circuit = state[3].cast<std::optional<int>>();
            return branch;
          }))
      .def_readonly(
          "circuit", &Branch::circuit,
          "int or None: the number of its circuit, from 1: the branches that the mechanism "
          "reaches\n"
          "without being taken apart; None where it is not known, as for sweep_branch.")
      .def_readonly("ends_at", &Branch::ends_at,
                    "float or None: the value of the parameter at which sweep_branch cannot follow "
                    "the branch\n"
                    "any further; None if it reaches the end.");
  swept_class<Events>(module, "Events", "The events of a sweep, one row per event.")
      .def_property_readonly(
          "event", [](const Events& events) { return py::tuple(py::cast(events.event)); },
          "tuple of str: each event with the numbers of its branches, such as `fold 1 2`.")
      .def("__repr__",
           [](const Events& events) {
             std::string text;
             for (const std::string& event : events.event) {
               text += (text.empty() ? ": " : ", ") + event;
             }
             return "<assur.Events" + text + ">";
           })
      .def(py::pickle(
          [](const Events& events) { return py::make_tuple(swept_state(events), events.event); },
          [](const py::tuple& state) {
            auto events = swept_in<Events>(state[0].cast<py::tuple>());
            events->event = state[1].cast<std::vector<std::string>>();
            return events;
          }));
}

}  // namespace

void add_sweep(py::module_& module, PlanClass& plan) {
  bind_rows(module);
  py::class_<SweptScene>(module, "Sweep", "The branches of a sweep, and the events between them.")
      .def_readonly("parameter", &SweptScene::parameter, "str: the name of the swept parameter.")
      .def_readonly("branches", &SweptScene::branches,
                    "dict of Branch: the branches by their numbers, from 1.")
      .def_readonly("unassigned", &SweptScene::unassigned,
                    "Branch: the configurations that belong to no branch.")
      .def_readonly("events", &SweptScene::events, "Events: folds, crossings and other events.")
      .def("to_frame", frame_of, frame_doc)
      .def("__repr__",
           [](const SweptScene& sweep) {
             return "<assur.Sweep over " + sweep.parameter + ": " +
                    std::to_string(sweep.branches.size()) +
                    (sweep.branches.size() == 1 ? " branch" : " branches") + ", " +
                    text::with_noun(sweep.events->event.size(), "event") + ">";
           })
      .def(py::pickle(
          [](const SweptScene& sweep) {
            return py::make_tuple(sweep.branches, sweep.unassigned, sweep.events, sweep.parameter);
          },
          [](const py::tuple& state) {
            return SweptScene{state[0].cast<std::map<int, std::shared_ptr<Branch>>>(),
                              state[1].cast<std::shared_ptr<Branch>>(),
                              state[2].cast<std::shared_ptr<Events>>(),
                              state[3].cast<std::string>()};
          }));
  plan.def("sweep", swept, ByPlace("values ") = py::none(), py::pos_only(),
           "sweep(self, values=None, /, **parameters)\n--\n\n"
           "Returns every branch of the scene's sweep, as a Sweep, with other parameters at the "
           "given\n"
           "values (see solve). With arrays of one shape (items,), as solve_batch takes them, the\n"
           "branches go through the items instead: these are the steps, any parameters may change "
           "from\n"
           "one to the next, Sweep.parameter is 'item', and events are not located.\n\n"
           "Raises SceneError if the scene has no sweep and no array is given, and as solve does. "
           "Ctrl-C\n"
           "ends it.")
      .def(
          "nearest_branch", nearest_branch,
          "nearest_branch(self)\n--\n\n"
          "Returns the number of the branch of the scene's sweep that is nearest to the reference, "
          "or\n"
          "None if there is none. Without a reference of its own, a drawn scene has the branch "
          "through\n"
          "the drawn configuration.\n\n"
          "Raises SceneError if the scene has no reference or no sweep.")
      .def("sweep_branch", swept_branch, ByPlace("number "), ByPlace("values ") = py::none(),
           py::pos_only(),
           "sweep_branch(self, number, values=None, /, **parameters)\n--\n\n"
           "Returns one branch alone, as a Branch, which takes the memory of its own rows only: "
           "the\n"
           "branch with a number at the first step, or for 0 the one nearest to the scene's\n"
           "reference. Other parameters have the given values (see solve).\n\n"
           "Raises SceneError if there is no such branch, and as sweep does. Ctrl-C ends it.");
}

}  // namespace assur::python
