// Python classes of solutions, their configurations and their families.
#include <pybind11/stl.h>

#include <assur/mechanism/report.hpp>
#include <assur/variables.hpp>
#include <cmath>

#include "arrays.hpp"
#include "bindings.hpp"
#include "drawing.hpp"
#include "errors.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "results.hpp"
#include "tables.hpp"

namespace assur::python {

namespace {

using mechanism::Family;
using mechanism::Nearest;

/// A family of configurations, and the names of its links.
struct SolvedFamily {
  SharedSolution solution;
  const Family* family;
};

py::object status_of(const SolvedScene& solved) {
  return py::module_::import("assur.statuses")
      .attr("Status")(static_cast<int>(solved.solution.status));
}

std::string reason_of(const SolvedScene& solved) {
  const OthersRun others_run;
  return solved.solution.status == mechanism::SolutionStatus::no_assembly
             ? solved.planned->plan.obstacle(solved.values())
             : solved.solution.reason;
}

SolvedConfiguration configuration_at(const SharedSolution& solved, py::ssize_t at) {
  const auto count = static_cast<py::ssize_t>(solved->rows->count());
  const py::ssize_t place = at < 0 ? at + count : at;
  if (place < 0 || place >= count) {
    throw py::index_error("configuration " + std::to_string(at) +
                          ": the number of configurations is " + std::to_string(count));
  }
  return {{solved->rows, place}, solved, static_cast<std::size_t>(place)};
}

SolvedConfiguration configuration_given(const SharedSolution& solved, const py::object& place) {
  if (PyIndex_Check(place.ptr()) == 0) {
    throw py::type_error("the index of a configuration must be a whole number, not " +
                         type_of(place));
  }
  return configuration_at(solved, place.cast<py::ssize_t>());
}

py::tuple families_of(SolvedScene& solved) {
  py::list families;
  for (const Family& family : solved.solution.families) {
    families.append(SolvedFamily{solved.shared_from_this(), &family});
  }
  return {families};
}

py::dict placed_links(const SolvedFamily& of) {
  py::dict poses;
  const auto& links = of.solution->planned->plan.mechanism().links();
  for (const mechanism::LinkIndex link : links.keys()) {
    if (of.family->is_placed[link]) {
      const Pose<double>& pose = of.family->links[link].pose;
      py::array_t<double> array(3);
      array.mutable_at(0) = pose.x;
      array.mutable_at(1) = pose.y;
      array.mutable_at(2) = angle_of(pose.direction);
      poses[py::str(links[link].name)] = array;
    }
  }
  return poses;
}

py::dict parameters_of(const SolvedScene& solved) {
  py::dict all;
  const mechanism::Values values = solved.values();
  const auto& parameters = solved.planned->plan.mechanism().parameters();
  for (const mechanism::ParameterIndex parameter : parameters.keys()) {
    all[py::str(parameters[parameter].name)] = values.parameter(parameter);
  }
  return all;
}

std::optional<Nearest> nearest_of(const SolvedScene& solved) {
  if (solved.asked == SolvedScene::Asked::nearest) {
    return solved.nearest;
  }
  return in_scene(solved.planned->scene->file,
                  [&] { return solved.planned->plan.nearest(solved.values(), solved.solution); });
}

std::string svg(const SolvedScene& solved, mechanism::DrawingChoice choice) {
  const OthersRun others_run;
  choice.nearest = solved.asked == SolvedScene::Asked::nearest;
  return svg_of(*solved.planned->scene, solved.replaced, choice);
}

std::string svg_of_all(const SolvedScene& solved) {
  return svg(solved, {static_cast<int>(solved.asked_number), false});
}

std::string svg_of_one(const SolvedConfiguration& one) {
  const auto number = static_cast<int>(one.solution->number_of(one.place).value_or(0));
  return svg(*one.solution, {number, false});
}

/// None if there is no picture: a notebook then shows the text.
template <typename Solved>
py::object picture(const Solved& solved, std::string (*svg)(const Solved&)) {
  try {
    return py::str(svg(solved));
  } catch (const text::InputError&) {
    return py::none();
  }
}

std::string text_of(const SolvedScene& solved) {
  const OthersRun others_run;
  return mechanism::report_text(solved.report(solved.values()));
}

std::string json_of(const SolvedScene& solved) {
  const OthersRun others_run;
  return mechanism::report_json(solved.report(solved.values()));
}

void bind_family(py::module_& module) {
  py::class_<SolvedFamily>(
      module, "Family",
      "A choice of configurations of earlier groups for which a later group moves freely, or is\n"
      "inconsistent.")
      .def_property_readonly(
          "group", [](const SolvedFamily& of) { return of.family->group.place() + 1; },
          "int: the number of the group, from 1.")
      .def_property_readonly(
          "mobility", [](const SolvedFamily& of) { return of.family->mobility; },
          "int: how many freedoms the group has; zero where it was not found assembled.")
      .def_property_readonly(
          "reason", [](const SolvedFamily& of) { return of.family->reason; },
          "str: the reason, with the joints that leave the group free.")
      .def_property_readonly("links", placed_links,
                             "dict of arrays of shape (3,): x, y, theta of the links that are "
                             "placed, by their names.");
}

void bind_nearest(py::module_& module) {
  py::class_<Nearest>(module, "Nearest",
                      "How far a solution is from the scene's reference, in radians.")
      .def_readonly(
          "distance", &Nearest::distance,
          "float: root of the sum of the squared angles between the links and the reference.")
      .def_readonly("runner_up", &Nearest::runner_up,
                    "float or None: the distance of the next configuration, if there is one.")
      .def_readonly("place", &Nearest::configuration,
                    "int: the index of the nearest configuration in the solution, from 0.");
}

}  // namespace

void bind_solution(py::module_& module) {
  bind_family(module);
  bind_nearest(module);
  py::class_<SolvedConfiguration, RowsView, std::shared_ptr<SolvedConfiguration>>(
      module, "Configuration", "One configuration of a solution.")
      .def_property_readonly(
          "number",
          [](const SolvedConfiguration& one) { return one.solution->number_of(one.place); },
          "int or None: its number, from 1, as `assur solve` counts; None if it is not known.")
      .def_property_readonly(
          "branches",
          [](const SolvedConfiguration& one) -> std::optional<RowsView> {
            const auto& rates = one.solution->branches[one.place];
            return rates == nullptr ? std::nullopt : std::optional(RowsView{rates});
          },
          "States or None: the states with the rates of each motion, where several motions cross "
          "in\n"
          "this configuration. They have no forces: what is determined there is among those of "
          "the\n"
          "configuration itself.")
      .def("svg", svg_of_one,
           "svg(self)\n--\n\n"
           "Returns a picture of this configuration, as the text of an SVG file; see Scene.svg.")
      .def("_repr_svg_", [](const SolvedConfiguration& one) { return picture(one, svg_of_one); })
      .def("__repr__",
           [](const SolvedConfiguration& one) {
             const auto number = one.solution->number_of(one.place);
             return "<assur.Configuration" + (number ? " " + std::to_string(*number) : "") +
                    (one.rows->regular()[one.place] != 0 ? ": regular>" : ": near-singular>");
           })
      .def(py::pickle(
          [](const SolvedConfiguration& one) { return py::make_tuple(one.solution, one.place); },
          [](const py::tuple& state) {
            return std::make_shared<SolvedConfiguration>(
                configuration_at(state[0].cast<SharedSolution>(), state[1].cast<py::ssize_t>()));
          }));
  py::class_<SolvedScene, RowsView, SharedSolution>(
      module, "Solution",
      "Every configuration at one set of values. solution[0] is the first one. In links, joints "
      "and\n"
      "outputs of the solution itself, the configurations are the first axis of every array.")
      .def_property_readonly("status", status_of, "Status: OK, NO_ASSEMBLY or DEGENERATE.")
      .def_property_readonly(
          "mobility", [](const SolvedScene& solved) { return solved.solution.mobility; },
          "int: the freedoms of the freest family, where there are families only.")
      .def_property_readonly(
          "reason", reason_of,
          "str: the reason why there is no configuration; empty where there is one.")
      .def_property_readonly(
          "complete", [](const SolvedScene& solved) { return solved.solution.incomplete.empty(); },
          "bool: whether no configuration can be missing.")
      .def_property_readonly(
          "incomplete", [](const SolvedScene& solved) { return solved.solution.incomplete; },
          "str: the reason why configurations may be missing; empty where none can be.")
      .def_property_readonly("families", families_of,
                             "tuple of Family: the families beside the configurations.")
      .def_property_readonly(
          "left_out", [](const SolvedScene& solved) { return solved.solution.left_out; },
          "int or None: how many configurations are beyond the limits of joints; None if they "
          "were\n"
          "not counted.")
      .def_property_readonly(
          "dropped", [](const SolvedScene& solved) { return solved.solution.dropped; },
          "int: how many choices of configurations leave a driver's law without a value.")
      .def_property_readonly(
          "drop_reason", [](const SolvedScene& solved) { return solved.solution.drop_reason; },
          "str: the message of such a law; empty if there is none.")
      .def_property_readonly("parameters", parameters_of,
                             "dict of float: the values of all parameters, by their names.")
      .def_property_readonly("nearest", nearest_of,
                             "Nearest or None: the configuration nearest to the scene's reference; "
                             "None if there is no\n"
                             "configuration. Raises SceneError if the scene has no reference.")
      .def(
          "__len__", [](const SolvedScene& solved) { return solved.rows->count(); },
          "The number of configurations.")
      .def("__getitem__", configuration_given, py::arg("place"), py::pos_only(),
           "__getitem__(self, place, /)\n--\n\nThe Configuration at an index, from 0.\n\n"
           "Raises IndexError beyond the last one.")
      .def("svg", svg_of_all,
           "svg(self)\n--\n\n"
           "Returns a picture of its configurations, as the text of an SVG file; see Scene.svg.")
      .def("to_frame", frame_of, frame_doc)
      .def("to_json", json_of,
           "to_json(self)\n--\n\nReturns the text that `assur solve --format json` prints.")
      .def("_repr_svg_", [](const SolvedScene& solved) { return picture(solved, svg_of_all); })
      .def("__str__", text_of)
      .def(py::pickle(
          [](const SolvedScene& solved) {
            return py::make_tuple(solved.planned, solved.replaced, static_cast<int>(solved.asked),
                                  solved.asked_number);
          },
          [](const py::tuple& state) {
            return std::make_shared<SolvedScene>(
                state[0].cast<SharedPlan>(), state[1].cast<Replaced>(),
                static_cast<SolvedScene::Asked>(state[2].cast<int>()),
                state[3].cast<std::size_t>());
          }))
      .def("__repr__", [](const SolvedScene& solved) {
        const std::size_t count = solved.rows->count();
        return "<assur.Solution: " + std::to_string(count) +
               (count == 1 ? " configuration" : " configurations") + ", " +
               std::to_string(solved.solution.families.size()) + " families>";
      });
}

}  // namespace assur::python
