// Reads requested results, reported parts, the reference, the sweep and the covariance.
#include <algorithm>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>

#include "description/refusals.hpp"
#include "loads_and_requests.hpp"

namespace assur::mechanism::file {

namespace {

class RequestReader {
 public:
  RequestReader(const SceneJson& root, Mechanism& mechanism, const DrawnMechanism& drawn,
                Request& request)
      : root_(root), mechanism_(mechanism), drawn_(drawn), request_(request) {}

  void read() {
    read_want();
    read_report();
    read_reference();
    read_redundancy();
    read_sweep();
    read_covariance();
  }

 private:
  void read_want() {
    if (!root_.contains("want")) {
      return;
    }
    if (!root_["want"].is_array()) {
      throw MechanismError(
          "want",
          "expected a list of position, velocity, acceleration, sensitivity, forces, "
          "dynamics, coefficients");
    }
    Want& want = request_.want;
    want = {false, false, false, false};
    const std::vector<std::string> known = {"position", "velocity", "acceleration", "sensitivity",
                                            "forces",   "dynamics", "coefficients"};
    const std::array<bool*, 7> flags = {&want.position,    &want.velocity, &want.acceleration,
                                        &want.sensitivity, &want.forces,   &want.dynamics,
                                        &want.coefficients};
    for (std::size_t index = 0; index < root_["want"].size(); ++index) {
      const std::string part = "want[" + std::to_string(index) + "]";
      const std::string wish = text_of(root_["want"][index], part);
      const auto found = std::find(known.begin(), known.end(), wish);
      if (found == known.end()) {
        throw MechanismError(part, "no such result " + text::in_quotes(wish) +
                                       text::suggestion_or_choice(wish, known));
      }
      bool& flag = *flags[static_cast<std::size_t>(found - known.begin())];
      if (flag) {
        throw MechanismError(part, text::in_quotes(wish) + " occurs twice; leave one out");
      }
      flag = true;
    }
  }

  void read_report() {
    if (!root_.contains("report")) {
      return;
    }
    const SceneJson& value = root_["report"];
    expect_object(value, "report");
    expect_keys(value, "report", report_keys);
    request_.reported.links = listed_parts(value, "links", mechanism_.links(), "link");
    request_.reported.joints = listed_parts(value, "joints", mechanism_.joints(), "joint");
    if (request_.reported.joints && !request_.want.forces && !request_.want.coefficients) {
      std::ranges::for_each(*request_.reported.joints,
                            [this](JointIndex joint) { expect_slide(mechanism_.joints()[joint]); });
    }
  }

  static void expect_slide(const Joint& joint) {
    if (joint.type == JointType::revolute) {
      throw MechanismError("report.joints", "the joint " + text::in_quotes(joint.name) +
                                                " is revolute and has no displacement; report " +
                                                "prismatic joints, pins in slots, or links, or " +
                                                "want forces");
    }
  }

  void read_reference() {
    if (!root_.contains("reference")) {
      drawn_.refer(request_);
      return;
    }
    const SceneJson& value = root_["reference"];
    expect_object(value, "reference");
    for (const auto& [name, angle] : value.items()) {
      const std::string part = "reference." + name;
      const LinkIndex link = description::part_named(mechanism_.links(), name, "link", "reference");
      request_.reference.push_back({link, mechanism_.add_number(number_of(angle, part), part)});
    }
  }

  void read_redundancy() {
    if (!root_.contains("redundancy")) {
      return;
    }
    const SceneJson& value = root_["redundancy"];
    expect_object(value, "redundancy");
    expect_keys(value, "redundancy", redundancy_keys);
    const std::string part = "redundancy.tolerance";
    request_.redundancy_tolerance =
        mechanism_.add_number(number_of(required(value, "tolerance", "redundancy"), part), part);
  }

  template <typename Key, typename Part>
  static std::optional<std::vector<Key>> listed_parts(const SceneJson& report,
                                                      const std::string& key,
                                                      const Table<Key, Part>& parts,
                                                      const std::string& what) {
    if (!report.contains(key)) {
      return std::nullopt;
    }
    const std::string list = "report." + key;
    if (!report[key].is_array()) {
      throw MechanismError(list, "expected a list of the names of " + key);
    }
    std::vector<Key> result;
    for (std::size_t index = 0; index < report[key].size(); ++index) {
      const std::string part = list + "[" + std::to_string(index) + "]";
      const std::string name = text_of(report[key][index], part);
      result.push_back(description::part_named(parts, name, what, part));
    }
    return result;
  }

  void read_sweep() {
    if (!root_.contains("sweep")) {
      return;
    }
    const SceneJson& value = root_["sweep"];
    expect_object(value, "sweep");
    expect_keys(value, "sweep", sweep_keys);
    Sweep sweep;
    sweep.parameter = mechanism_.parameter_named(
        text_of(required(value, "parameter", "sweep"), "sweep.parameter"), "sweep.parameter");
    const auto end = [&](const std::string& key) {
      const std::string part = "sweep." + key;
      return mechanism_.add_number(number_of(required(value, key, "sweep"), part), part);
    };
    sweep.from = end("from");
    sweep.to = end("to");
    const SceneJson& count = required(value, "count", "sweep");
    if (!count.is_number_integer() || count.get<double>() < 1 || count.get<double>() > 1e7) {
      throw MechanismError("sweep.count", "expected a whole number from 1 to 10000000");
    }
    sweep.count = count.get<int>();
    request_.sweep = sweep;
  }

  void read_covariance() {
    if (!root_.contains("covariance")) {
      return;
    }
    const SceneJson& value = root_["covariance"];
    expect_object(value, "covariance");
    expect_keys(value, "covariance", covariance_keys);
    const SceneJson& parameters = required(value, "parameters", "covariance");
    if (!parameters.is_array() || parameters.empty()) {
      throw MechanismError("covariance.parameters",
                           "expected one or more names of parameters [\"AB\", ...]");
    }
    Covariance covariance;
    for (std::size_t index = 0; index < parameters.size(); ++index) {
      const std::string part = "covariance.parameters[" + std::to_string(index) + "]";
      const std::string name = text_of(parameters[index], part);
      const ParameterIndex parameter = mechanism_.parameter_named(name, part);
      if (std::find(covariance.parameters.begin(), covariance.parameters.end(), parameter) !=
          covariance.parameters.end()) {
        throw MechanismError(part, "the parameter " + text::in_quotes(name) + " occurs twice");
      }
      covariance.parameters.push_back(parameter);
    }
    const SceneJson& matrix = required(value, "matrix", "covariance");
    const std::string size = std::to_string(parameters.size());
    if (!matrix.is_array() || matrix.size() != parameters.size()) {
      throw MechanismError("covariance.matrix",
                           "expected a row for each of the parameters, " + size + " in all");
    }
    for (std::size_t row = 0; row < matrix.size(); ++row) {
      const std::string part = "covariance.matrix[" + std::to_string(row) + "]";
      if (!matrix[row].is_array() || matrix[row].size() != parameters.size()) {
        throw MechanismError(part,
                             "expected a number for each of the parameters, " + size + " in all");
      }
      covariance.matrix.emplace_back();
      for (std::size_t column = 0; column < parameters.size(); ++column) {
        const std::string entry = part + "[" + std::to_string(column) + "]";
        covariance.matrix.back().push_back(
            mechanism_.add_number(number_of(matrix[row][column], entry), entry));
      }
    }
    request_.covariance = std::move(covariance);
  }

  const SceneJson& root_;
  Mechanism& mechanism_;
  const DrawnMechanism& drawn_;
  Request& request_;
};

}  // namespace

void read_request(const SceneJson& root, Mechanism& mechanism, const DrawnMechanism& drawn,
                  Request& request) {
  RequestReader(root, mechanism, drawn, request).read();
}

}  // namespace assur::mechanism::file
