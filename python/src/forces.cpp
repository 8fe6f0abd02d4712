#include "forces.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "errors.hpp"
#include "names.hpp"

namespace assur::python {

namespace {

/// The dictionary of a joint; added empty for the joint's first column.
py::dict joint_in(const py::dict& joints, const std::string& name) {
  const py::str key(name);
  if (!joints.contains(key)) {
    joints[key] = py::dict();
  }
  return joints[key];
}

}  // namespace

py::dict forces_by_names(const std::vector<mechanism::ForceColumn>& columns, const ForcesAt& at) {
  py::dict efforts;
  py::dict joints;
  py::dict ground;
  for (std::size_t place = 0; place < columns.size(); ++place) {
    const mechanism::ForceColumn& column = columns[place];
    py::dict part = column.joint.empty() ? ground : joint_in(joints, column.joint);
    if (column.part == "effort") {
      efforts[py::str(column.of)] = at(place, {});
    } else if (column.part == "moment") {
      part["moment"] = at(place, {});
    } else if (column.part == "fx" && column.of != column.joint && !column.joint.empty()) {
      joint_in(part, "forces")[py::str(column.on)] = at(place, {2});
    } else if (column.part == "fx") {
      part["force"] = at(place, {2});
      if (!column.on.empty()) {
        part["on"] = column.on;
      }
    }
  }
  py::dict result;
  result["efforts"] = efforts;
  result["joints"] = joints;
  result["ground"] = ground;
  return result;
}

py::dict forces_in(const RowsView& of, const py::object& owner) {
  const ForceSection& section = of.rows->layout().forces;
  if (section.columns.empty()) {
    throw NotWanted("forces: the scene does not want it; add \"forces\" to \"want\"");
  }
  const auto block = [&](std::size_t number) {
    return forces_by_names(section.columns,
                           [&](std::size_t column, const std::vector<std::ptrdiff_t>& shape) {
                             return numbers_at(of, section.block(number) + column, shape, owner);
                           });
  };
  py::dict result = block(0);
  result["reason"] = of.is_one()
                         ? py::object(py::str(of.rows->reasons()[static_cast<std::size_t>(of.row)]))
                         : py::object(tuple_of(of.rows->reasons()));
  if (!section.parameters.empty()) {
    py::dict sensitivity;
    std::size_t number = 0;
    for (const std::string& parameter : section.parameters) {
      sensitivity[py::str(parameter)] = block(++number);
    }
    result["sensitivity"] = sensitivity;
    result["worst_case"] = block(++number);
    result["rss"] = block(++number);
  }
  return result;
}

}  // namespace assur::python
