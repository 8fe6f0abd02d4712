// Turns the outputs, results, sweep and covariance that a scene asks for into those of the scene.
#include <array>

#include "scene/scene_parts.hpp"
#include "scene/suggestion.hpp"

namespace assur::generator {

namespace {

class RequestReader {
 public:
  RequestReader(const JsonValues& values, Scene& scene) : values_(values), scene_(scene) {}

  void read(const SceneJson& root) {
    read_outputs(root);
    read_want(root);
    read_sweep(root);
    read_covariance(root);
  }

 private:
  void read_outputs(const SceneJson& root) {
    if (!root.contains("outputs")) {
      return;
    }
    values_.expect_object(root["outputs"], "outputs");
    for (const auto& [name, value] : root["outputs"].items()) {
      const std::string where = "outputs." + name;
      const FeatureReference point = feature_reference(value, where, values_, scene_);
      if (scene_.feature(point).line) {
        values_.fail(where, "an output is a point, and this feature is a line");
      }
      scene_.outputs.push_back({name, point});
    }
  }

  void read_want(const SceneJson& root) {
    if (!root.contains("want")) {
      return;
    }
    if (!root["want"].is_array()) {
      values_.fail("want", "expected a list of position, velocity, acceleration, sensitivity");
    }
    scene_.want = {false, false, false, false};
    const std::vector<std::string> known = {"position", "velocity", "acceleration", "sensitivity"};
    for (std::size_t index = 0; index < root["want"].size(); ++index) {
      const std::string where = "want[" + std::to_string(index) + "]";
      const std::string wish = values_.text_of(root["want"][index], where);
      const std::array<bool*, 4> flags = {&scene_.want.position, &scene_.want.velocity,
                                          &scene_.want.acceleration, &scene_.want.sensitivity};
      const auto found = std::find(known.begin(), known.end(), wish);
      if (found == known.end()) {
        values_.fail(where, "no such result " + quoted(wish) + suggestion(wish, known));
      }
      *flags[static_cast<std::size_t>(found - known.begin())] = true;
    }
  }

  void read_sweep(const SceneJson& root) {
    if (!root.contains("sweep")) {
      return;
    }
    const SceneJson& value = root["sweep"];
    values_.expect_object(value, "sweep");
    values_.expect_keys(value, "sweep", {"parameter", "from", "to", "count"});
    SceneSweep sweep;
    const std::string name =
        values_.text_of(values_.required(value, "parameter", "sweep"), "sweep.parameter");
    sweep.parameter = index_of(scene_.parameters, name);
    if (sweep.parameter < 0) {
      values_.fail("sweep.parameter", "no parameter named " + quoted(name) +
                                          suggestion(name, values_.parameter_names()));
    }
    sweep.from = values_.number(values_.required(value, "from", "sweep"), "sweep.from");
    sweep.to = values_.number(values_.required(value, "to", "sweep"), "sweep.to");
    const SceneJson& count = values_.required(value, "count", "sweep");
    if (!count.is_number_integer() || count.get<double>() < 1 || count.get<double>() > 1e7) {
      values_.fail("sweep.count", "expected a whole number from 1 to 10000000");
    }
    sweep.count = count.get<int>();
    scene_.sweep = std::move(sweep);
  }

  void read_covariance(const SceneJson& root) {
    if (!root.contains("covariance")) {
      return;
    }
    const SceneJson& value = root["covariance"];
    values_.expect_object(value, "covariance");
    values_.expect_keys(value, "covariance", {"parameters", "matrix"});
    SceneCovariance covariance;
    const SceneJson& parameters = values_.required(value, "parameters", "covariance");
    if (!parameters.is_array() || parameters.empty()) {
      values_.fail("covariance.parameters",
                   "expected one or more names of parameters [\"AB\", ...]");
    }
    for (std::size_t index = 0; index < parameters.size(); ++index) {
      const std::string where = "covariance.parameters[" + std::to_string(index) + "]";
      const std::string name = values_.text_of(parameters[index], where);
      const int parameter = index_of(scene_.parameters, name);
      if (parameter < 0) {
        values_.fail(where, "no parameter named " + quoted(name) +
                                suggestion(name, values_.parameter_names()));
      }
      if (std::find(covariance.parameters.begin(), covariance.parameters.end(), parameter) !=
          covariance.parameters.end()) {
        values_.fail(where, "the parameter " + quoted(name) + " stands twice");
      }
      covariance.parameters.push_back(parameter);
    }
    const SceneJson& matrix = values_.required(value, "matrix", "covariance");
    const std::string size = std::to_string(parameters.size());
    if (!matrix.is_array() || matrix.size() != parameters.size()) {
      values_.fail("covariance.matrix",
                   "expected a row for each of the parameters, " + size + " in all");
    }
    for (std::size_t row = 0; row < matrix.size(); ++row) {
      const std::string where = "covariance.matrix[" + std::to_string(row) + "]";
      if (!matrix[row].is_array() || matrix[row].size() != parameters.size()) {
        values_.fail(where, "expected a number for each of the parameters, " + size + " in all");
      }
      covariance.matrix.emplace_back();
      for (std::size_t column = 0; column < parameters.size(); ++column) {
        covariance.matrix.back().push_back(
            values_.number(matrix[row][column], where + "[" + std::to_string(column) + "]"));
      }
    }
    scene_.covariance = std::move(covariance);
  }

  const JsonValues& values_;
  Scene& scene_;
};

}  // namespace

void read_requests(const SceneJson& root, const JsonValues& values, Scene& scene) {
  RequestReader(values, scene).read(root);
}

}  // namespace assur::generator
