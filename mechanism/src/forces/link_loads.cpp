#include "link_loads.hpp"

#include <assur/directions.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "plan/plan_data.hpp"
#include "values/rates.hpp"

namespace assur::mechanism::forces {

namespace {

using Eigen::Vector2d;

/// A place on a link, from the origin of the link's frame, in the directions of the ground.
struct MovingPlace {
  Vector2d at, arm, velocity, acceleration;
};

class LoadedLinks {
 public:
  LoadedLinks(const Values& values, const Configuration& configuration)
      : values_(values), mechanism_(values.plan().mechanism), configuration_(configuration) {}

  [[nodiscard]] MovingPlace place(const PlaceOnLink& on) const {
    const Frame& link = configuration_.links[on.link];
    const auto& direction = link.pose.direction;
    const auto turned = [&](const Vector2d& v) { return support::rotated<double>(direction, v); };
    const Dual x = in_time(on.x);
    const Dual y = in_time(on.y);
    const Vector2d own_rate = turned({values::rate_of(x), values::rate_of(y)});
    const Vector2d own_second_rate = turned({values::second_rate_of(x), values::second_rate_of(y)});
    MovingPlace result;
    result.arm = turned({x.value(), y.value()});
    result.at = Vector2d(link.pose.x, link.pose.y) + result.arm;
    result.velocity = support::carried<double>(link.velocity, result.arm, own_rate);
    result.acceleration =
        support::carried_twice<double>(link.acceleration, link.velocity(2), link.velocity(2),
                                       result.arm, own_rate, own_rate, own_second_rate);
    return result;
  }

  [[nodiscard]] MovingPlace place(FeatureIndex point) const {
    const Feature& feature = mechanism_.features()[point];
    return place({feature.link, feature.x, feature.y});
  }

  [[nodiscard]] double number(NumberIndex number) const {
    return number.exists() ? values_.value_of(number) : 0;
  }
  /// A mass, an inertia, a stiffness, the length of a spring, or a damping.
  [[nodiscard]] double size(NumberIndex index) const {
    const double value = number(index);
    if (value < 0) {
      throw MechanismError(mechanism_.numbers()[index].part,
                           "the value is negative; give zero or more");
    }
    return value;
  }

 private:
  [[nodiscard]] Dual in_time(NumberIndex number) const {
    return number.exists()
               ? mechanism_.numbers()[number].formula.evaluate<Dual>(
                     [this](ParameterIndex parameter) { return values_.in_time(parameter); })
               : Dual(0.0);
  }

  const Values& values_;
  const Mechanism& mechanism_;
  const Configuration& configuration_;
};

class LoadCollector {
 public:
  LoadCollector(const Values& values, const Configuration& configuration, const Balance& balance)
      : values_(values),
        mechanism_(values.plan().mechanism),
        configuration_(configuration),
        balance_(balance),
        links_(values, configuration) {
    result_.applied.assign(mechanism_.links().size(), Wrench());
    result_.inertia.assign(mechanism_.links().size(), Wrench());
  }

  [[nodiscard]] LinkLoads collected() {
    add_masses();
    for (const Load& load : mechanism_.loading().loads) {
      add_load(load);
    }
    for (const Spring& spring : mechanism_.loading().springs) {
      spring.at_joint ? add_joint_spring(spring) : add_spring(spring);
    }
    return std::move(result_);
  }

 private:
  void add(Table<LinkIndex, Wrench>& to, LinkIndex link, const Vector2d& at, const Vector2d& force,
           double couple) {
    to[link].force += force;
    to[link].moment += couple + moment_of(at - balance_.pivots()[link], force);
  }

  void add_masses() {
    const Vector2d gravity(links_.number(mechanism_.loading().gravity[0]),
                           links_.number(mechanism_.loading().gravity[1]));
    for (const MassCentre& centre : mass_centres(values_, configuration_)) {
      const Frame& link = configuration_.links[centre.link];
      const Vector2d at = Vector2d(link.pose.x, link.pose.y) + centre.arm;
      add(result_.applied, centre.link, at, centre.mass * gravity, 0);
      if (centre.mass > 0) {  // what has no mass has no inertia, though its rates be unknown
        add(result_.inertia, centre.link, at, -centre.mass * centre.acceleration, 0);
      }
      if (centre.inertia > 0) {
        add(result_.inertia, centre.link, at, Vector2d::Zero(),
            -centre.inertia * link.acceleration(2));
      }
    }
  }

  void add_load(const Load& load) {
    const Vector2d at = links_.place(load.at).at;
    if (load.moment.exists()) {
      add(result_.applied, load.at.link, at, Vector2d::Zero(), number(load.moment));
      return;
    }
    Vector2d force(number(load.force_x), number(load.force_y));
    if (load.frame.exists()) {
      force = support::rotated<double>(configuration_.links[load.frame].pose.direction, force);
    }
    add(result_.applied, load.at.link, at, force, 0);
  }

  [[nodiscard]] double number(NumberIndex index) const {
    const double value = balance_.coordinates().number(index);
    if (!std::isfinite(value)) {
      throw MechanismError(mechanism_.numbers()[index].part, "the value is not a finite number");
    }
    return value;
  }

  void add_spring(const Spring& spring) {
    const MovingPlace one = links_.place(spring.between[0]);
    const MovingPlace other = links_.place(spring.between[1]);
    const Vector2d apart = other.at - one.at;
    const double length = apart.norm();
    const double stiffness = links_.size(spring.stiffness);
    const double damping = links_.size(spring.damping);
    const double rest = links_.size(spring.rest);
    // Where the ends coincide, the spring has no direction; with the length 0 it needs none.
    Vector2d pull = stiffness * apart;
    if ((stiffness > 0 && rest > 0) || damping > 0) {
      const Vector2d along = apart / length;
      pull -= stiffness * rest * along;
      if (damping > 0) {
        pull += damping * (other.velocity - one.velocity).dot(along) * along;
      }
    }
    const auto link_of = [&](std::size_t end) {
      return mechanism_.features()[spring.between[end]].link;
    };
    add(result_.applied, link_of(0), one.at, pull, 0);
    add(result_.applied, link_of(1), other.at, -pull, 0);
  }

  void add_joint_spring(const Spring& spring) {
    const CoordinatePair pair = balance_.coordinates().pair_of(spring.between);
    const Frame relative = balance_.coordinates().relative(pair);
    const double damping = links_.size(spring.damping);
    double effort = -links_.size(spring.stiffness) * deflection(spring, pair, relative);
    if (damping > 0) {
      effort -= damping * relative.velocity(pair.coordinate);
    }
    const Reaction unit = balance_.along(pair.first, pair.second, pair.coordinate);
    add(result_.applied, unit.on, unit.at, effort * unit.force, effort * unit.couple);
    add(result_.applied, unit.from, unit.at, -effort * unit.force, -effort * unit.couple);
  }

  /// An angle jumps by a whole turn at half a turn. Where no law and no branch counts the turns,
  /// the deflection is within half a turn.
  [[nodiscard]] double deflection(const Spring& spring, const CoordinatePair& pair,
                                  const Frame& relative) const {
    const double rest = links_.number(spring.rest);
    if (pair.coordinate == 0) {
      return relative.pose.x - rest;
    }
    for (const JointIndex index : mechanism_.joints().keys()) {
      const Joint& joint = mechanism_.joints()[index];
      if (joint.between.size() == 2 && joint.between[0] == spring.between[0] &&
          joint.between[1] == spring.between[1] && mechanism_.driver_of(index).exists()) {
        return balance_.coordinates().value(index) - rest;
      }
    }
    // At half a turn rounding would choose between the two senses; it counts as positive.
    constexpr double rounding_of_angles = 1e-9;
    const double turn = 2 * std::numbers::pi;
    const double within = std::remainder(angle_of(relative.pose.direction) - rest, turn);
    return within < rounding_of_angles - turn / 2 ? within + turn : within;
  }

  const Values& values_;
  const Mechanism& mechanism_;
  const Configuration& configuration_;
  const Balance& balance_;
  LoadedLinks links_;
  LinkLoads result_;
};

}  // namespace

std::vector<MassCentre> mass_centres(const Values& values, const Configuration& configuration) {
  const LoadedLinks links(values, configuration);
  std::vector<MassCentre> centres;
  for (const Mass& mass : values.plan().mechanism.loading().masses) {
    const MovingPlace at = links.place(mass.at);
    centres.push_back(
        {mass.at.link, links.size(mass.mass), links.size(mass.inertia), at.arm, at.acceleration});
  }
  return centres;
}

LinkLoads link_loads(const Values& values, const Configuration& configuration,
                     const Balance& balance) {
  return LoadCollector(values, configuration, balance).collected();
}

}  // namespace assur::mechanism::forces
