#include "moving_links.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <assur/mechanism/carried_features.hpp>

#include "plan/plan_data.hpp"
#include "values/rates.hpp"

namespace assur::mechanism::forces {

namespace {

MovingPlace turned_place(const Direction<MovingNumber>& direction, const MovingPlace& v) {
  return {direction.cos * v.x - direction.sin * v.y, direction.sin * v.x + direction.cos * v.y};
}

Direction<MovingNumber> turned_by(const Direction<double>& start, const MovingNumber& turn) {
  return turned(Direction<MovingNumber>{MovingNumber(start.cos), MovingNumber(start.sin)},
                Direction<MovingNumber>{cos(turn), sin(turn)});
}

}  // namespace

MovingLinks::MovingLinks(const Values& values, const Configuration& configuration)
    : values_(values),
      mechanism_(values.plan().mechanism),
      configuration_(configuration),
      coordinates_(values, configuration),
      parameters_(mechanism_.parameters().size()),
      poses_(mechanism_.links().size()) {
  for (const ParameterIndex parameter : parameters_.keys()) {
    const Dual& in_time = values.in_time(parameter);
    parameters_[parameter] = {in_time.value(), values::rate_of(in_time),
                              values::second_rate_of(in_time)};
  }
  for (const LinkIndex link : poses_.keys()) {
    const Frame& frame = configuration.links[link];
    displace(link,
             {{0, frame.velocity(0), frame.acceleration(0)},
              {0, frame.velocity(1), frame.acceleration(1)}},
             {0, frame.velocity(2), frame.acceleration(2)});
  }
}

void MovingLinks::displace(LinkIndex link, const MovingPlace& by, const MovingNumber& turn) {
  const Pose<double>& pose = configuration_.links[link].pose;
  poses_[link] = {MovingNumber(pose.x) + by.x, MovingNumber(pose.y) + by.y,
                  turned_by(pose.direction, turn)};
}

void MovingLinks::vary(ParameterIndex parameter) {
  const auto& replaced = values_.replaced();
  for (const ParameterIndex index : values_.plan().evaluation.parameters) {
    const Parameter& described = mechanism_.parameters()[index];
    const bool is_replaced =
        std::ranges::any_of(replaced, [index](const auto& one) { return one.first == index; });
    MovingNumber& number = parameters_[index];
    number = (is_replaced ? MovingNumber(values_.parameter(index)) : this->number(described.value));
    if (index == parameter) {
      number = number + MovingNumber({0, 0, 0}, {1, 0, 0});
    }
    if (described.velocity.exists()) {
      number = number.with_rate(this->number(described.velocity));
    }
    if (described.acceleration.exists()) {
      number = number.with_second_rate(this->number(described.acceleration));
    }
  }
}

MovingNumber MovingLinks::evaluated(NumberIndex number, const CoordinateOf& coordinate_of) const {
  return mechanism_.numbers()[number].formula.evaluate<MovingNumber>(
      [this](ParameterIndex parameter) { return parameters_[parameter]; }, coordinate_of);
}

MovingNumber MovingLinks::number(NumberIndex number) const {
  return number.exists() ? evaluated(number, [](JointIndex) { return MovingNumber(); })
                         : MovingNumber();
}

MovingNumber MovingLinks::size(NumberIndex index) const {
  const MovingNumber result = number(index);
  if (index.exists() && !std::isfinite(result.value())) {
    throw MechanismError(mechanism_.numbers()[index].part, "the value is not a finite number");
  }
  if (result.value() < 0) {
    throw MechanismError(mechanism_.numbers()[index].part,
                         "the value is negative; give zero or more");
  }
  return result.at_rest();
}

MovingNumber MovingLinks::reading(NumberIndex index) const {
  const MovingNumber result =
      evaluated(index, [this](JointIndex joint) { return coordinate(joint); });
  if (!std::isfinite(result.value())) {
    throw MechanismError(mechanism_.numbers()[index].part, "the value is not a finite number");
  }
  return result;
}

MovingNumber MovingLinks::law(DriverIndex index) const {
  const Driver& driver = mechanism_.drivers()[index];
  MovingNumber result =
      evaluated(driver.position, [this](JointIndex joint) { return coordinate(joint); });
  if (driver.velocity.exists()) {
    result = result.with_rate(number(driver.velocity));
  }
  if (driver.acceleration.exists()) {
    result = result.with_second_rate(number(driver.acceleration));
  }
  return result;
}

/// The variable t is the coordinate here; all other numbers are constant.
MovingNumber MovingLinks::law_slope(DriverIndex driver, JointIndex by) const {
  const MovingNumber law =
      mechanism_.numbers()[mechanism_.drivers()[driver].position].formula.evaluate<MovingNumber>(
          [this](ParameterIndex parameter) { return parameters_[parameter].at_rest(); },
          [&](JointIndex joint) {
            const MovingNumber here = coordinate(joint).at_rest();
            return joint == by ? here + MovingNumber(0, 1, 0) : here;
          });
  return law.its_rate();
}

MovingPlace MovingLinks::turned_with(LinkIndex link, const MovingPlace& vector) const {
  return turned_place(poses_[link].direction, vector);
}

MovingPlace MovingLinks::arm(const PlaceOnLink& on) const {
  return turned_with(on.link, {number(on.x), number(on.y)});
}

MovingPlace MovingLinks::place(const PlaceOnLink& on) const {
  const MovingPlace from_origin = arm(on);
  return {poses_[on.link].x + from_origin.x, poses_[on.link].y + from_origin.y};
}

MovingPlace MovingLinks::place(FeatureIndex point) const {
  const Feature& feature = mechanism_.features()[point];
  return place(PlaceOnLink{feature.link, feature.x, feature.y});
}

MovingPose MovingLinks::placed(FeatureIndex index) const {
  const Feature& feature = mechanism_.features()[index];
  const MovingPlace at = place(index);
  const Direction<MovingNumber>& link = poses_[feature.link].direction;
  return {at.x, at.y,
          feature.is_line
              ? turned(link, unit_direction(number(feature.along_x), number(feature.along_y)))
              : link};
}

MovingNumber MovingLinks::relative(FeatureIndex first, FeatureIndex second, int coordinate) const {
  const MovingPose one = placed(first);
  const MovingPose other = placed(second);
  const Direction<MovingNumber> back = reversed(one.direction);
  if (coordinate == 2) {
    return angle_of(turned(other.direction, back));
  }
  const MovingPlace apart = turned_place(back, {other.x - one.x, other.y - one.y});
  return coordinate == 0 ? apart.x : apart.y;
}

Reaction MovingLinks::along(FeatureIndex first, FeatureIndex second, int coordinate) const {
  const auto& features = mechanism_.features();
  const MovingPose at = placed(second);
  Reaction result{features[second].link, features[first].link, {at.x, at.y}, {}, {}};
  if (coordinate == 2) {
    result.couple = MovingNumber(1);
    return result;
  }
  const auto& [c, s] = placed(first).direction;
  result.force = coordinate == 0 ? MovingPlace{c, s} : MovingPlace{-s, c};
  return result;
}

MovingNumber MovingLinks::coordinate(JointIndex joint) const {
  const CoordinatePair pair = coordinates_.pair_of(joint);
  return relative(pair.first, pair.second, pair.coordinate).valued(coordinates_.value(joint));
}

}  // namespace assur::mechanism::forces
