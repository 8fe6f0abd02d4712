// Text of a drawn scene, with one line for each of its parts.
#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/text/quoted.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "foreign/scene_names.hpp"
#include "foreign/scene_text.hpp"

namespace assur::mechanism::foreign {

namespace {

using Json = nlohmann::ordered_json;

/// An object of a scene under its key, with a line for each member.
struct Section {
  std::string key;
  std::vector<std::string> lines{};

  void add(const std::string& name, const Json& value) {
    lines.push_back("    " + Json(name).dump() + ": " + spaced(value));
  }

  /// The value on one line, with a blank after each comma and colon.
  static std::string spaced(const Json& value) {
    if (value.is_array()) {
      return "[" + text::joined(value, ", ", spaced) + "]";
    }
    if (value.is_number_float()) {
      return number_text(value.get<double>());
    }
    if (!value.is_object()) {
      return value.dump();
    }
    std::string all;
    for (const auto& [name, member] : value.items()) {
      all += (all.empty() ? "" : ", ") + Json(name).dump() + ": " + spaced(member);
    }
    return "{" + all + "}";
  }
};

/// Writes the parts of one mechanism.
class SceneWriter {
 public:
  explicit SceneWriter(ForeignMechanism& mechanism) : mechanism_(mechanism), names_(mechanism) {}

  std::string text() {
    std::vector<std::string> parts;
    if (!mechanism_.unit.empty()) {
      parts.push_back("  \"unit\": " + Json(mechanism_.unit).dump());
    }
    // Masses and forces add points.
    const std::vector<Section> load_sections = loads();
    std::vector<Section> sections = {parameters(), points(), links(), joints(), drivers()};
    sections.insert(sections.end(), load_sections.begin(), load_sections.end());
    for (const Section& section : sections) {
      if (!section.lines.empty()) {
        parts.push_back("  \"" + section.key + "\": {\n" + text::joined(section.lines, ",\n") +
                        "\n  }");
      }
    }
    if (!mechanism_.outputs.empty()) {
      Json outputs = Json::array();
      for (const ForeignPointIndex point : mechanism_.outputs) {
        outputs.push_back(names_[point]);
      }
      parts.push_back("  \"outputs\": " + Section::spaced(outputs));
    }
    if (!mechanism_.gravity.empty() && !mechanism_.masses.empty()) {
      parts.push_back("  \"gravity\": " + Section::spaced(Json{0, mechanism_.gravity}));
    }
    if (mechanism_.wants_forces) {
      parts.emplace_back(
          R"(  "want": ["position", "velocity", "acceleration", "sensitivity", "forces"])");
    }
    if (mechanism_.sweep) {
      const ForeignSweep& sweep = *mechanism_.sweep;
      parts.push_back("  \"sweep\": " + Section::spaced(Json{{"parameter", sweep.parameter},
                                                             {"from", sweep.from},
                                                             {"to", sweep.to},
                                                             {"count", sweep.count}}));
    }
    return "{\n" + text::joined(parts, ",\n") + "\n}\n";
  }

 private:
  /// The points of a link; the first two are distinct if any two are.
  [[nodiscard]] std::vector<ForeignPointIndex> listed(ForeignLinkIndex link) const {
    std::vector<ForeignPointIndex> points = mechanism_.links[link].points;
    const auto apart = std::ranges::find_if(points, [&](ForeignPointIndex point) {
      return mechanism_.distance(points.front(), point) > 0;
    });
    if (apart != points.end()) {
      std::rotate(points.begin() + 1, apart, apart + 1);
    }
    return points;
  }

  Section parameters() {
    Section section{"parameters"};
    if (mechanism_.moves_in_time()) {
      section.add("t", Json({{"value", 0}, {"velocity", 1}}));
    }
    for (const std::string& name : mechanism_.hand_parameters) {
      section.add(name, 0);
    }
    for (const ForeignJointIndex joint : mechanism_.joints.keys()) {
      const bool is_read = std::ranges::any_of(mechanism_.drives, [&](const ForeignDrive& drive) {
        return drive.leader == joint ||
               (drive.joint == joint && (!drive.motion.empty() || drive.leader.exists()));
      });
      if (is_read) {
        Json value = Json::object();
        value["drawn"] = names_[joint];
        section.add(names_.coordinate(joint), value);
      }
    }
    return section;
  }

  Section points() {
    Section section{"points"};
    for (const ForeignPointIndex point : mechanism_.points.keys()) {
      if (is_used(point)) {
        section.add(names_[point], {mechanism_.points[point].x, mechanism_.points[point].y});
      }
    }
    section.lines.insert(section.lines.end(), added_points_.lines.begin(),
                         added_points_.lines.end());
    return section;
  }

  [[nodiscard]] bool is_used(ForeignPointIndex point) const {
    const bool is_listed = std::ranges::any_of(mechanism_.links, [&](const ForeignLink& link) {
      return !link.is_left_out && std::ranges::find(link.points, point) != link.points.end();
    });
    for (const ForeignJointIndex key : mechanism_.joints.keys()) {
      const ForeignJoint& joint = mechanism_.joints[key];
      const bool is_on_line =
          joint.along && ((*joint.along)[0] == point || (*joint.along)[1] == point);
      if (is_written(key) && (joint.at == point || joint.to == point || is_on_line)) {
        return true;
      }
    }
    return is_listed;
  }

  Section links() {
    Section section{"links"};
    for (const ForeignLinkIndex link : mechanism_.links.keys()) {
      if (!mechanism_.links[link].is_left_out) {
        Json points = Json::array();
        for (const ForeignPointIndex point : listed(link)) {
          points.push_back(names_[point]);
        }
        section.add(names_[link], points);
      }
    }
    return section;
  }

  [[nodiscard]] bool is_written(ForeignJointIndex key) const {
    const ForeignJoint& joint = mechanism_.joints[key];
    return !names_.is_implied(key) && !mechanism_.links[joint.first].is_left_out &&
           !mechanism_.links[joint.second].is_left_out;
  }

  Section joints() {
    Section section{"joints"};
    for (const ForeignJointIndex key : mechanism_.joints.keys()) {
      const ForeignJoint& joint = mechanism_.joints[key];
      if (!is_written(key)) {
        continue;
      }
      const std::string type = joint.type == JointType::revolute    ? "revolute"
                               : joint.type == JointType::prismatic ? "prismatic"
                                                                    : "pin-in-slot";
      Json value = Json::object();
      value["type"] = type;
      if (joint.to.exists()) {
        value["between"] = {names_[joint.first] + "." + names_[joint.at],
                            names_[joint.second] + "." + names_[joint.to]};
      } else {
        value["links"] = {names_[joint.first], names_[joint.second]};
        value["at"] = names_[joint.at];
        if (joint.along) {
          value["along"] = {names_[(*joint.along)[0]], names_[(*joint.along)[1]]};
        } else if (joint.direction) {
          value["direction"] = *joint.direction;
        }
      }
      if (joint.limits) {
        value["limits"] = *joint.limits;
      }
      section.add(names_[key], value);
    }
    return section;
  }

  Section drivers() {
    Section section{"drivers"};
    for (const ForeignDrive& drive : mechanism_.drives) {
      const std::string own = names_.coordinate(drive.joint);
      Json value = Json::object();
      if (drive.leader.exists()) {
        value["position"] = own + drive.ratio + "*(joint(" + names_[drive.leader] + ") - " +
                            names_.coordinate(drive.leader) + ")";
      } else if (!drive.motion.empty()) {
        value["position"] = own + drive.motion;
      }
      section.add(names_[drive.joint], value);
    }
    return section;
  }

  std::vector<Section> loads() {
    Section masses{"masses"};
    for (const ForeignMass& mass : mechanism_.masses) {
      const std::string& link = names_[mass.link];
      const std::string center = names_.new_point(link + "_center");
      added_points_.add(center, {mass.x, mass.y});
      Json value = {{"mass", number(mass.mass, mechanism_.mass_factor)}, {"at", center}};
      if (mass.inertia != 0) {
        value["inertia"] = number(mass.inertia, mechanism_.inertia_factor);
      }
      masses.add(link, value);
    }
    Section forces{"loads"};
    std::set<std::string> taken;
    for (const ForeignForce& force : mechanism_.forces) {
      const std::string& link = names_[force.link];
      const std::string point = names_.new_point(force.id + "_start");
      added_points_.add(point, {force.x, force.y});
      Json value = {{"at", link + "." + point}, {"force", force.force}};
      if (force.is_local) {
        value["force"] = turned_back(force);
        value["frame"] = link;
      }
      forces.add(new_name(force.id, taken), value);
    }
    return {masses, forces};
  }

  static Json number(double value, const std::string& factor) {
    return factor.empty() ? Json(value) : Json(number_text(value) + factor);
  }

  /// A force in the frame of its link, whose x-axis runs from its first point to its second.
  [[nodiscard]] std::array<double, 2> turned_back(const ForeignForce& force) const {
    const std::vector<ForeignPointIndex> points = listed(force.link);
    const double length = points.size() > 1 ? mechanism_.distance(points[0], points[1]) : 0;
    if (length == 0) {
      return force.force;
    }
    const ForeignPoint& from = mechanism_.points[points[0]];
    const ForeignPoint& to = mechanism_.points[points[1]];
    const double cosine = (to.x - from.x) / length;
    const double sine = (to.y - from.y) / length;
    return {cosine * force.force[0] + sine * force.force[1],
            cosine * force.force[1] - sine * force.force[0]};
  }

  ForeignMechanism& mechanism_;
  SceneNames names_;
  Section added_points_{"points"};
};

}  // namespace

std::string scene_text(ForeignMechanism& mechanism) { return SceneWriter(mechanism).text(); }

}  // namespace assur::mechanism::foreign
