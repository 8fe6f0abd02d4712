// Difference of a placed link's angle from its angle in the request's reference.
#pragma once

#include <assur/directions.hpp>
#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// Throws MechanismError for a request without a reference.
inline void expect_reference(const Request& request) {
  if (request.reference.empty()) {
    throw MechanismError(
        "reference", "the nearest configuration needs a reference; give the angles of some links");
  }
}

/// The angle from a reference angle to the link's, in radians, from -pi to pi.
[[nodiscard]] inline double difference_from(const Values& values, const Frame& link,
                                            const ReferenceAngle& angle) {
  const Direction<double> wanted = direction_of(values.number(angle.theta).value());
  return angle_of(turned(link.pose.direction, reversed(wanted)));
}

}  // namespace assur::mechanism::solve
