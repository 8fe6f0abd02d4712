// Mechanisms from files of Linkage: rigid bodies, slots, inputs, actuators and gears.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "foreign/drive_period.hpp"
#include "foreign/linkage_bodies.hpp"
#include "foreign/scene_text.hpp"

namespace assur::mechanism::foreign {

namespace {

constexpr double seconds_per_minute = 60;
constexpr double degrees_per_turn = 360;

/// The position on a path `way` that is folded between 0 and `limit`, from 0 outward.
double to_and_fro(double way, double limit) {
  const double rest = std::fmod(std::abs(way), 2 * limit);
  return rest > limit ? 2 * limit - rest : rest;
}

/// The same as a formula, less its value at the start, for paths of up to `farthest` in either
/// direction: `way` is folded at twice, four times the limit and so on, and finally at the limit.
std::string to_and_fro_text(const std::string& way, double limit, double start, double farthest) {
  double fold = limit;
  while (2 * fold < farthest + start) {
    fold *= 2;
  }
  std::string formula = "abs(" + way + (start == 0 ? "" : term_text(start)) + ")";
  for (bool is_inner = true; fold >= limit; fold /= 2) {
    const std::string end = number_text(fold);
    formula = end + " - abs(" + end + " - " + (is_inner ? formula : "(" + formula + ")") + ")";
    is_inner = false;
  }
  const double first = to_and_fro(start, limit);
  return first == 0 ? formula : formula + term_text(-first);
}
/// Adds the drives of a file's bodies.
class DriveBuilder {
 public:
  explicit DriveBuilder(const std::string& text)
      : bodies_(linkage_bodies(text)), mechanism_(bodies_.mechanism), file_(bodies_.file) {}
  DriveBuilder(const DriveBuilder&) = delete;
  DriveBuilder& operator=(const DriveBuilder&) = delete;

  ForeignMechanism build() {
    collect_speeds();
    add_inputs();
    add_actuators();
    add_ratios();
    for (const LinkageConnector& connector : file_.connectors) {
      const ForeignPointIndex point = bodies_.point(connector.id);
      if (connector.is_drawing && mechanism_.is_moved(point)) {
        mechanism_.outputs.push_back(point);
      }
    }
    mechanism_.finish();
    mechanism_.sweep = period_.sweep(mechanism_);
    return std::move(mechanism_);
  }

 private:
  /// The cycles a minute of the drives that move in time.
  void collect_speeds() {
    for (const LinkageConnector& input : file_.connectors) {
      const double turns = std::abs(input.turns_per_minute);
      if (input.is_input && input.moves && !input.is_moved_by_hand && turns > 0) {
        period_.add(input.limit_angle > 0 ? turns * degrees_per_turn / (2 * input.limit_angle)
                                          : turns);
      }
    }
    for (const LinkageLink& link : file_.links) {
      if (link.is_actuator && !link.is_moved_by_hand && link.cycles_per_minute != 0 &&
          link.stroke > 0) {
        period_.add(std::abs(link.cycles_per_minute));
      }
    }
  }

  void add_inputs() {
    for (const LinkageConnector& input : file_.connectors) {
      if (!input.is_input || !input.moves) {
        continue;
      }
      const std::string what = "connector " + std::to_string(input.id);
      std::vector<ForeignLinkIndex> driven = mechanism_.pinned_at(bodies_.point(input.id));
      std::erase(driven, mechanism_.ground());
      if (driven.empty()) {
        mechanism_.miss(what + ": it is an input, but there is no moving link at it");
      }
      const std::string motion = driven.empty() ? "" : turning(input);
      for (const ForeignLinkIndex link : driven) {
        mechanism_.drives.push_back(
            {mechanism_.pin(mechanism_.ground(), link, bodies_.point(input.id)), motion});
      }
    }
  }

  /// Positive speeds are clockwise, and so is the initial direction of an oscillating input.
  std::string turning(const LinkageConnector& input) {
    const std::string what = "connector " + std::to_string(input.id);
    const double speed = input.turns_per_minute;
    if (input.is_moved_by_hand) {
      const std::string parameter = "C" + std::to_string(input.id) + "_hand";
      by_hand(what, parameter, "radians, clockwise", -std::numbers::pi, std::numbers::pi);
      return " - " + parameter;
    }
    if (speed == 0) {
      mechanism_.remark(what + ": the input stands still, since its speed is 0");
      return "";
    }
    if (input.limit_angle > 0) {
      const double rate = std::abs(speed) * degrees_per_turn / seconds_per_minute;
      return std::string(speed > 0 ? " - (" : " + (") +
             to_and_fro_text(number_text(rate) + "*t", input.limit_angle, input.start_offset,
                             rate * period_.half()) +
             ")*deg";
    }
    return term_text(-speed) + "*2*pi/60*t";
  }

  void by_hand(const std::string& what, const std::string& parameter, const std::string& unit,
               double from, double to) {
    mechanism_.hand_parameters.push_back(parameter);
    mechanism_.remark(what + ": it is moved by hand only; set the parameter " + parameter + " (" +
                      unit + ")");
    period_.add_hand(parameter, from, to);
  }

  /// An actuator moves back and forth at one speed, inward first if its number of cycles is
  /// negative.
  void add_actuators() {
    for (std::size_t place = 0; place < file_.links.size(); ++place) {
      const LinkageLink& link = file_.links[place];
      if (!link.is_actuator) {
        continue;
      }
      const std::string what = "Link " + std::to_string(link.id);
      const ForeignLinkIndex tube = bodies_.links[place][0];
      const ForeignLinkIndex rod = bodies_.links[place][1];
      const ForeignPointIndex from = bodies_.point(link.connectors[0]);
      const ForeignPointIndex to = bodies_.point(link.connectors[1]);
      if (tube == rod || mechanism_.distance(from, to) == 0) {
        mechanism_.miss(what +
                        ": the actuator has no length, or both its ends are fastened to one "
                        "link");
        continue;
      }
      ForeignJoint cylinder{JointType::prismatic, tube, rod, from};
      cylinder.to = to;
      mechanism_.drives.push_back({mechanism_.joints.add(cylinder), stroke(link, what)});
    }
  }

  std::string stroke(const LinkageLink& link, const std::string& what) {
    const double cycles = link.cycles_per_minute;
    const std::string sign = cycles < 0 ? " - " : " + ";
    if (link.is_moved_by_hand) {
      const std::string parameter = "L" + std::to_string(link.id) + "_hand";
      by_hand(what, parameter, "the stroke, from 0 to " + number_text(link.stroke), 0,
              std::max(link.stroke, 0.0));
      return sign + parameter;
    }
    if (cycles == 0 || link.stroke <= 0) {
      mechanism_.remark(what + ": the actuator stands still, since its speed or stroke is 0");
      return "";
    }
    const std::string way =
        number_text(link.stroke) + "*" + number_text(std::abs(cycles)) + "/30*t";
    return sign + "(" +
           to_and_fro_text(way, link.stroke, link.start_offset,
                           link.stroke * std::abs(cycles) / 30 * period_.half()) +
           ")";
  }

  /// Gears turn in opposite senses, wheels with a chain in the same sense, both relative to the
  /// link that carries them. The one with a driven joint leads; otherwise the first.
  void add_ratios() {
    std::vector<const LinkageRatio*> waiting;
    for (const LinkageRatio& ratio : file_.ratios) {
      waiting.push_back(&ratio);
    }
    for (bool only_driven = true; !waiting.empty();) {
      const auto next = std::ranges::find_if(waiting, [&](const LinkageRatio* ratio) {
        return !only_driven || has_driven_wheel(*ratio);
      });
      if (next == waiting.end()) {
        only_driven = false;
        continue;
      }
      add_ratio(**next);
      waiting.erase(next);
      only_driven = true;
    }
  }

  /// The joints of both wheels on the link that carries them, if there is one.
  [[nodiscard]] std::optional<std::array<ForeignJoint, 2>> wheels(const LinkageRatio& ratio) const {
    if (ratio.links.size() != 2 || !bodies_.link_of_id.contains(ratio.links[0]) ||
        !bodies_.link_of_id.contains(ratio.links[1])) {
      return std::nullopt;
    }
    std::array<ForeignJoint, 2> joints;
    for (const std::size_t wheel : {0U, 1U}) {
      const std::size_t place = bodies_.link_of_id.at(ratio.links[wheel]);
      const LinkageLink& link = file_.links[place];
      if (link.connectors.empty() || !link.is_gear) {
        return std::nullopt;
      }
      joints[wheel] = {
          JointType::revolute, {}, bodies_.links[place][0], bodies_.point(link.connectors[0])};
    }
    ForeignLinkIndex carrier;
    for (const ForeignLinkIndex link : mechanism_.links.keys()) {
      const bool is_better = !carrier.exists() || carrier == mechanism_.ground();
      if (link != joints[0].second && link != joints[1].second && is_better &&
          mechanism_.lists(link, joints[0].at) && mechanism_.lists(link, joints[1].at)) {
        carrier = link;
      }
    }
    if (!carrier.exists()) {
      return std::nullopt;
    }
    joints[0].first = joints[1].first = carrier;
    return joints;
  }

  [[nodiscard]] bool is_driven(const ForeignJoint& wheel) const {
    return std::ranges::any_of(mechanism_.drives, [&](const ForeignDrive& drive) {
      const ForeignJoint& joint = mechanism_.joints[drive.joint];
      return joint.at == wheel.at &&
             ((joint.first == wheel.first && joint.second == wheel.second) ||
              (joint.first == wheel.second && joint.second == wheel.first));
    });
  }
  [[nodiscard]] bool has_driven_wheel(const LinkageRatio& ratio) const {
    const auto joints = wheels(ratio);
    return joints && (is_driven((*joints)[0]) || is_driven((*joints)[1]));
  }

  void add_ratio(const LinkageRatio& ratio) {
    const auto joints = wheels(ratio);
    const std::string what =
        "ratio of the links " +
        (ratio.links.size() == 2
             ? std::to_string(ratio.links[0]) + " and " + std::to_string(ratio.links[1])
             : std::to_string(ratio.links.size()) + " in number");
    if (!joints || ratio.sizes[0] <= 0 || ratio.sizes[1] <= 0) {
      mechanism_.miss(what + (joints ? ": a size is not positive"
                                     : ": they are no two gears on the ground or on one link"));
      return;
    }
    const std::size_t leader = is_driven((*joints)[1]) && !is_driven((*joints)[0]) ? 1 : 0;
    const std::size_t follower = 1 - leader;
    if (is_driven((*joints)[follower])) {
      mechanism_.miss(what + ": both are driven already");
      return;
    }
    // An existing joint may count from the wheel to the link that carries it.
    bool is_opposite = !ratio.is_chain;
    const auto pin = [&](std::size_t wheel) {
      const ForeignJoint& joint = (*joints)[wheel];
      const ForeignJointIndex found = mechanism_.pin(joint.first, joint.second, joint.at);
      is_opposite = is_opposite != (mechanism_.joints[found].first != joint.first);
      return found;
    };
    ForeignDrive drive{pin(follower)};
    drive.leader = pin(leader);
    drive.ratio = (is_opposite ? " - " : " + ") + number_text(ratio.sizes[leader]) + "/" +
                  number_text(ratio.sizes[follower]);
    mechanism_.drives.push_back(drive);
  }

  LinkageBodies bodies_;
  ForeignMechanism& mechanism_;
  const LinkageFile& file_;
  DrivePeriod period_;
};

}  // namespace

ForeignMechanism linkage_mechanism(const std::string& text) { return DriveBuilder(text).build(); }

}  // namespace assur::mechanism::foreign
