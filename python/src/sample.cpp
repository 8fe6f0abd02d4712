// Sampling of a scene's tolerances: arrays of outputs under random deviations, from a seed.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <assur/mechanism/campaign.hpp>
#include <assur/text/counts.hpp>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <thread>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "forces.hpp"
#include "given.hpp"
#include "long_call.hpp"
#include "pickling.hpp"
#include "plan.hpp"
#include "tables.hpp"

namespace assur::python {

namespace {

using mechanism::NominalPoint;
using mechanism::Sampling;

constexpr std::size_t columns_before_outputs = 2;  // the sample, and its outcome

/// The arguments of a sampling campaign.
struct SampleOrder {
  SharedScene scene;
  std::size_t branch;
  std::uint64_t seed, count;
  mechanism::DeviationLaw law;

  [[nodiscard]] Sampling sampling() const {
    return {scene->mechanism, scene->request, branch, seed, count, law};
  }
};

/// Rows of a campaign.
struct Sampled {
  SampleOrder order;
  SharedScene scene;
  Sampling sampling;
  std::uint64_t count;
  std::size_t width = 0;
  std::vector<double> rows = {};
  std::vector<std::uint8_t> outcome = {};
};

void expect_count(std::uint64_t count, std::size_t width) {
  if (count == 0 || count > std::vector<double>().max_size() / width) {
    throw ShapeError(
        "count: expected a whole number from 1, up to as many samples as memory holds");
  }
}

/// A scene with other values of some parameters.
SharedScene scene_with(const SharedScene& scene, const Given& replaced) {
  if (replaced.empty()) {
    return scene;
  }
  std::vector<std::string> settings = scene->source.settings;
  const std::vector<std::string> more = settings_of(replaced);
  settings.insert(settings.end(), more.begin(), more.end());
  const OthersRun others_run;
  return scene_of(scene->source.text, scene->file, settings);
}

void find_outcomes(Sampled& samples) {
  samples.outcome.reserve(samples.count);
  for (std::size_t at = 1; at < samples.rows.size(); at += samples.width) {
    samples.outcome.push_back(static_cast<std::uint8_t>(samples.rows[at]));
  }
}

/// The law by its name, or by an array of deviations for each of some parameters.
mechanism::DeviationLaw law_given(const ReadScene& scene, const py::object& of,
                                  std::uint64_t count) {
  using Kind = mechanism::DeviationLaw::Kind;
  if (PyUnicode_Check(of.ptr()) != 0) {
    static constexpr std::array<std::pair<std::string_view, Kind>, 3> laws{
        {{"uniform", Kind::uniform}, {"normal", Kind::normal}, {"covariance", Kind::covariance}}};
    const std::string name = utf8_of(of, "deviations");
    for (const auto& [word, kind] : laws) {
      if (word == name) {
        return {kind, {}, {}};
      }
    }
  }
  if (!py::isinstance<py::dict>(of)) {
    throw ShapeError(
        "deviations: expected 'uniform', 'normal', 'covariance', or a dictionary with an array of "
        "deviations for each of some parameters, not " +
        (PyUnicode_Check(of.ptr()) != 0 ? py::cast<std::string>(py::repr(of)) : type_of(of)));
  }
  const Columns columns = columns_of(scene.mechanism, given(of, py::kwargs()));
  if (static_cast<std::uint64_t>(columns.count) != count) {
    throw ShapeError("deviations: expected " + text::with_noun(count, "value") +
                     " for each parameter, not " + std::to_string(columns.count));
  }
  mechanism::DeviationLaw law{Kind::given, {}, {}};
  for (const Columns::Column& column : columns.columns) {
    law.parameters.push_back(column.parameter);
  }
  for (py::ssize_t sample = 0; sample < columns.count; ++sample) {
    for (const auto& [parameter, value] : columns.row(sample)) {
      if (!std::isfinite(value)) {
        throw ShapeError(scene.mechanism.parameters()[parameter].name +
                         ": the deviations must be finite numbers");
      }
      law.given.push_back(value);
    }
  }
  return law;
}

std::shared_ptr<Sampled> sampled(const py::object& scene_of, const py::object& count_of,
                                 const py::object& seed_of, const py::object& branch_of,
                                 const py::object& threads_of, const py::object& deviations_of,
                                 const py::object& values, const py::kwargs& keywords) {
  const std::uint64_t count = whole_number(count_of, "count");
  const std::uint64_t seed = whole_number(seed_of, "seed");
  const auto branch = static_cast<std::size_t>(place_number(branch_of, "branch"));
  const int threads = place_number(threads_of, "threads");
  const SharedScene scene = scene_with(scene_given(scene_of), given(values, keywords));
  const SampleOrder order{scene, branch, seed, count, law_given(*scene, deviations_of, count)};
  LongCall call;
  return in_scene(scene->file, [&] {
    auto result = std::make_shared<Sampled>(Sampled{order, scene, order.sampling(), count});
    const mechanism::Campaign campaign = result->sampling.campaign();
    result->width = campaign.columns.size();
    expect_count(count, result->width);
    result->rows.reserve(count * result->width);
    const auto all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    mechanism::run_campaign(campaign, {0, count}, threads > 0 ? threads : all, nullptr,
                            [&](const mechanism::RowBlock& block) {
                              call.go_on();
                              result->rows.insert(result->rows.end(), block.rows.begin(),
                                                  block.rows.end());
                            });
    find_outcomes(*result);
    return result;
  });
}

/// Stores the rows, and the data from which the rest is rebuilt.
py::tuple sampled_state(const Sampled& samples) {
  const SampleOrder& order = samples.order;
  std::vector<std::string> names;
  for (const mechanism::ParameterIndex parameter : order.law.parameters) {
    names.push_back(order.scene->mechanism.parameters()[parameter].name);
  }
  return py::make_tuple(order.scene, order.branch, order.seed, order.count,
                        static_cast<int>(order.law.kind), names, bytes_of(order.law.given),
                        samples.width, bytes_of(samples.rows));
}

std::shared_ptr<Sampled> sampled_in(const py::tuple& state) {
  const auto scene = state[0].cast<SharedScene>();
  mechanism::DeviationLaw law{static_cast<mechanism::DeviationLaw::Kind>(state[4].cast<int>()),
                              {},
                              numbers_in<double>(state[6])};
  for (const std::string& name : state[5].cast<std::vector<std::string>>()) {
    law.parameters.push_back(scene->mechanism.parameter_named(name));
  }
  const SampleOrder order{scene, state[1].cast<std::size_t>(), state[2].cast<std::uint64_t>(),
                          state[3].cast<std::uint64_t>(), law};
  auto result = std::make_shared<Sampled>(Sampled{order, scene, order.sampling(), order.count});
  result->width = state[7].cast<std::size_t>();
  result->rows = numbers_in<double>(state[8]);
  find_outcomes(*result);
  return result;
}

std::string repr_of(const Sampled& samples) {
  const auto regular =
      std::ranges::count(samples.outcome, static_cast<std::uint8_t>(mechanism::Outcome::regular));
  return "<assur.Samples: " + text::with_noun(samples.count, "sample") + ", " +
         std::to_string(regular) + " regular>";
}

py::dict positions_of(const py::object& self) {
  const auto& samples = self.cast<const Sampled&>();
  py::dict positions;
  std::size_t place = columns_before_outputs;
  for (const NominalPoint& point : samples.sampling.nominal()) {
    positions[py::str(point.name)] =
        view(py::dtype::of<double>(), {static_cast<py::ssize_t>(samples.count), 2},
             {static_cast<py::ssize_t>(samples.width * sizeof(double)), sizeof(double)},
             samples.rows.data() + place, self);
    place += 2;
  }
  return positions;
}

template <typename Vector>
py::object array_of(const Vector& numbers, std::vector<py::ssize_t> shape) {
  py::array_t<double> array(std::move(shape));
  std::copy_n(numbers.data(), numbers.size(), array.mutable_data());  // symmetric, or a vector
  return array;
}

/// The columns of the requested forces. Throws NotWanted if there are none.
std::vector<mechanism::ForceColumn> force_columns_of(const Sampled& samples) {
  std::vector<mechanism::ForceColumn> columns;
  for (const mechanism::NominalForce& force : samples.sampling.nominal_forces()) {
    columns.push_back(force.column);
  }
  if (columns.empty()) {
    throw NotWanted("forces: the scene does not want it; add \"forces\" to \"want\"");
  }
  return columns;
}

py::dict forces_of_samples(const py::object& self) {
  const auto& samples = self.cast<const Sampled&>();
  const std::vector<mechanism::ForceColumn> columns = force_columns_of(samples);
  const double* const first = samples.rows.data() + samples.width - columns.size();
  return forces_by_names(
      columns, [&](std::size_t column, const std::vector<std::ptrdiff_t>& shape) {
        std::vector<py::ssize_t> extents{static_cast<py::ssize_t>(samples.count)};
        std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(samples.width * sizeof(double))};
        for (const std::ptrdiff_t extent : shape) {
          extents.push_back(extent);
          strides.push_back(sizeof(double));
        }
        return view(py::dtype::of<double>(), extents, strides, first + column, self);
      });
}

/// The forces at the nominal values, with worst case and rss.
py::dict nominal_forces_of(const Sampled& samples) {
  const std::vector<mechanism::ForceColumn> columns = force_columns_of(samples);
  const auto block = [&](double mechanism::NominalForce::*number) {
    return forces_by_names(
        columns, [&](std::size_t column, const std::vector<std::ptrdiff_t>& shape) -> py::object {
          const auto& all = samples.sampling.nominal_forces();
          if (shape.empty()) {
            return py::float_(all[column].*number);
          }
          return array_of(Eigen::Vector2d(all[column].*number, all[column + 1].*number), {2});
        });
  };
  py::dict result = block(&mechanism::NominalForce::number);
  result["worst_case"] = block(&mechanism::NominalForce::worst_case);
  result["rss"] = block(&mechanism::NominalForce::rss);
  return result;
}

py::dict nominal_of(const Sampled& samples) {
  py::dict nominal;
  for (const NominalPoint& point : samples.sampling.nominal()) {
    nominal[py::str(point.name)] = point;
  }
  return nominal;
}

py::dict deviations_of(const Sampled& samples) {
  py::dict deviations;
  for (const mechanism::Deviation& deviation : samples.sampling.deviations()) {
    const auto& parameter = samples.scene->mechanism.parameters()[deviation.parameter];
    deviations[py::str(parameter.name)] = deviation.half_width;
  }
  return deviations;
}

py::array parameters_of_samples(const Sampled& samples) {
  const std::size_t width = samples.sampling.deviations().size();
  py::array_t<double> array({static_cast<std::size_t>(samples.count), width});
  double* to = array.mutable_data();
  for (std::uint64_t sample = 0; sample < samples.count; ++sample) {
    to = std::ranges::copy(samples.sampling.parameters_of(sample), to).out;
  }
  return array;
}

std::string reason_of_sample(const Sampled& samples, const py::object& of) {
  const std::uint64_t sample = whole_number(of, "sample");
  if (sample >= samples.count) {
    throw py::index_error("sample " + std::to_string(sample) + ": the number of samples is " +
                          std::to_string(samples.count));
  }
  return samples.sampling.reason_of(sample);
}

py::object array_of(const std::optional<Eigen::Vector2d>& numbers) {
  return numbers ? array_of(*numbers, {2}) : py::none();
}

void bind_nominal(py::module_& module) {
  py::class_<NominalPoint>(
      module, "NominalPoint",
      "An output at the nominal values, with the deviations that derivatives there predict. These\n"
      "are None where the derivatives are not known.")
      .def_property_readonly(
          "position", [](const NominalPoint& point) { return array_of(point.position, {2}); },
          "Array of shape (2,): x, y in the scene's unit.")
      .def_property_readonly(
          "worst_case", [](const NominalPoint& point) { return array_of(point.worst_case); },
          "Array of shape (2,), or None: largest deviation of x and y, the sum of |derivative| "
          "times\n"
          "half-width.")
      .def_property_readonly(
          "rss", [](const NominalPoint& point) { return array_of(point.rss); },
          "Array of shape (2,), or None: root sum square of derivative times half-width, for x and "
          "y.")
      .def_property_readonly(
          "covariance",
          [](const NominalPoint& point) {
            return point.spread ? array_of(point.spread->covariance, {2, 2}) : py::none();
          },
          "Array of shape (2, 2), or None: covariance of x and y by first derivatives, in the "
          "square\n"
          "of the scene's unit.")
      .def_property_readonly(
          "mean_shift",
          [](const NominalPoint& point) {
            return point.spread ? array_of(point.spread->mean_shift, {2}) : py::none();
          },
          "Array of shape (2,), or None: shift of the mean of x and y by second derivatives, in "
          "the\n"
          "scene's unit.");
}

}  // namespace

void bind_sample(py::module_& module) {
  bind_nominal(module);
  py::class_<Sampled, std::shared_ptr<Sampled>>(
      module, "Samples",
      "Outputs, and forces where they are wanted, under random deviations within the tolerances.")
      .def_property_readonly(
          "positions", positions_of,
          "dict of arrays of shape (count, 2): x, y of each output, by its name, in the scene's\n"
          "unit; NaN where a sample has no configuration.")
      .def_property_readonly(
          "forces", forces_of_samples,
          "dict: the efforts of drivers, the forces in joints and the resultant on the ground, in "
          "the\n"
          "form of States.forces, with the samples as the first axis of every array; NaN where one "
          "is not\n"
          "determined. Raises NotWanted.")
      .def_property_readonly(
          "nominal_forces", nominal_forces_of,
          "dict: the same at the nominal values, and, each in the same form, the worst_case and "
          "rss that\n"
          "derivatives there predict. Raises NotWanted.")
      .def_property_readonly(
          "outcome",
          [](const py::object& self) { return view_of(self.cast<const Sampled&>().outcome, self); },
          "Array of shape (count,): the Outcome of each sample.")
      .def_property_readonly(
          "nominal", nominal_of,
          "dict of NominalPoint: the outputs at the nominal values, by their names.")
      .def_property_readonly("deviations", deviations_of,
                             "dict of float: the half-widths of the deviating parameters; of a "
                             "covariance the standard\n"
                             "deviations, of given deviations the largest.")
      .def_property_readonly("parameters", parameters_of_samples,
                             "Array of shape (count, len(deviations)): the values of the deviating "
                             "parameters. They are\n"
                             "computed at every access.")
      .def(py::pickle([](const Sampled& samples) { return sampled_state(samples); },
                      [](const py::tuple& state) { return sampled_in(state); }))
      .def("__repr__", repr_of)
      .def("to_frame", frame_of, frame_doc)
      .def("reason", reason_of_sample, py::arg("sample"), py::pos_only(),
           "reason(self, sample, /)\n--\n\n"
           "Returns the reason, as str, why a sample, from 0, has no configuration. Raises "
           "IndexError\n"
           "beyond the last sample.")
      .def(
          "__len__", [](const Sampled& samples) { return samples.count; },
          "The number of samples.");
  module.def(
      "sample", sampled, py::arg("scene"), py::arg("count"), py::arg("seed"), py::arg("branch") = 0,
      py::arg("threads") = 0, py::arg("deviations") = "uniform", py::arg("values") = py::none(),
      "sample(scene, count, seed, branch=0, threads=0, deviations='uniform', values=None, "
      "**parameters)\n--\n\n"
      "Returns outputs under random deviations within the scene's tolerances, as Samples: the\n"
      "same numbers as `assur sample` with this seed, on any number of threads.\n\n"
      "deviations: 'uniform' within the tolerances t; 'normal' with the standard deviations t / "
      "3;\n"
      "'covariance': normal with the scene's covariance; or a dictionary with an array of shape\n"
      "(count,) for each of some parameters, whose deviations these are.\n"
      "values, and keywords: numbers or expressions for parameters, as read_scene takes them.\n"
      "branch: the number of the nominal configuration, from 1; for 0 the one nearest to the\n"
      "scene's reference, or else the first. threads: 0 for as many as the machine has.\n\n"
      "Raises SceneError where nothing deviates, nothing is an output, or there is no such\n"
      "configuration. Ctrl-C ends it.");
}

}  // namespace assur::python
