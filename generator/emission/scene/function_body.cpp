#include "emission/scene/function_body.hpp"

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <cmath>
#include <functional>

namespace assur::generator::emission::scene {

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

cpp::Block FunctionBody::block(bool has_drivers) const {
  const std::vector<SceneNumbers::NamedStep>& named = numbers_.steps(order_);
  std::vector<bool> is_declared(named.size(), false);
  cpp::Block readers;
  // A step may read declarations in statements before its first reader, and earlier steps.
  const std::function<void(const cpp::Statement&)> add_with_steps =
      [&](const cpp::Statement& statement) {
        for (std::size_t step = 0; step < named.size(); ++step) {
          if (!is_declared[step] && cpp::reads(statement, named[step].name)) {
            is_declared[step] = true;
            add_with_steps(cpp::declared("const Scalar", cpp::variable(named[step].name),
                                         named[step].formula));
          }
        }
        readers.push_back(statement);
      };
  std::ranges::for_each(statements_, add_with_steps);
  cpp::Block all;
  const cpp::Expression placed = cpp::variable("placed");
  if (cpp::reads(readers, "p")) {
    all.push_back(cpp::declared("const Parameters<Scalar>&", cpp::variable("p"),
                                placed.member("parameters")));
  }
  if (!has_drivers && cpp::reads(readers, "drivers")) {
    all.push_back(cpp::declared("const Drivers<Scalar>&", cpp::variable("drivers"),
                                placed.member("drivers")));
  }
  all.insert(all.end(), readers.begin(), readers.end());
  return all;
}

cpp::Block FunctionBody::take_from(std::size_t first) {
  const auto begin = std::next(statements_.begin(), static_cast<std::ptrdiff_t>(first));
  cpp::Block taken(begin, statements_.end());
  statements_.erase(begin, statements_.end());
  return taken;
}

std::set<std::string> FunctionBody::variables_read(const cpp::Block& statements) const {
  FunctionBody body(parameters_, numbers_, order_);
  body.add(statements);
  std::set<std::string> variables;
  for (const cpp::Statement& statement : body.block()) {
    cpp::visit(statement, [&variables](const cpp::Expression& part) {
      if (part.form == cpp::Expression::Form::variable) {
        variables.insert(part.text);
      }
    });
  }
  return variables;
}

cpp::Expression FunctionBody::number(const SceneNumber& number) const {
  return numbers_.varies(number) ? numbers_.expression(number) : cpp::number(number.value());
}

cpp::Expression FunctionBody::direction(const Direction<SceneNumber>& direction) const {
  return cpp::braces("", {number(direction.cos), number(direction.sin)});
}

cpp::Expression FunctionBody::point(const std::string& name, const OptionalExpression& frame,
                                    const SceneNumber& x, const SceneNumber& y) {
  const std::vector<Gradient> gradients = {gradient_of(x), gradient_of(y)};
  const std::vector<cpp::Expression> values = {number(x), number(y)};
  if (std::ranges::all_of(gradients, is_zero) && !moves(x) && !moves(y)) {
    const bool is_origin = values[0].is_number(0) && values[1].is_number(0);
    const std::vector<cpp::Expression> place = is_origin ? std::vector<cpp::Expression>{} : values;
    return frame ? cpp::call("support::point_in",
                             {*frame, cpp::braces("support::Place<Scalar>", place)})
                 : cpp::braces(cpp::alias("LinkPoint"), place);
  }
  const cpp::Expression point = local(name);
  add(cpp::declared(cpp::alias("LinkPoint"), point));
  add(cpp::assigned(point.member("x"), values[0]));
  add(cpp::assigned(point.member("y"), values[1]));
  add_gradients(point, gradients);
  add_rates(point, 0, x);
  add_rates(point, 1, y);
  return frame ? cpp::call("support::point_in", {*frame, point}) : point;
}

OptionalExpression FunctionBody::frame(const std::string& name, const Pose<SceneNumber>& pose) {
  const std::vector<Gradient> gradients = {gradient_of(pose.x), gradient_of(pose.y),
                                           gradient_of(pose.direction)};
  const bool has_gradient = !std::ranges::all_of(gradients, is_zero);
  const std::array<cpp::Expression, 2> turned = {number(pose.direction.cos),
                                                 number(pose.direction.sin)};
  const std::array<cpp::Expression, 2> origin = {number(pose.x), number(pose.y)};
  const bool is_own = origin[0].is_number(0) && origin[1].is_number(0) && turned[0].is_number(1) &&
                      turned[1].is_number(0);
  const bool is_moving = moves(pose.x) || moves(pose.y) || moves(pose.direction);
  if (!has_gradient && !is_moving && is_own) {
    return std::nullopt;
  }
  cpp::Expression frame = local(name);
  add(cpp::declared(cpp::alias("LinkFrame"), frame));
  add(cpp::assigned(
      frame.member("pose"),
      cpp::braces("", {origin[0], origin[1], cpp::braces("", {turned[0], turned[1]})})));
  add_gradients(frame, gradients);
  add_rates(frame, 0, pose.x);
  add_rates(frame, 1, pose.y);
  add_rates(frame, 2, pose.direction);
  return frame;
}

cpp::Expression FunctionBody::local(const std::string& name) {
  cpp::Expression result = cpp::variable(name);
  result.form = cpp::Expression::Form::local;
  result.local = ++locals_;
  return result;
}

Gradient FunctionBody::gradient_of(const SceneNumber& number) const {
  return numbers_.varies(number) ? numbers_.gradient(number) : constant_gradient(number.number());
}

Gradient FunctionBody::gradient_of(const Direction<SceneNumber>& direction) const {
  if (!numbers_.varies(direction)) {
    return constant_gradient(
        angle_of(Direction<mechanism::Dual>{direction.cos.number(), direction.sin.number()}));
  }
  return numbers_.gradient(direction);
}

Gradient FunctionBody::constant_gradient(const mechanism::Dual& number) const {
  Gradient slopes;
  for (const double slope : parameters_.gradient(number)) {
    slopes.push_back(slope == 0 ? OptionalExpression()
                     : std::isnan(slope)
                         ? cpp::call(cpp::scalar_only("std::numeric_limits<Scalar>::quiet_NaN"))
                         : cpp::number(slope));
  }
  return slopes;
}

bool FunctionBody::is_zero(const Gradient& gradient) {
  return std::ranges::none_of(gradient,
                              [](const OptionalExpression& slope) { return slope.has_value(); });
}

OptionalExpression FunctionBody::declared_gradient(const std::string& name,
                                                   const Gradient& gradient) {
  if (is_zero(gradient)) {
    return std::nullopt;
  }
  cpp::Expression row = local(name);
  const cpp::Name type = cpp::alias("ParameterRow");
  add(cpp::declared(type, row, cpp::call({"ParameterRow::Zero", type.alias})));
  add_gradient(row, {}, gradient);
  return row;
}

void FunctionBody::add_gradient(const cpp::Expression& target,
                                const std::vector<cpp::Expression>& places,
                                const Gradient& gradient) {
  for (std::size_t place = 0; place < gradient.size(); ++place) {
    if (gradient[place]) {
      std::vector<cpp::Expression> entry = places;
      entry.push_back(cpp::word(place));
      add(cpp::assigned(target.at(std::move(entry)), *gradient[place], parameters_.names()[place]));
    }
  }
}

void FunctionBody::add_gradients(const cpp::Expression& target, const std::vector<Gradient>& rows) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    add_gradient(target.member("gradient"), {cpp::word(row)}, rows[row]);
  }
}

cpp::Expression nested_frames(const std::vector<OptionalExpression>& frames) {
  OptionalExpression nested;
  for (const OptionalExpression& frame : frames) {
    if (frame) {
      nested = nested ? cpp::call("support::frame_in", {*nested, *frame}) : *frame;
    }
  }
  return nested ? *nested : cpp::braces(cpp::alias("LinkFrame"));
}

}  // namespace assur::generator::emission::scene
