#include "parts.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "forces.hpp"
#include "given.hpp"

namespace assur::python {

namespace {

using mechanism::Frame;
using mechanism::Point;
using mechanism::SlideState;

template <typename Part>
const Section& section_of(const Parts<Part>& parts) {
  return parts.of.rows->layout().template section<Part>();
}

template <typename Part>
PartState<Part> part_named(const Parts<Part>& parts, const std::string& name, const char* what) {
  const auto& names = section_of(parts).names;
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) {
    throw UnknownName(what, name, names);
  }
  return {parts.of, static_cast<std::size_t>(at - names.begin())};
}

const char* mend_of(Need need) {
  switch (need) {
    case Need::position:
      return "add 'position' to its key 'want'";
    case Need::velocity:
      return "add 'velocity' to its key 'want'";
    case Need::acceleration:
      return "add 'acceleration' to its key 'want'";
    case Need::both_rates:
      return "add 'velocity' and 'acceleration' to its key 'want'";
    case Need::sensitivity:
      return "add 'sensitivity' to its key 'want'";
    case Need::spread:
      return "give it a key 'covariance', and let it want 'sensitivity'";
  }
  return "";
}

template <typename Part>
py::object field_of(const py::object& self, std::size_t index) {
  const Field<Part>& field = fields<Part>()[index];
  const auto& state = self.cast<const PartState<Part>&>();
  const Section& section = state.of.rows->layout().template section<Part>();
  if (section.offsets[index] == Section::none) {
    throw NotWanted(std::string(field.name) + ": the scene does not want it; " +
                    mend_of(field.need));
  }
  return numbers_at(state.of, section.first + state.place * section.width + section.offsets[index],
                    field.shape, self);
}

/// `shape (2, parameters): derivatives ...`.
template <typename Part>
std::string doc_of(const Field<Part>& field) {
  if (field.shape.empty()) {
    return "float: " + std::string(field.meaning) + ".";
  }
  std::string shape;
  for (const std::ptrdiff_t extent : field.shape) {
    shape += (shape.empty() ? "" : ", ") +
             (extent == parameters ? std::string("parameters") : std::to_string(extent));
  }
  return "Array of shape (" + shape + (field.shape.size() == 1 ? ",): " : "): ") + field.meaning +
         ".";
}

/// What differs between the kinds of parts, for Python.
struct Names {
  const char* state;
  const char* states;
  const char* what;
  const char* state_doc;
  const char* states_doc;
};

template <typename Part>
void bind_kind(py::module_& module, const Names& names) {
  using All = Parts<Part>;
  py::class_<PartState<Part>> state(module, names.state, names.state_doc);
  for (std::size_t index = 0; index < fields<Part>().size(); ++index) {
    const Field<Part>& field = fields<Part>()[index];
    state.def_property_readonly(
        field.name, [index](const py::object& self) { return field_of<Part>(self, index); },
        doc_of(field).c_str());
  }
  state.def("__repr__", [kind = std::string(names.state)](const PartState<Part>& of) {
    const Section& section = of.of.rows->layout().template section<Part>();
    std::string text;
    for (std::size_t index = 0; index < section.offsets.size(); ++index) {
      if (section.offsets[index] != Section::none) {
        text += (text.empty() ? " " : ", ") + std::string(fields<Part>()[index].name);
      }
    }
    return "<assur." + kind + " " + section.names[of.place] + ":" + text + ">";
  });
  const char* const what = names.what;
  py::class_<All>(module, names.states, names.states_doc)
      .def(
          "__getitem__",
          [what](const All& all, const py::object& name) {
            return part_named(all, utf8_of(name, "the name"), what);
          },
          "__getitem__(self, name, /)\n--\n\nThe state of the part with this name. Raises "
          "UnknownName if there is none.")
      .def(
          "__len__", [](const All& all) { return section_of(all).names.size(); },
          "The number of names.")
      .def("__repr__",
           [kind = std::string(names.states)](const All& all) {
             std::string text;
             for (const std::string& name : section_of(all).names) {
               text += (text.empty() ? " " : ", ") + name;
             }
             return "<assur." + kind + ":" + text + ">";
           })
      .def(
          "__iter__", [](const All& all) { return py::iter(py::cast(section_of(all).names)); },
          "Iterates over the names, in the scene's order.")
      .def(
          "__contains__",
          [](const All& all, const py::object& name) {
            return py::cast(section_of(all).names).contains(name);
          },
          "Whether there is a part with this name.")
      .def(
          "keys", [](const All& all) { return section_of(all).names; },
          "keys(self)\n--\n\nThe list of the names, in the scene's order.")
      .def(
          "values",
          [what](const All& all) {
            py::list states;
            for (const std::string& name : section_of(all).names) {
              states.append(part_named(all, name, what));
            }
            return states;
          },
          "values(self)\n--\n\nThe list of the states, in the order of the names.")
      .def(
          "items",
          [what](const All& all) {
            py::list items;
            for (const std::string& name : section_of(all).names) {
              items.append(py::make_tuple(name, part_named(all, name, what)));
            }
            return items;
          },
          "items(self)\n--\n\nThe list of pairs of a name and a state.");
}

}  // namespace

void bind_parts(py::module_& module) {
  bind_kind<Frame>(
      module,
      {"LinkState", "Links", "link",
       "The state of a link. If there are several configurations, they are the first axis of\n"
       "every array. A result that the scene does not want raises NotWanted.",
       "A mapping from the names of the reported links, including the ground, to LinkState."});
  bind_kind<SlideState>(
      module, {"JointState", "Joints", "reported prismatic joint or pin in a slot",
               "The state of a prismatic joint or a pin in a slot. If there are several\n"
               "configurations, every float is an array of shape (configurations,), and they\n"
               "are the first axis of every array. A result that the scene does not want\n"
               "raises NotWanted.",
               "A mapping from the names of the reported prismatic joints and pins in slots to\n"
               "JointState."});
  bind_kind<Point>(
      module, {"OutputState", "Outputs", "output",
               "The state of an output. If there are several configurations, every float is an\n"
               "array of shape (configurations,), and they are the first axis of every array.\n"
               "A result that the scene does not want raises NotWanted.",
               "A mapping from the names of the outputs to OutputState."});
  py::class_<RowsView, std::shared_ptr<RowsView>>(
      module, "States",
      "The states of one configuration, or of several, which are then the first axis of every\n"
      "array.")
      .def_property_readonly(
          "links", [](const RowsView& of) { return Parts<Frame>{of}; },
          "Links: the reported links by their names.")
      .def_property_readonly(
          "joints", [](const RowsView& of) { return Parts<SlideState>{of}; },
          "Joints: the reported prismatic joints and pins in slots by their names.")
      .def_property_readonly(
          "outputs", [](const RowsView& of) { return Parts<Point>{of}; },
          "Outputs: the outputs by their names.")
      .def_property_readonly(
          "forces",
          [](const py::object& self) { return forces_in(self.cast<const RowsView&>(), self); },
          "dict: the efforts of drivers, the forces in joints and the resultant on the ground, "
          "each a\n"
          "float or an array of shape (2,), with the configurations as a first axis where there "
          "are\n"
          "several; NaN, with a reason, where one is not determined. With sensitivities wanted "
          "also\n"
          "these, worst case and rss, each in the same form. At events they are NaN. Raises "
          "NotWanted.")
      .def_property_readonly(
          "residual",
          [](const py::object& self) {
            return numbers_at(self.cast<const RowsView&>(), 0, {}, self);
          },
          "float, or array of shape (configurations,): the largest closure error, in the scene's\n"
          "unit.")
      .def_property_readonly(
          "regular",
          [](const py::object& self) { return regular_at(self.cast<const RowsView&>(), self); },
          "bool, or array of shape (configurations,): whether every derivative keeps six digits.");
}

}  // namespace assur::python
