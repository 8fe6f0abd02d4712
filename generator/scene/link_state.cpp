#include "scene/link_state.hpp"

namespace assur::generator {

namespace {

/// omega x r in the plane.
Eigen::Vector2d cross(double omega, const Eigen::Vector2d& r) {
  return {-omega * r.y(), omega * r.x()};
}

Direction<Dual> dual_turned(const Direction<Dual>& direction, const Direction<Dual>& by) {
  return turned(direction, by);
}

}  // namespace

LinkState fixed_link(const ParameterValues& values) {
  LinkState state;
  state.x = values.constant(0.0);
  state.y = values.constant(0.0);
  state.direction = {values.constant(1.0), values.constant(0.0)};
  return state;
}

PointState point_of(const LinkState& link, const Dual& x, const Dual& y) {
  const Dual dx = link.direction.cos * x - link.direction.sin * y;
  const Dual dy = link.direction.sin * x + link.direction.cos * y;
  const Eigen::Vector2d arm(dx.value(), dy.value());
  const double omega = link.velocity(2);
  PointState point;
  point.x = link.x + dx;
  point.y = link.y + dy;
  point.velocity = link.velocity.head<2>() + cross(omega, arm);
  point.acceleration =
      link.acceleration.head<2>() + cross(link.acceleration(2), arm) - omega * omega * arm;
  return point;
}

LinkState link_through(const PointState& point, const Dual& x, const Dual& y,
                       const Direction<Dual>& direction, double angular_velocity,
                       double angular_acceleration) {
  const Dual dx = direction.cos * x - direction.sin * y;
  const Dual dy = direction.sin * x + direction.cos * y;
  const Eigen::Vector2d arm(dx.value(), dy.value());
  LinkState link;
  link.x = point.x - dx;
  link.y = point.y - dy;
  link.direction = direction;
  link.velocity << point.velocity - cross(angular_velocity, arm), angular_velocity;
  link.acceleration << point.acceleration - cross(angular_acceleration, arm) +
                           angular_velocity * angular_velocity * arm,
      angular_acceleration;
  return link;
}

LinkState driven_link(const MechanismJoint& joint, int placed, const LinkState& state,
                      const DriverState& driver) {
  const bool forward = joint.first == placed;
  const LinkFeature<Dual>& near = joint.on(placed);
  const LinkFeature<Dual>& far = forward ? joint.on_second : joint.on_first;
  const double sense = forward ? 1.0 : -1.0;
  PointState point = point_of(state, near.x, near.y);
  const double omega = state.velocity(2);
  const double alpha = state.acceleration(2);
  if (!joint.prismatic) {
    const Dual angle = sense * driver.position;
    const Direction<Dual> direction =
        dual_turned(state.direction, {Dual(cos(angle)), Dual(sin(angle))});
    return link_through(point, far.x, far.y, direction, omega + sense * driver.velocity,
                        alpha + sense * driver.acceleration);
  }
  const Direction<Dual> slide = dual_turned(state.direction, near.along);
  const Direction<Dual> direction = dual_turned(slide, reversed(far.along));
  const Dual displacement = sense * driver.position;
  const Eigen::Vector2d along(slide.cos.value(), slide.sin.value());
  const Eigen::Vector2d arm = displacement.value() * along;
  const Eigen::Vector2d sliding = sense * driver.velocity * along;
  point.x = point.x + displacement * slide.cos;
  point.y = point.y + displacement * slide.sin;
  point.velocity += cross(omega, arm) + sliding;
  point.acceleration += cross(alpha, arm) - omega * omega * arm + 2.0 * cross(omega, sliding) +
                        sense * driver.acceleration * along;
  return link_through(point, far.x, far.y, direction, omega, alpha);
}

}  // namespace assur::generator
