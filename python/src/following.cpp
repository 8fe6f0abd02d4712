#include "following.hpp"

#include "results.hpp"
#include "solved_scene.hpp"

namespace assur::python {

namespace {

py::object taken(py::kwargs& keywords, const char* name) {
  const py::str key(name);
  if (!keywords.contains(key)) {
    return py::none();
  }
  py::object value = keywords[key];
  PyDict_DelItem(keywords.ptr(), key.ptr());
  return value;
}

Place place_of(const PlannedScene& planned, const py::object& value) {
  std::optional<Place> place;
  const PlannedScene* other = nullptr;
  if (py::isinstance<SolvedConfiguration>(value)) {
    const auto& one = value.cast<const SolvedConfiguration&>();
    other = one.solution->planned.get();
    place = {one.solution->replaced, one.solution->number_in_all(one.place)};
  } else if (py::isinstance<SolvedBatch>(value)) {
    const auto& batch = value.cast<const SolvedBatch&>();
    other = batch.planned.get();
    if (!batch.last) {
      throw ShapeError("from_: this batch does not follow a branch, or has no row on it");
    }
    place = batch.last;
  } else {
    throw ShapeError("from_: expected a Configuration, or a Batch that follows a branch, not " +
                     type_of(value));
  }
  if (other != &planned && other->scene != planned.scene) {
    throw ShapeError("from_: this is the result of another scene");
  }
  return *place;
}

}  // namespace

std::optional<Following> following_given(const PlannedScene& planned, py::kwargs& keywords) {
  const py::object branch = taken(keywords, "branch");
  const py::object nearest = taken(keywords, "nearest");
  const py::object from = taken(keywords, "from_");
  const bool is_nearest = !nearest.is_none() && truth(nearest, "nearest");
  if ((branch.is_none() ? 0 : 1) + (is_nearest ? 1 : 0) + (from.is_none() ? 0 : 1) > 1) {
    throw ShapeError("branch, nearest, from_: give one of them");
  }
  if (!branch.is_none()) {
    const int number = place_number(branch, "branch");
    if (number == 0) {
      throw ShapeError(
          "branch: expected a whole number from 1; nearest=True begins at the reference");
    }
    return static_cast<std::size_t>(number);
  }
  if (is_nearest) {
    return NearestToReference{};
  }
  if (!from.is_none()) {
    return place_of(planned, from);
  }
  return std::nullopt;
}

}  // namespace assur::python
