#include "plan.hpp"

#include <pybind11/stl.h>

#include <assur/text/counts.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "names.hpp"
#include "solved_scene.hpp"

namespace assur::python {

namespace {

using Asked = SolvedScene::Asked;

/// A group as the command prints it.
struct GroupOfPlan {
  int assur_class;
  std::string kind;
  std::optional<int> model;
  std::vector<std::string> links;
  std::set<std::string> joints;
  std::optional<int> complex_configurations;
  std::optional<std::string> relative_to;
};

std::vector<GroupOfPlan> groups_of(const PlannedScene& planned) {
  const mechanism::Structure& structure = planned.plan.structure();
  std::vector<GroupOfPlan> groups;
  for (const mechanism::FoundGroup& group : structure.groups) {
    const mechanism::GroupModel& model = *group.model;
    std::set<std::string> joints;
    for (const mechanism::ElementaryJointIndex joint : group.assignments.front().joints) {
      joints.insert(structure.linkage.joints[joint].name);
    }
    groups.push_back(
        {model.group->assur_class, group.kind,
         model.is_derived() ? std::nullopt : std::optional(model.number),
         structure.names_of(group.links), std::move(joints),
         model.rigid ? std::optional(model.max_configurations) : std::nullopt,
         group.base.exists() ? std::optional(structure.linkage.links[group.base]) : std::nullopt});
  }
  return groups;
}

SharedSolution solved(const SharedPlan& planned, const py::object& values,
                      const py::kwargs& keywords, Asked asked, std::size_t number = 0) {
  auto replaced = numbers_of(planned->plan.mechanism(), given(values, keywords));
  const OthersRun others_run;
  return std::make_shared<SolvedScene>(planned, std::move(replaced), asked, number);
}

mechanism::Plan planned_of(const mechanism::Scene& scene) {
  return in_scene(scene.file, [&] { return mechanism::Plan(scene.mechanism, scene.request); });
}

void bind_group(py::module_& module) {
  py::class_<GroupOfPlan>(module, "Group", "An Assur group of a plan.")
      .def_readonly("assur_class", &GroupOfPlan::assur_class,
                    "int: 2 for a dyad, 3 for a triad, 4 for a tetrad; the sides of the largest "
                    "contour.")
      .def_readonly("kind", &GroupOfPlan::kind,
                    "str: the letters of its joints, R for revolute and P for prismatic.")
      .def_readonly(
          "model", &GroupOfPlan::model,
          "int or None: the number of its model, as `assur catalogue` lists it; None for a\n"
          "group of more than four links.")
      .def_readonly("links", &GroupOfPlan::links, "list of str: the names of its links.")
      .def_property_readonly(
          "joints",
          [](const GroupOfPlan& group) {
            return std::vector<std::string>(group.joints.begin(), group.joints.end());
          },
          "list of str: the names of its joints, in alphabetical order.")
      .def_readonly("complex_configurations", &GroupOfPlan::complex_configurations,
                    "int or None: how many configurations it has in complex numbers, in general\n"
                    "position; None where it moves.")
      .def_readonly("relative_to", &GroupOfPlan::relative_to,
                    "str or None: the moving link relative to which it is solved, if any.");
}

}  // namespace

SharedScene scene_given(const py::handle& value) {
  if (!py::isinstance<ReadScene>(value)) {
    throw py::type_error("scene: expected a Scene, which read_scene and parse_scene return, not " +
                         type_of(value));
  }
  return py::cast<SharedScene>(value);
}

PlannedScene::PlannedScene(SharedScene of)
    : scene(std::move(of)),
      plan(planned_of(*scene)),
      layout(std::make_shared<Layout>(plan, plan.request().want)) {
  mechanism::Want rates = plan.request().want;
  rates.position = false;
  rates.sensitivity = false;
  rates.forces = false;
  layout_of_rates = std::make_shared<Layout>(plan, rates);
}

void bind_plan(py::module_& module) {
  bind_group(module);
  PlanClass plan(
      module, "Plan",
      "Plan(scene, /)\n--\n\n"
      "The decomposition of a scene into groups, made once. It solves the scene for any number of\n"
      "values, and threads may share it.\n\n"
      "Raises SceneError for a scene that cannot be solved, and its subclass OverConstrained for "
      "one\n"
      "with more constraints than freedoms.");
  plan.def(py::init([](const py::object& given_scene) {
             const SharedScene scene = scene_given(given_scene);
             const OthersRun others_run;
             return std::make_shared<PlannedScene>(scene);
           }),
           py::arg("scene"), py::pos_only())
      .def_property_readonly(
          "scene", [](const PlannedScene& planned) { return planned.scene; },
          "Scene: the scene that it was made from.")
      .def_property_readonly(
          "parameters",
          [](const PlannedScene& planned) {
            return tuple_of(text::names_of(planned.plan.mechanism().parameters()));
          },
          "tuple of str: the names of the parameters, in the order of sensitivities.")
      .def_property_readonly(
          "links",
          [](const PlannedScene& planned) { return tuple_of(planned.layout->links.names); },
          "tuple of str: the names of the reported links.")
      .def_property_readonly(
          "joints",
          [](const PlannedScene& planned) { return tuple_of(planned.layout->slides.names); },
          "tuple of str: the names of the reported prismatic joints and pins in slots.")
      .def_property_readonly(
          "outputs",
          [](const PlannedScene& planned) { return tuple_of(planned.layout->outputs.names); },
          "tuple of str: the names of the outputs.")
      .def_property_readonly("groups", groups_of,
                             "list of Group: in the order in which they are solved.")
      .def_property_readonly(
          "redundant",
          [](const PlannedScene& planned) {
            std::vector<std::string> names;
            for (const mechanism::RedundantJoint& joint : planned.plan.redundant()) {
              names.push_back(joint.name);
            }
            return tuple_of(names);
          },
          "tuple of str: the names of the redundant joints, which only hold where the others do.")
      .def_property_readonly(
          "most_configurations",
          [](const PlannedScene& planned) { return planned.plan.most_configurations(); },
          "float: the largest number of configurations that there can be.")
      .def(
          "solve",
          [](const SharedPlan& planned, const py::object& values, const py::kwargs& keywords) {
            return solved(planned, values, keywords, Asked::all);
          },
          ByPlace("values ") = py::none(), py::pos_only(),
          "solve(self, values=None, /, **parameters)\n--\n\n"
          "Returns every configuration, as a Solution.\n\n"
          "values, and keywords: numbers for parameters, by their names, in place of their "
          "formulas.\n"
          "A keyword overrides the mapping. Angles are radians.\n\n"
          "Raises UnknownName, ShapeError for a value that is not a number, and SceneError for "
          "values\n"
          "that cannot be used. Links that cannot reach are not an error: see Solution.status.")
      .def(
          "solve_one",
          [](const SharedPlan& planned, const py::object& number, const py::object& values,
             const py::kwargs& keywords) {
            return solved(planned, values, keywords, Asked::numbered,
                          static_cast<std::size_t>(place_number(number, "number")));
          },
          ByPlace("number "), ByPlace("values ") = py::none(), py::pos_only(),
          "solve_one(self, number, values=None, /, **parameters)\n--\n\n"
          "Returns the configuration with a number, from 1, alone in a Solution.\n\n"
          "values and keywords: see solve. Raises SceneError if there is no such configuration, "
          "and\n"
          "as solve does.")
      .def(
          "solve_nearest",
          [](const SharedPlan& planned, const py::object& values, const py::kwargs& keywords) {
            return solved(planned, values, keywords, Asked::nearest);
          },
          ByPlace("values ") = py::none(), py::pos_only(),
          "solve_nearest(self, values=None, /, **parameters)\n--\n\n"
          "Returns the configuration nearest to the scene's reference, alone in a Solution.\n\n"
          "values and keywords: see solve. Raises SceneError if the scene has no reference, and "
          "as\n"
          "solve does.");
  plan.def(py::pickle([](const PlannedScene& planned) { return py::make_tuple(planned.scene); },
                      [](const py::tuple& state) {
                        return std::make_shared<PlannedScene>(state[0].cast<SharedScene>());
                      }))
      .def("__repr__", [](const PlannedScene& planned) {
        return "<assur.Plan of " + planned.scene->file + ": " +
               text::with_noun(planned.plan.structure().groups.size(), "group") + ", at most " +
               py::cast<std::string>(py::str(
                   py::float_(planned.plan.most_configurations()).attr("__format__")("g"))) +
               " configurations>";
      });
  add_solve_batch(module, plan);
  add_sweep(module, plan);
}

}  // namespace assur::python
