// Random scenes with drivers anywhere, built from rigid bodies in random positions, so that they
// are assembled by construction.
#pragma once

#include <algorithm>
#include <array>
#include <assur/mechanism/group_model.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/larger_groups.hpp"

namespace assur::test {

/// Positions of random scenes: anywhere, or on whole numbers with angles of right and 3-4-5
/// triangles, which make parts equal and parallel and joints singular.
enum class Places : unsigned char { anywhere, lattice };

/// The connection of several links into one link of a group: by drivers alone, or also by other
/// groups; or by drivers alone, with a first group larger than those of generated models.
enum class Ties : unsigned char { drivers, groups, drivers_in_larger_groups };

/// Driven links, groups, and driven links after them. A link of a group may consist of several
/// connected links. Laws read earlier joints; parameters move, and with them lengths, directions
/// and laws.
class RandomDrivenScene {
 public:
  using Json = nlohmann::ordered_json;
  struct BodyPose {
    double x, y, theta;
  };

  RandomDrivenScene(unsigned seed, Places places, int groups, Ties ties = Ties::drivers)
      : engine_(seed), places_(places), ties_(ties) {
    poses_["ground"] = {0, 0, 0};
    scene_["links"]["ground"] = Json::object();
    placed_.emplace_back("ground");
    add_parameters();
    for (int driven = 1 + below(2); driven > 0; --driven) {
      add_driven_link();
    }
    for (int group = 0; group < groups; ++group) {
      add_group();
      if (chance(0.3)) {
        add_driven_link();
      }
    }
    for (const std::string& link : placed_) {
      if (link != "ground" && chance(0.5)) {
        scene_["outputs"][feature(link, {length(), length(), 0}, false, "")] = "";
      }
    }
    name_outputs();
  }

  [[nodiscard]] const Json& scene() const { return scene_; }
  /// The pose of every link, as it was thrown.
  [[nodiscard]] const std::map<std::string, BodyPose>& poses() const { return poses_; }
  /// The parameters whose formula contains no other parameter.
  [[nodiscard]] const std::vector<std::string>& free_parameters() const { return free_; }

  /// The same scene in another order; pins that no law reads have their links exchanged.
  [[nodiscard]] Json listed(unsigned seed) const {
    std::mt19937 engine(seed);
    const auto shuffled = [&engine](const Json& object) {
      std::vector<std::string> names;
      for (const auto& [name, value] : object.items()) {
        names.push_back(name);
      }
      std::shuffle(names.begin(), names.end(), engine);
      Json result = Json::object();
      for (const std::string& name : names) {
        result[name] = object[name];
      }
      return result;
    };
    Json result = scene_;
    for (const auto& [name, features] : result["links"].items()) {
      features = shuffled(features);
    }
    for (const auto& [name, joint] : result["joints"].items()) {
      if (joint["type"] == "revolute" && !closed_.contains(name)) {
        std::vector<std::string> between = joint["between"];
        std::shuffle(between.begin(), between.end(), engine);
        joint["between"] = between;
      }
    }
    for (const char* key : {"links", "joints", "drivers", "parameters"}) {
      result[key] = shuffled(result[key]);
    }
    return result;
  }

 private:
  /// A place in the frame of the ground, or of a link.
  struct Feature {
    double x, y, angle;
  };
  /// A joint of two links that a law may read.
  struct Readable {
    std::string joint;
    double coordinate;
  };
  /// A pin without a driver, which a later link may join.
  struct OpenPin {
    std::string joint;
    Feature place;
  };
  /// Links that are tied together, or a single link.
  using Body = std::vector<std::string>;

  int below(int bound) { return static_cast<int>(engine_() % static_cast<unsigned>(bound)); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  bool chance(double part) { return between(0, 1) < part; }
  [[nodiscard]] bool on_lattice() const { return places_ == Places::lattice; }
  double length() { return on_lattice() ? below(5) - 2 : between(-2, 2); }
  double angle() {
    static const double pythagorean = std::atan2(4.0, 3.0);
    return !on_lattice() ? between(-std::numbers::pi, std::numbers::pi)
                         : (below(4) - 1) * std::numbers::pi / 2 + (chance(0.2) ? pythagorean : 0);
  }
  double displacement() { return on_lattice() ? below(3) - 1 : between(-1.5, 1.5); }
  double factor() {
    static constexpr std::array<double, 6> factors = {1, -1, 2, 0.5, -0.7, 1.3};
    return factors[static_cast<std::size_t>(below(6))];
  }

  static std::string text_of(double number) {
    std::ostringstream text;
    text.precision(17);
    text << number;
    return text.str();
  }

  void add_parameters() {
    for (int index = 0; index < 3; ++index) {
      const std::string name = "p" + std::to_string(index);
      Json entry = {{"value", on_lattice() ? Json(below(2)) : Json(between(0.2, 1))}};
      value_[name] = entry["value"].get<double>();
      if (index < 2 || chance(0.5)) {
        entry["velocity"] = between(-1, 1);
      }
      if (chance(0.7)) {
        entry["acceleration"] = between(-1, 1);
      }
      scene_["parameters"][name] = entry;
      free_.push_back(name);
    }
    scene_["parameters"]["q"] = "0.5*p0*p0 - p1";
    value_["q"] = 0.5 * value_["p0"] * value_["p0"] - value_["p1"];
  }

  /// A number that follows a parameter, now and then.
  Json number(double value, double how_often = 0.08) {
    if (!chance(how_often)) {
      return value;
    }
    return text_of(value) + moving_term();
  }
  std::string moving_term() {
    static constexpr std::array<const char*, 4> names = {"p0", "p1", "p2", "q"};
    const std::string name = names[static_cast<std::size_t>(below(4))];
    const std::string moved = "(" + name + " - (" + text_of(value_[name]) + "))";
    return " + (" + text_of(factor()) + ")*" + (chance(0.3) ? "sin" + moved : moved);
  }

  std::string add_link() {
    std::string name = "L" + std::to_string(poses_.size());
    poses_[name] = {length(), length(), angle()};
    scene_["links"][name] = Json::object();
    return name;
  }

  /// Adds the feature of a joint to a link and gives its name, `link.feature`.
  std::string feature(const std::string& link, const Feature& world, bool is_line,
                      const std::string& joint) {
    const BodyPose& pose = poses_.at(link);
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    const double x = world.x - pose.x;
    const double y = world.y - pose.y;
    const std::string name =
        (joint.empty() ? "P" : joint) + "_" + std::to_string(scene_["links"][link].size());
    const Json at = {number(c * x + s * y), number(c * y - s * x)};
    Json& entry = scene_["links"][link][name];
    if (!is_line) {
      entry = at;
    } else if (const double turn = world.angle - pose.theta; chance(0.1)) {
      const std::string direction = "(" + text_of(turn) + moving_term() + ")";
      entry = {{"through", at}, {"along", {"cos" + direction, "sin" + direction}}};
    } else {
      entry = {{"through", at}, {"along", {2 * std::cos(turn), 2 * std::sin(turn)}}};
    }
    return link + "." + name;
  }

  std::string new_joint() { return "J" + std::to_string(scene_["joints"].size()); }

  /// Joins two links, the first feature being that of `one`, and gives the joint's coordinate.
  double join(const std::string& joint, const std::string& type, const std::string& one,
              const std::string& other) {
    const Feature place{length(), length(), angle()};
    const double by = type == "revolute" ? 0 : displacement();
    const Feature moved{place.x + by * std::cos(place.angle), place.y + by * std::sin(place.angle),
                        place.angle};
    const std::string first = feature(one, place, type != "revolute", joint);
    const std::string second = feature(other, moved, type == "prismatic", joint);
    scene_["joints"][joint] = {{"type", type}, {"between", {first, second}}};
    if (type == "revolute") {
      new_pins_.push_back({joint, place});
      return poses_.at(other).theta - poses_.at(one).theta;
    }
    return by;
  }

  void drive(const std::string& joint, double coordinate) {
    closed_.insert(joint);
    std::string law = text_of(coordinate);
    if (!readable_.empty() && chance(0.4)) {
      const Readable& read =
          readable_[static_cast<std::size_t>(below(static_cast<int>(readable_.size())))];
      closed_.insert(read.joint);
      const std::string moved = "(joint(" + read.joint + ") - (" + text_of(read.coordinate) + "))";
      law += " + (" + text_of(factor()) + ")*" + (chance(0.2) ? "sin" + moved : moved);
    }
    if (chance(0.7)) {
      law += moving_term();
    }
    scene_["drivers"][joint] = {{"position", law}};
    if (chance(0.1)) {
      scene_["drivers"][joint]["velocity"] = between(-1, 1);
    }
    if (chance(0.1)) {
      scene_["drivers"][joint]["acceleration"] = between(-1, 1);
    }
    new_readable_.push_back({joint, coordinate});
  }

  /// Lets later links and laws use the links of this stage, and the joints that it added.
  void conclude_stage(const std::vector<std::string>& links) {
    placed_.insert(placed_.end(), links.begin(), links.end());
    readable_.insert(readable_.end(), new_readable_.begin(), new_readable_.end());
    pins_.insert(pins_.end(), new_pins_.begin(), new_pins_.end());
    new_readable_.clear();
    new_pins_.clear();
    joined_.clear();
  }

  void tie(const std::string& one, const std::string& other) {
    const std::string joint = new_joint();
    const bool slides = chance(0.5);
    const bool exchanged = chance(0.5);
    drive(joint, join(joint, slides ? "prismatic" : "revolute", exchanged ? other : one,
                      exchanged ? one : other));
  }

  void add_driven_link() {
    const std::string from = any_placed();
    const std::string to = add_link();
    tie(from, to);
    conclude_stage({to});
  }

  const std::string& any_placed() {
    // Later links are chosen more often, so that long chains arise.
    const int count = static_cast<int>(placed_.size());
    return placed_[static_cast<std::size_t>(std::max(below(count), below(count)))];
  }
  const std::string& any_of(const Body& body) {
    return body[static_cast<std::size_t>(below(static_cast<int>(body.size())))];
  }

  void add_group() {
    static constexpr std::array<std::size_t, 10> which = {0, 0, 0, 0, 0, 1, 1, 1, 2, 2};
    conclude_stage(add_group(which[static_cast<std::size_t>(below(10))], nullptr));
  }

  /// Adds a group held by the body alone, so that its links become a part of the body.
  void add_group_to(Body& body) {
    const std::vector<std::string> added =
        add_group(chance(0.8) ? 0U : static_cast<std::size_t>(1 + below(2)), &body);
    body.insert(body.end(), added.begin(), added.end());
  }

  /// Adds a group, on a body or on links that are placed, and returns its links.
  std::vector<std::string> add_group(std::size_t which, const Body* base) {
    if (ties_ == Ties::drivers_in_larger_groups && !has_larger_) {
      has_larger_ = true;
      const std::vector<Chain>& chains = seven_link_chains();
      const mechanism::GroupStructure larger =
          grounded(chains[static_cast<std::size_t>(below(3))], 7, below(7));
      return add_group(larger, base, [&](const std::vector<bool>& slides) {
        return model_of(larger, slides) != nullptr;
      });
    }
    const auto& known = mechanism::known_groups();
    const mechanism::GroupModels& group = known[std::min(which, known.size() - 1)];
    return add_group(group.structure, base, [&](const std::vector<bool>& slides) {
      return group.serving(slides).model->rigid;
    });
  }

  template <typename IsRigid>
  std::vector<std::string> add_group(const mechanism::GroupStructure& structure, const Body* base,
                                     const IsRigid& is_rigid) {
    const std::size_t count = structure.joints.size();
    std::vector<bool> slides(count);
    do {
      for (std::size_t joint = 0; joint < count; ++joint) {
        slides[joint] = chance(0.25);
      }
    } while (!is_rigid(slides));

    const std::size_t links = structure.link_count();
    std::vector<Body> bodies(links);
    std::vector<bool> is_block(links, false);
    choose_block(structure, slides, is_block);
    std::vector<std::string> added;
    for (std::size_t link = 0; link < links; ++link) {
      if (is_block[link]) {
        continue;
      }
      static constexpr std::array<int, 10> sizes = {1, 1, 1, 1, 1, 2, 2, 2, 2, 3};
      const int size = sizes[static_cast<std::size_t>(below(10))];
      for (int member = 0; member < size; ++member) {
        bodies[link].push_back(add_link());
        added.push_back(bodies[link].back());
        if (member > 0) {
          tie(bodies[link][static_cast<std::size_t>(below(member))], bodies[link].back());
        }
      }
      if (ties_ == Ties::groups && chance(base == nullptr ? 0.4 : 0.1)) {
        const std::size_t before = bodies[link].size();
        add_group_to(bodies[link]);
        added.insert(added.end(), bodies[link].begin() + static_cast<std::ptrdiff_t>(before),
                     bodies[link].end());
      }
    }
    const Body* const outer = std::exchange(base_, base);
    for (std::size_t joint = 0; joint < count; ++joint) {
      add_joint(structure, joint, slides[joint], bodies, is_block);
    }
    for (std::size_t link = 0; link < links; ++link) {
      if (is_block[link]) {
        add_slot(structure, static_cast<int>(link), slides, bodies);
      }
    }
    base_ = outer;
    return added;
  }

  /// A link of a pin and a slide may be the block of a pin in a slot.
  void choose_block(const mechanism::GroupStructure& structure, const std::vector<bool>& slides,
                    std::vector<bool>& is_block) {
    for (std::size_t link = 0; link < structure.link_count(); ++link) {
      const std::vector<int>& joints = structure.link_joints[link];
      const bool fits = joints.size() == 2 && slides[static_cast<std::size_t>(joints[0])] !=
                                                  slides[static_cast<std::size_t>(joints[1])];
      if (fits && chance(0.4)) {
        is_block[link] = true;
        return;
      }
    }
  }

  /// A link on one side of a joint of the group.
  std::string side(int link, const std::vector<Body>& bodies) {
    return link != base_link  ? any_of(bodies[static_cast<std::size_t>(link)])
           : base_ != nullptr ? any_of(*base_)
                              : any_placed();
  }
  static bool is_side_of_block(int link, const std::vector<bool>& is_block) {
    return link != base_link && is_block[static_cast<std::size_t>(link)];
  }

  void add_joint(const mechanism::GroupStructure& structure, std::size_t index, bool slides,
                 const std::vector<Body>& bodies, const std::vector<bool>& is_block) {
    const ModelJoint& at = structure.joints[index];
    if (is_side_of_block(at.first, is_block) || is_side_of_block(at.second, is_block)) {
      return;
    }
    std::string one = side(at.first, bodies);
    std::string other = side(at.second, bodies);
    const bool is_on_ground = at.first == base_link && base_ == nullptr;
    if (is_on_ground && !slides && !open_pins().empty() && chance(0.3)) {
      const std::vector<OpenPin> pins = open_pins();
      const OpenPin& pin = pins[static_cast<std::size_t>(below(static_cast<int>(pins.size())))];
      scene_["joints"][pin.joint]["between"].push_back(feature(other, pin.place, false, pin.joint));
      joined_.insert(pin.joint);
      // A pin of three links has no coordinate.
      std::erase_if(readable_, [&](const Readable& it) { return it.joint == pin.joint; });
      return;
    }
    if (chance(0.5)) {
      std::swap(one, other);
    }
    const std::string joint = new_joint();
    if (!slides && chance(0.15)) {  // a slot, in which a driver moves the pin
      drive(joint, join(joint, "pin-in-slot", one, other));
      return;
    }
    read(joint, join(joint, slides ? "prismatic" : "revolute", one, other), !slides);
  }

  /// A pin in a slot, whose block is a link of the group.
  void add_slot(const mechanism::GroupStructure& structure, int block,
                const std::vector<bool>& slides, const std::vector<Body>& bodies) {
    std::string line;
    std::string pin;
    for (const int joint : structure.link_joints[static_cast<std::size_t>(block)]) {
      const ModelJoint& at = structure.joints[static_cast<std::size_t>(joint)];
      const int other = at.first == block ? at.second : at.first;
      (slides[static_cast<std::size_t>(joint)] ? line : pin) = side(other, bodies);
    }
    const std::string joint = new_joint();
    read(joint, join(joint, "pin-in-slot", line, pin), false);
  }

  void read(const std::string& joint, double coordinate, bool turns) {
    if (turns) {  // as laws read it: above -pi
      coordinate = std::remainder(coordinate, 2 * std::numbers::pi);
      coordinate += coordinate < 1e-9 - std::numbers::pi ? 2 * std::numbers::pi : 0;
    }
    new_readable_.push_back({joint, coordinate});
  }

  [[nodiscard]] std::vector<OpenPin> open_pins() const {
    std::vector<OpenPin> result;
    for (const OpenPin& pin : pins_) {
      if (!closed_.contains(pin.joint) && !joined_.contains(pin.joint)) {
        result.push_back(pin);
      }
    }
    return result;
  }

  /// Outputs were collected under the names of their features.
  void name_outputs() {
    Json outputs = Json::object();
    if (scene_.contains("outputs")) {
      for (const auto& [point, value] : scene_["outputs"].items()) {
        outputs["O" + std::to_string(outputs.size())] = point;
      }
    }
    scene_["outputs"] = outputs;
  }

  std::mt19937 engine_;
  Places places_;
  Ties ties_;
  bool has_larger_ = false;
  const Body* base_ =
      nullptr;  ///< base of the group being added; null if placed links are its bases
  Json scene_;
  std::map<std::string, BodyPose> poses_;
  std::map<std::string, double> value_;
  std::vector<std::string> free_;
  std::vector<std::string> placed_;
  std::set<std::string> closed_;  ///< joints that are driven or read
  std::set<std::string> joined_;  ///< pins that a link of this group joins: only one may
  std::vector<Readable> readable_, new_readable_;
  std::vector<OpenPin> pins_, new_pins_;
};

}  // namespace assur::test
