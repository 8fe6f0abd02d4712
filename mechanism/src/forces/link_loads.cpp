#include "link_loads.hpp"

#include <assur/directions.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>
#include <optional>

#include "plan/plan_data.hpp"

namespace assur::mechanism::forces {

namespace {

class LoadCollector {
 public:
  LoadCollector(const Mechanism& mechanism, const MovingLinks& links, const Balance& balance)
      : mechanism_(mechanism), links_(links), balance_(balance) {
    for (LinkLoads* loads : {&result_.values, &result_.derivatives}) {
      loads->applied.assign(mechanism_.links().size(), Wrench());
      loads->inertia.assign(mechanism_.links().size(), Wrench());
    }
  }

  [[nodiscard]] MovingLoads collected() {
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
  using Kind = Table<LinkIndex, Wrench> LinkLoads::*;

  void add(Kind kind, LinkIndex link, const MovingPlace& at, const MovingPlace& force,
           const MovingNumber& couple) {
    const Eigen::Vector2d& pivot = balance_.pivots()[link];
    const MovingNumber moment = couple + (at.x - MovingNumber(pivot.x())) * force.y -
                                (at.y - MovingNumber(pivot.y())) * force.x;
    Wrench& value = (result_.values.*kind)[link];
    value.force += force.value();
    value.moment += moment.value();
    Wrench& derivative = (result_.derivatives.*kind)[link];
    derivative.force += force.derivative();
    derivative.moment += moment.derivative();
  }

  void add_masses() {
    const MovingPlace gravity{links_.number(mechanism_.loading().gravity[0]),
                              links_.number(mechanism_.loading().gravity[1])};
    for (const Mass& mass : mechanism_.loading().masses) {
      const LinkIndex link = mass.at.link;
      const MovingPlace at = links_.place(mass.at);
      const MovingNumber kilograms = links_.size(mass.mass);
      const MovingNumber inertia = links_.size(mass.inertia);
      add(&LinkLoads::applied, link, at, kilograms * gravity, {});
      if (kilograms.matters()) {  // without mass there is no inertia, even if the rates are unknown
        add(&LinkLoads::inertia, link, at,
            -kilograms * MovingPlace{at.x.its_second_rate(), at.y.its_second_rate()}, {});
      }
      if (inertia.matters()) {
        add(&LinkLoads::inertia, link, at, {},
            -inertia * angle_of(links_.pose(link).direction).its_second_rate());
      }
    }
  }

  void add_load(const Load& load) {
    const MovingPlace at = links_.place(load.at);
    if (load.moment.exists()) {
      add(&LinkLoads::applied, load.at.link, at, {}, links_.reading(load.moment));
      return;
    }
    MovingPlace force{links_.reading(load.force_x), links_.reading(load.force_y)};
    if (load.frame.exists()) {
      force = links_.turned_with(load.frame, force);
    }
    add(&LinkLoads::applied, load.at.link, at, force, {});
  }

  void add_spring(const Spring& spring) {
    const MovingPlace one = links_.place(spring.between[0]);
    const MovingPlace other = links_.place(spring.between[1]);
    const MovingPlace apart = other - one;
    const MovingNumber stiffness = links_.size(spring.stiffness);
    const MovingNumber damping = links_.size(spring.damping);
    const MovingNumber rest = links_.size(spring.rest);
    // If the ends coincide to within the rounding of places, the spring has no direction; with zero
    // length, and at rest, it needs none.
    constexpr double rounding_of_places = 1e-13;
    const bool has_direction = apart.value().norm() > rounding_of_places * balance_.size();
    const bool is_stretched = stiffness.matters() && rest.matters();
    const bool is_damped =
        damping.matters() && (has_direction || apart.x.rate() != 0 || apart.y.rate() != 0);
    const LinkIndex on = mechanism_.features()[spring.between[0]].link;
    const LinkIndex from = mechanism_.features()[spring.between[1]].link;
    MovingPlace pull = stiffness * apart;
    if (is_stretched || is_damped) {
      const MovingNumber length = sqrt(apart.x * apart.x + apart.y * apart.y);
      const MovingPlace along{apart.x / length, apart.y / length};
      pull = pull - stiffness * rest * along;
      if (is_damped) {
        pull = pull + damping * length.its_rate() * along;
      }
      if (!has_direction || !pull.value().allFinite()) {
        add_unknown_pull(
            {on, from, one, {}, {}},
            has_direction ? "the rates of the ends of the spring " + spring.name + " are not known"
                          : "the ends of the spring " + spring.name +
                                " coincide, so that its force has no direction");
        return;
      }
    }
    add(&LinkLoads::applied, on, one, pull, {});
    add(&LinkLoads::applied, from, other, MovingNumber(-1) * pull, {});
  }

  void add_unknown_pull(Reaction unit, const std::string& reason) {
    for (LinkLoads* loads : {&result_.values, &result_.derivatives}) {
      for (const int axis : {0, 1}) {
        unit.force = {MovingNumber(axis == 0 ? 1 : 0), MovingNumber(axis == 1 ? 1 : 0)};
        loads->unknown_pulls.push_back(unit);
      }
      loads->reason += (loads->reason.empty() ? "" : "; ") + reason;
    }
  }

  void add_joint_spring(const Spring& spring) {
    const CoordinatePair pair = links_.coordinates().pair_of(spring.between);
    const MovingNumber relative = links_.relative(pair.first, pair.second, pair.coordinate);
    const MovingNumber damping = links_.size(spring.damping);
    MovingNumber effort = -links_.size(spring.stiffness) * deflection(spring, pair, relative);
    if (damping.matters()) {
      effort = effort - damping * relative.its_rate();
    }
    const Reaction unit = links_.along(pair.first, pair.second, pair.coordinate);
    add(&LinkLoads::applied, unit.on, unit.at, effort * unit.force, effort * unit.couple);
    add(&LinkLoads::applied, unit.from, unit.at, -effort * unit.force, -effort * unit.couple);
  }

  /// An angle jumps by a whole turn at half a turn. If no law and no branch counts the turns, the
  /// deflection is within half a turn.
  [[nodiscard]] MovingNumber deflection(const Spring& spring, const CoordinatePair& pair,
                                        const MovingNumber& relative) const {
    const MovingNumber away = relative - links_.number(spring.rest);
    if (pair.coordinate == 0) {
      return away;
    }
    for (const JointIndex index : mechanism_.joints().keys()) {
      const Joint& joint = mechanism_.joints()[index];
      if (joint.between.size() == 2 && joint.between[0] == spring.between[0] &&
          joint.between[1] == spring.between[1] && mechanism_.driver_of(index).exists()) {
        return links_.coordinate(index) - links_.number(spring.rest);
      }
    }
    const std::optional<double> followed = links_.coordinates().followed(pair, spring.rest);
    return away.valued(followed ? *followed : support::within_half_turn(away.value()));
  }

  const Mechanism& mechanism_;
  const MovingLinks& links_;
  const Balance& balance_;
  MovingLoads result_;
};

}  // namespace

std::vector<MassCentre> mass_centres(const Values& values, const Configuration& configuration) {
  const MovingLinks links(values, configuration);
  std::vector<MassCentre> centres;
  for (const Mass& mass : values.plan().mechanism.loading().masses) {
    centres.push_back({mass.at.link, links.size(mass.mass).value(),
                       links.size(mass.inertia).value(), links.arm(mass.at).value(),
                       links.place(mass.at).second_rate()});
  }
  return centres;
}

MovingLoads moving_loads(const Mechanism& mechanism, const MovingLinks& links,
                         const Balance& balance) {
  return LoadCollector(mechanism, links, balance).collected();
}

LinkLoads link_loads(const Values& values, const Configuration& configuration,
                     const Balance& balance) {
  return moving_loads(values.plan().mechanism, MovingLinks(values, configuration), balance).values;
}

}  // namespace assur::mechanism::forces
