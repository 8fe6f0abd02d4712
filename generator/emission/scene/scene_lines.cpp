#include "emission/scene/scene_lines.hpp"

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <regex>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::scene {

namespace {

/// Whether a line reads a step such as `root_1`. `root_12` does not count, nor does a member or a
/// parameter in a comment of the same name.
bool reads(const std::string& line, const std::string& step) {
  const std::string code = line.substr(0, line.find("//"));
  const auto belongs = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  for (std::size_t at = code.find(step); at != std::string::npos; at = code.find(step, at + 1)) {
    const std::size_t end = at + step.size();
    const bool begins = at == 0 || (code[at - 1] != '.' && !belongs(code[at - 1]));
    if (begins && (end == code.size() || !belongs(code[end]))) {
      return true;
    }
  }
  return false;
}

/// A statement with its numbers as Scalar, so that a solver in float computes nothing in double.
/// Whole numbers without a point are places and counts, and stay.
std::string in_scalar(const std::string& line) {
  static const std::regex number(R"(([A-Za-z_][\w.]*)|(\d+\.?\d*(?:e[+-]?\d+)?))");
  const std::size_t end = std::min(line.find("//"), line.size());
  std::string result;
  auto from = line.begin();
  const auto code_end = line.begin() + static_cast<std::ptrdiff_t>(end);
  for (std::sregex_iterator at(line.begin(), code_end, number), none; at != none; ++at) {
    const std::string literal = (*at)[2];
    result.append(from, (*at)[0].first);
    result += literal.find_first_of(".e") == std::string::npos ? (*at)[0].str()
                                                               : "Scalar(" + literal + ")";
    from = (*at)[0].second;
  }
  return result.append(from, line.end());
}

}  // namespace

Eigen::VectorXd ModelledParameters::gradient(const mechanism::Dual& quantity) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(count());
  if (quantity.derivatives().size() > 0) {
    Eigen::Index place = 0;
    for (const Eigen::Index column : columns_) {
      result(place++) = quantity.derivatives()(column);
    }
  }
  return result;
}

std::string SceneLines::row_of(const std::vector<std::string>& rates) {
  return "Rates(" + text::joined(rates, ", ", [](const std::string& rate) { return rate; }) + ")";
}

std::vector<std::string> SceneLines::lines(bool has_drivers) const {
  const std::vector<SceneNumbers::NamedStep>& named = numbers_.steps(order_);
  std::vector<bool> is_declared(named.size(), false);
  std::vector<std::string> readers;
  // A step may read declarations in lines before its first reader, and earlier steps.
  const std::function<void(const std::string&)> add_with_steps = [&](const std::string& line) {
    for (std::size_t step = 0; step < named.size(); ++step) {
      if (!is_declared[step] && reads(line, named[step].name)) {
        is_declared[step] = true;
        add_with_steps("const Scalar " + named[step].name + " = " + named[step].formula + ";");
      }
    }
    readers.push_back(line);
  };
  std::ranges::for_each(lines_, add_with_steps);
  const auto any_reads = [&](const std::string& name) {
    return std::any_of(readers.begin(), readers.end(),
                       [&](const std::string& line) { return reads(line, name); });
  };
  std::vector<std::string> all;
  if (any_reads("p")) {
    all.emplace_back("const Parameters<Scalar>& p = placed.parameters;");
  }
  if (!has_drivers && any_reads("drivers")) {
    all.emplace_back("const Drivers<Scalar>& drivers = placed.drivers;");
  }
  std::transform(readers.begin(), readers.end(), std::back_inserter(all), in_scalar);
  return all;
}

bool SceneLines::declares(const std::string& beginning) const {
  return std::any_of(lines_.begin(), lines_.end(),
                     [&](const std::string& line) { return line.starts_with(beginning + " "); });
}

std::string SceneLines::number(const SceneNumber& number) {
  if (!numbers_.varies(number)) {
    return cpp::round_trip(number.value());
  }
  return numbers_.text(number);
}

std::string SceneLines::direction(const Direction<SceneNumber>& direction) {
  return "{" + number(direction.cos) + ", " + number(direction.sin) + "}";
}

std::string SceneLines::point(const std::string& name, const std::string& frame,
                              const SceneNumber& x, const SceneNumber& y) {
  const std::vector<Gradient> gradients = {gradient_of(x), gradient_of(y)};
  const std::array<std::string, 2> values = {number(x), number(y)};
  if (std::all_of(gradients.begin(), gradients.end(), is_zero) && !moves(x) && !moves(y)) {
    const bool is_origin = values[0] == "0.0" && values[1] == "0.0";
    const std::string place = is_origin ? "{}" : "{" + values[0] + ", " + values[1] + "}";
    return frame.empty() ? "LinkPoint" + place
                         : "support::point_in(" + frame + ", support::Place<Scalar>" + place + ")";
  }
  std::string point = declared(name);
  add("LinkPoint " + point + ";");
  add(point + ".x = " + values[0] + ";");
  add(point + ".y = " + values[1] + ";");
  add_gradients(point, gradients);
  add_rates(point, 0, x);
  add_rates(point, 1, y);
  return frame.empty() ? point : "support::point_in(" + frame + ", " + point + ")";
}

std::string SceneLines::frame(const std::string& name, const Pose<SceneNumber>& pose) {
  const std::vector<Gradient> gradients = {gradient_of(pose.x), gradient_of(pose.y),
                                           gradient_of(pose.direction)};
  const bool has_gradient = !std::all_of(gradients.begin(), gradients.end(), is_zero);
  const std::string values =
      number(pose.x) + ", " + number(pose.y) + ", " + direction(pose.direction);
  const bool is_moving = moves(pose.x) || moves(pose.y) || moves(pose.direction);
  if (!has_gradient && !is_moving && values == "0.0, 0.0, {1.0, 0.0}") {
    return "";
  }
  std::string frame = declared(name);
  add("LinkFrame " + frame + ";");
  add(frame + ".pose = {" + values + "};");
  if (has_gradient) {
    add_gradients(frame, gradients);
  }
  add_rates(frame, 0, pose.x);
  add_rates(frame, 1, pose.y);
  add_rates(frame, 2, pose.direction);
  return frame;
}

std::string SceneLines::declared(const std::string& name) {
  taken_.push_back(text::member_names({name}, taken_).front());
  return taken_.back();
}

SceneLines::Gradient SceneLines::gradient_of(const SceneNumber& number) {
  if (!numbers_.varies(number)) {
    return constant_gradient(number.number());
  }
  return numbers_.gradient(number);
}

SceneLines::Gradient SceneLines::gradient_of(const Direction<SceneNumber>& direction) {
  if (!numbers_.varies(direction)) {
    return constant_gradient(
        angle_of(Direction<mechanism::Dual>{direction.cos.number(), direction.sin.number()}));
  }
  return numbers_.gradient(direction);
}

SceneLines::Gradient SceneLines::constant_gradient(const mechanism::Dual& number) const {
  Gradient texts;
  for (const double slope : parameters_.gradient(number)) {
    texts.push_back(slope == 0          ? ""
                    : std::isnan(slope) ? "std::numeric_limits<Scalar>::quiet_NaN()"
                                        : cpp::round_trip(slope));
  }
  return texts;
}

bool SceneLines::is_zero(const Gradient& gradient) {
  return std::all_of(gradient.begin(), gradient.end(),
                     [](const std::string& slope) { return slope.empty(); });
}

std::string SceneLines::declared_gradient(const std::string& name, const Gradient& gradient) {
  if (is_zero(gradient)) {
    return "";
  }
  std::string row = declared(name);
  add("ParameterRow " + row + " = ParameterRow::Zero();");
  add_gradient(row + "(", gradient);
  return row;
}

void SceneLines::add_gradient(const std::string& target, const Gradient& gradient) {
  for (std::size_t place = 0; place < gradient.size(); ++place) {
    if (!gradient[place].empty()) {
      const std::string line = target + std::to_string(place) + ") = " + gradient[place] + ";";
      const std::string comment = "// " + parameters_.names()[place];
      if (line.size() + comment.size() < 90) {
        add(line + "  " + comment);
      } else {
        add(comment);
        add(line);
      }
    }
  }
}

void SceneLines::add_gradients(const std::string& target, const std::vector<Gradient>& rows) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    add_gradient(target + ".gradient(" + std::to_string(row) + ", ", rows[row]);
  }
}

std::string nested_frames(const std::vector<std::string>& frames) {
  std::string text;
  for (const std::string& frame : frames) {
    if (!frame.empty()) {
      text = text.empty() ? frame : "support::frame_in(" + text + ", " + frame + ")";
    }
  }
  return text.empty() ? "LinkFrame{}" : text;
}

}  // namespace assur::generator::emission::scene
