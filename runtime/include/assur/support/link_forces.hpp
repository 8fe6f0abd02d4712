// Loads on the links of an emitted solver, and the resulting joint forces.
#pragma once

#include <algorithm>
#include <assur/support/rigid_motion.hpp>
#include <assur/support/scene_solve.hpp>
#include <cmath>
#include <limits>
#include <tuple>

namespace assur::support {

/// A force, and a moment about a point that the context names.
template <typename Scalar>
struct ForceAndMoment {
  Vector<Scalar, 2> force;
  Scalar moment;
  [[nodiscard]] auto members() { return std::tie(force, moment); }
};

template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> opposite(const Vector<Scalar, 2>& force) {
  return {-force(0), -force(1)};
}

/// The sum of forces.
template <typename Scalar, typename... More>
[[nodiscard]] Vector<Scalar, 2> total(const Vector<Scalar, 2>& force, const More&... more) {
  return {(force(0) + ... + more(0)), (force(1) + ... + more(1))};
}

/// The component of a force along a direction.
template <typename Scalar>
[[nodiscard]] Scalar part_along(const Direction<Scalar>& line, const Vector<Scalar, 2>& force) {
  return line.cos * force(0) + line.sin * force(1);
}

/// The part of a force normal to a direction.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> part_across(const Direction<Scalar>& line,
                                            const Vector<Scalar, 2>& force) {
  const Scalar across = line.cos * force(1) - line.sin * force(0);
  return {-line.sin * across, line.cos * across};
}

/// A force of the given size along a direction.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> force_along(const Direction<Scalar>& line, const Scalar& size) {
  return {line.cos * size, line.sin * size};
}

/// The known load of a link: the sum of forces, and of moments about a point, in the ground's axes.
template <typename Scalar>
struct LinkLoad {
  Scalar at_x = 0, at_y = 0;  ///< the point
  Scalar x = 0, y = 0, moment = 0;

  template <typename Place>
  void add_force(const Place& place, const Vector<Scalar, 2>& force) {
    x += force(0);
    y += force(1);
    moment += (place.x - at_x) * force(1) - (place.y - at_y) * force(0);
  }
  void add_couple(const Scalar& couple) { moment += couple; }
  /// Adds the weight and the inertia of a mass: m (g - a) at its centre.
  template <int Order, int Parameters>
  void add_mass(const Point<Scalar, Order, Parameters>& centre, const Scalar& mass,
                const Vector<Scalar, 2>& gravity) {
    static_assert(Order > 1, "inertia needs accelerations");
    add_force(centre,
              {mass * (gravity(0) - centre.rates(0, 1)), mass * (gravity(1) - centre.rates(1, 1))});
  }
  /// Adds the load of another link, as if it acted on this one.
  void add(const LinkLoad& other) {
    x += other.x;
    y += other.y;
    moment += other.moment + (other.at_x - at_x) * other.y - (other.at_y - at_y) * other.x;
  }
  /// The moment about another point.
  template <typename Place>
  [[nodiscard]] Scalar moment_about(const Place& place) const {
    return moment + (at_x - place.x) * y - (at_y - place.y) * x;
  }
};

/// A zero load, with moments about the origin of the link's frame.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] LinkLoad<Scalar> unloaded(const Frame<Scalar, Order, Parameters>& frame) {
  LinkLoad<Scalar> load;
  load.at_x = frame.pose.x;
  load.at_y = frame.pose.y;
  return load;
}

/// The total load of several links that count as one, about the point of the first.
template <typename Scalar, typename... More>
[[nodiscard]] LinkLoad<Scalar> together(LinkLoad<Scalar> load, const More&... more) {
  (load.add(more), ...);
  return load;
}

/// The force with which a spring pulls the first of two points toward the other.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Vector<Scalar, 2> spring_pull(const Point<Scalar, Order, Parameters>& one,
                                            const Point<Scalar, Order, Parameters>& other,
                                            const Scalar& stiffness) {
  return {stiffness * (other.x - one.x), stiffness * (other.y - one.y)};
}

/// The same for a spring with a rest length, and a damper. If the points coincide to within
/// rounding, the direction is undefined and the force is NaN, unless the force does not depend on
/// it.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Vector<Scalar, 2> directed_pull(const Point<Scalar, Order, Parameters>& one,
                                              const Point<Scalar, Order, Parameters>& other,
                                              const Scalar& stiffness, const Scalar& rest,
                                              const Scalar& damping) {
  using std::sqrt;
  const Scalar apart_x = other.x - one.x;
  const Scalar apart_y = other.y - one.y;
  const Scalar length = sqrt(apart_x * apart_x + apart_y * apart_y);
  // 1e-13 of the longest length in double.
  constexpr Scalar rounding_of_places = 450 * std::numeric_limits<Scalar>::epsilon();
  const Scalar reach = larger(one.displaced.reach, other.displaced.reach);
  const Scalar rate_x = other.rates(0, 0) - one.rates(0, 0);
  const Scalar rate_y = other.rates(1, 0) - one.rates(1, 0);
  if (!(length > rounding_of_places * reach)) {
    const bool needs_none = stiffness * rest == Scalar(0) &&
                            (damping == Scalar(0) || (rate_x == Scalar(0) && rate_y == Scalar(0)));
    constexpr Scalar none = std::numeric_limits<Scalar>::quiet_NaN();
    return needs_none ? spring_pull(one, other, stiffness) : Vector<Scalar, 2>{none, none};
  }
  const Direction<Scalar> along{apart_x / length, apart_y / length};
  const Scalar rate = along.cos * rate_x + along.sin * rate_y;
  return force_along<Scalar>(along, stiffness * (length - rest) + damping * rate);
}

/// The pull, or zero if it is not known.
template <typename Scalar>
[[nodiscard]] Vector<Scalar, 2> known_pull(const Vector<Scalar, 2>& pull) {
  using std::isfinite;
  return isfinite(pull(0)) && isfinite(pull(1)) ? pull : Vector<Scalar, 2>{Scalar(0), Scalar(0)};
}

/// A coordinate whose angle is continued from its last value.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Coordinate<Scalar, Order, Parameters> continued(
    Coordinate<Scalar, Order, Parameters> angle, const Scalar& last) {
  angle.position = continued_angle(angle.position, last);
  return angle;
}

/// The force and moment of a joint on the link on its far side, at a point, that balance the rest
/// of the link's load. They are added to the loads of both links.
template <typename Scalar, typename Place>
[[nodiscard]] ForceAndMoment<Scalar> balance(const Place& place, LinkLoad<Scalar>& on_far,
                                             LinkLoad<Scalar>& on_near) {
  const ForceAndMoment<Scalar> reaction = {{-on_far.x, -on_far.y}, -on_far.moment_about(place)};
  on_far.add_force(place, reaction.force);
  on_far.add_couple(reaction.moment);
  on_near.add_force(place, opposite(reaction.force));
  on_near.add_couple(-reaction.moment);
  return reaction;
}

/// Joint forces of a group under the loads of its links. `is_turned` if the group is solved in the
/// frame of a rotating link.
template <typename Group, typename Scalar, bool is_turned = false>
class GroupForces {
 public:
  GroupForces() = default;
  explicit GroupForces(const Direction<Scalar>& turn) : turn_(turn) {}

  /// Sets the load of a link of the group; `origin` is that of the link's normal frame.
  template <typename Place>
  void load(int link, const Place& origin, const LinkLoad<Scalar>& load) {
    const Vector<Scalar, 2> force = turned_by({load.x, load.y}, -1);
    loads_(link, 0) = force(0);
    loads_(link, 1) = force(1);
    loads_(link, 2) = load.moment_about(origin) / unit_of<Group, Scalar>;
  }
  /// Finds the forces if the configuration is regular.
  template <typename Held>
  void solve(const Held& held, const SolvedGroup<Group, Scalar>& solved) {
    if constexpr (reciprocal_count < Group >> 0) {
      Group::forces(held.u, solved.q, loads_, solved.reciprocals, forces_);
    } else {
      Group::forces(held.u, solved.q, loads_, forces_);
    }
  }
  /// The force of a joint on its second link.
  [[nodiscard]] Vector<Scalar, 2> force(int joint) const {
    return turned_by({forces_(joint, 0), forces_(joint, 1)}, 1);
  }
  /// The couple of a slide on its second link, about the origin of the link's normal frame.
  [[nodiscard]] Scalar couple(int joint) const {
    return forces_(joint, 2) * unit_of<Group, Scalar>;
  }
  /// The moment about another point; `origin` is that of the second link's normal frame.
  template <typename Origin, typename Place>
  [[nodiscard]] Scalar couple_about(int joint, const Origin& origin, const Place& place) const {
    const Vector<Scalar, 2> own = force(joint);
    return couple(joint) + (origin.x - place.x) * own(1) - (origin.y - place.y) * own(0);
  }
  /// Adds the force of a pin to the loads of its links.
  template <typename Place>
  void turn(int joint, const Place& place, LinkLoad<Scalar>& on_second,
            LinkLoad<Scalar>& on_first) const {
    on_second.add_force(place, force(joint));
    on_first.add_force(place, opposite(force(joint)));
  }
  /// Adds the force and the couple of a slide; `origin` is that of the second link's normal frame.
  template <typename Place>
  void slide(int joint, const Place& origin, LinkLoad<Scalar>& on_second,
             LinkLoad<Scalar>& on_first) const {
    turn(joint, origin, on_second, on_first);
    on_second.add_couple(couple(joint));
    on_first.add_couple(-couple(joint));
  }

 private:
  /// The force rotated into the ground's frame for the sense 1, into that of the group for -1.
  [[nodiscard]] Vector<Scalar, 2> turned_by(const Vector<Scalar, 2>& force, int sense) const {
    if constexpr (is_turned) {
      const Scalar sine = sense < 0 ? -turn_.sin : turn_.sin;
      return {turn_.cos * force(0) - sine * force(1), sine * force(0) + turn_.cos * force(1)};
    } else {
      return force;
    }
  }

  Direction<Scalar> turn_{};
  Matrix<Scalar, Group::link_count, 3> loads_;
  Matrix<Scalar, Group::joint_count, 3> forces_;
};

}  // namespace assur::support
