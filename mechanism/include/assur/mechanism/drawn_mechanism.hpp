// A mechanism described by a drawing: points in one frame, and the links that list them.
#pragma once

#include <array>
#include <assur/mechanism/mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace assur::mechanism {

namespace drawn {
class LinkPlaces;
struct DrawnEnd;
struct ImpliedPin;
struct ResolvedJoint;
}  // namespace drawn

using DrawnPointIndex = Index<struct DrawnPoint>;
using DrawnLinkIndex = Index<struct DrawnLink>;

/// A point of a drawing, in the frame of the ground.
struct DrawnPoint {
  std::string name;
  Formula x, y;
};

/// A link that lists points. Its frame has its origin at the first one and its x-axis toward the
/// second; with one point, it is parallel to the ground. The ground has the fixed frame.
struct DrawnLink {
  std::string name;
  std::vector<DrawnPointIndex> points;
};

/// A joint of a drawing. It joins `links`, or the features `between`.
struct DrawnJoint {
  std::string name;
  JointType type = JointType::revolute;
  std::vector<std::string> links;
  std::string at;  ///< the point of a pin; if empty, the point with the joint's name
  /// The line of a slide or slot: from one point to another, or in a direction through `at`.
  std::vector<std::string> along;
  std::optional<std::array<Mechanism::Given, 2>> direction;
  std::vector<std::string> between;  ///< `link.feature`
  std::optional<std::array<Mechanism::Given, 2>> limits;
};

/// The parts of a drawing. A parameter is the distance of two points, the one with the lower index
/// first, in a link that lists both.
struct DrawnParts {
  Table<DrawnPointIndex, DrawnPoint> points;
  Table<DrawnLinkIndex, DrawnLink> links;
  std::map<std::tuple<DrawnLinkIndex, DrawnPointIndex, DrawnPointIndex>, ParameterIndex> lengths;

  /// The parameter that is the distance of two points in a link, if there is one.
  [[nodiscard]] std::optional<ParameterIndex> length(DrawnLinkIndex link, DrawnPointIndex one,
                                                     DrawnPointIndex other) const;
  /// Whether a link lists a point.
  [[nodiscard]] bool lists(DrawnLinkIndex link, DrawnPointIndex point) const;
};

/// Adds a drawing to a mechanism that already has its parameters and any links with frames of their
/// own. Points, links, joints and lengths come first, in any order; `place` converts them to
/// features, joints and values of the mechanism; drivers and outputs come last.
///
///     Mechanism four_bar("a four-bar");
///     DrawnMechanism drawn(four_bar);
///     drawn.add_point("A", 0, 0);
///     ...
///     drawn.add_link("ground", {"A", "D"});
///     drawn.add_link("crank", {"A", "B"});
///     ...
///     drawn.place();
///     drawn.add_driver("A", std::nullopt, 10);
///     drawn.add_output("P", "P");
///     Request request;
///     drawn.refer(request);
///     const Plan plan(four_bar, request);
///
/// Every point that two links or more list is a revolute joint, unless other joints join them
/// there. The side on which a point is drawn, and whether points coincide, are decided at the
/// values of the parameters in `place`. All functions throw MechanismError for unusable parts, and
/// name the part as a scene file spells it.
class DrawnMechanism {
 public:
  using Given = Mechanism::Given;

  /// The mechanism must outlive the drawing.
  explicit DrawnMechanism(Mechanism& mechanism) : mechanism_(mechanism) {}
  DrawnMechanism(const DrawnMechanism&) = delete;
  DrawnMechanism& operator=(const DrawnMechanism&) = delete;

  void add_point(const std::string& name, const Given& x, const Given& y);
  /// A link that lists points, each once. All points must have been added.
  void add_link(const std::string& name, const std::vector<std::string>& points);
  void add_joint(DrawnJoint joint);
  /// Makes a declared parameter the distance of each of these pairs of points, in every link that
  /// lists both. If it has no value, it gets the distance as drawn.
  void set_length(const std::string& parameter, const std::vector<std::array<std::string, 2>>& of);
  /// Makes a declared parameter the coordinate of a joint as drawn.
  void set_coordinate(const std::string& parameter, const std::string& joint);
  /// Whether a link lists points.
  [[nodiscard]] bool is_drawn() const { return !parts_.links.empty(); }

  [[nodiscard]] const Table<DrawnPointIndex, DrawnPoint>& points() const { return parts_.points; }

  /// Adds the drawing to the mechanism. If all links list points, a ground that lists none may be
  /// omitted.
  void place();

  /// Adds a driver; without a position the joint keeps its coordinate as drawn.
  DriverIndex add_driver(const std::string& joint, const std::optional<Given>& position,
                         const std::optional<Given>& velocity = std::nullopt,
                         const std::optional<Given>& acceleration = std::nullopt);
  /// Adds an output at `link.feature`, or at a drawn point; its link is then the first moving one,
  /// by name, that lists the point.
  OutputIndex add_output(const std::string& name, const std::string& point);
  /// Makes a drawn point a feature of a link at the drawn position, unless it is one already. Other
  /// names of features and links have no effect.
  void make_feature(const std::string& name, const std::string& part);
  /// Makes the drawn pose the reference of a request, if any link except the ground lists points.
  void refer(Request& request) const;

 private:
  struct Length {
    std::string parameter;
    std::vector<std::array<DrawnPointIndex, 2>> of;
  };
  struct Coordinate {
    std::string parameter, joint;
  };

  [[nodiscard]] DrawnPointIndex point_named(const std::string& name, const std::string& part) const;
  [[nodiscard]] DrawnLinkIndex link_named(const std::string& name, const std::string& part) const;
  [[nodiscard]] drawn::DrawnEnd end_named(const std::string& name) const;
  [[nodiscard]] std::vector<drawn::ResolvedJoint> resolved_joints() const;
  void add_left_out_ground();
  void set_lengths();
  void find_coordinates(const std::vector<drawn::ResolvedJoint>& joints,
                        const std::vector<drawn::ImpliedPin>& pins);
  void set_coordinates();
  void add_features(const std::vector<drawn::ResolvedJoint>& joints);
  void add_joints(const std::vector<drawn::ResolvedJoint>& joints,
                  const std::vector<drawn::ImpliedPin>& pins);
  /// The coordinate of a joint as drawn. Throws MechanismError if the drawing does not determine
  /// one.
  [[nodiscard]] Formula coordinate_of(const std::string& joint, const std::string& part) const;

  Mechanism& mechanism_;
  DrawnParts parts_;
  std::unordered_map<std::string, DrawnPointIndex> point_of_name_;
  std::unordered_map<std::string, DrawnLinkIndex> link_of_name_;
  std::vector<DrawnJoint> joints_;
  std::vector<Length> lengths_;
  std::vector<Coordinate> coordinates_of_parameters_;
  /// The coordinates of joints as drawn; nothing for a joint whose coordinate the drawing does not
  /// determine.
  std::map<std::string, std::optional<Formula>> coordinates_;
  /// The two moving links of each joint that only a point implies, and whose coordinate has no
  /// sense.
  std::map<std::string, std::array<std::string, 2>> unmeasured_;
  std::shared_ptr<const drawn::LinkPlaces> places_;  ///< null before `place`
  std::optional<DrawnGap> gap_;
};

}  // namespace assur::mechanism
