// Common form of mechanisms from other programs' files: points in one frame, links that list them,
// joints and drives between the links, and remarks on omissions.
#pragma once

#include <array>
#include <assur/mechanism/mechanism.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace assur::mechanism::foreign {

using ForeignPointIndex = Index<struct ForeignPoint>;
using ForeignLinkIndex = Index<struct ForeignLink>;
using ForeignJointIndex = Index<struct ForeignJoint>;

/// A point of the drawing, y upward.
struct ForeignPoint {
  std::string id;      ///< a unique identifier
  std::string name{};  ///< the name in the file, which other points may share
  double x = 0, y = 0;
};

/// A rigid body.
struct ForeignLink {
  std::string id, name{};  ///< as of points
  std::vector<ForeignPointIndex> points{};
  bool is_left_out = false;
};

/// A joint of two links. Links that list a common point are pinned there without one; an explicit
/// revolute joint gives the pin of two of them a coordinate.
struct ForeignJoint {
  JointType type = JointType::revolute;
  ForeignLinkIndex first, second;  ///< of a pin in a slot: the pin's and the slot's
  ForeignPointIndex at;
  /// The line of a slot or slide: through two points, or in a direction through `at`. A slide
  /// without either runs from `at`, of the first link, to `to`, of the second: a cylinder.
  std::optional<std::array<ForeignPointIndex, 2>> along{};
  std::optional<std::array<double, 2>> direction{};
  ForeignPointIndex to{};
  std::optional<std::array<double, 2>> limits{};
};

/// A drive that moves a joint from its drawn position.
struct ForeignDrive {
  ForeignJointIndex joint;
  /// A signed term that is added to the drawn coordinate: ` - 30*2*pi/60*t`, in the time t or
  /// another parameter.
  std::string motion{};
  /// The joint that this one follows, and the ratio of its turns to the other's.
  ForeignJointIndex leader{};
  std::string ratio{};
};

/// A mass of a link, in a unit for which forces are those of the file.
struct ForeignMass {
  ForeignLinkIndex link;
  double mass = 0, inertia = 0;  ///< the inertia about the centre
  double x = 0, y = 0;           ///< the centre
};

/// A force on a link, which keeps its direction in the drawing, or in the link.
struct ForeignForce {
  std::string id, name;
  ForeignLinkIndex link;
  double x = 0, y = 0;
  std::array<double, 2> force{};
  bool is_local = false;
};

/// A range of a parameter over which the mechanism is swept.
struct ForeignSweep {
  std::string parameter;
  double from = 0, to = 0;
  int count = 0;
};

/// The shortest text that parses to the same number.
[[nodiscard]] std::string number_text(double number);
/// A number as a signed term: ` + 2`, ` - 2`.
[[nodiscard]] std::string term_text(double number);

/// A mechanism from another program's file. The first link is the ground.
class ForeignMechanism {
 public:
  ForeignMechanism() { ground_ = links.add({"ground", "ground"}); }

  [[nodiscard]] ForeignLinkIndex ground() const { return ground_; }
  void list(ForeignLinkIndex link, ForeignPointIndex point);
  [[nodiscard]] bool lists(ForeignLinkIndex link, ForeignPointIndex point) const;
  /// The links that list a point, without those left out and those with a slot there.
  [[nodiscard]] std::vector<ForeignLinkIndex> pinned_at(ForeignPointIndex point) const;
  /// Whether a link other than the ground lists a point and is not left out.
  [[nodiscard]] bool is_moved(ForeignPointIndex point) const;
  /// The revolute joint of two links at a point: the existing one, in either order of the links, or
  /// a new one, in which the ground is first.
  ForeignJointIndex pin(ForeignLinkIndex first, ForeignLinkIndex second, ForeignPointIndex point);
  [[nodiscard]] const ForeignDrive* drive_of(ForeignJointIndex joint) const;
  /// Whether a drive reads the time.
  [[nodiscard]] bool moves_in_time() const;
  [[nodiscard]] double distance(ForeignPointIndex one, ForeignPointIndex other) const;

  /// Notes a line on an omission that neither holds nor drives the mechanism.
  void remark(const std::string& line);
  /// Notes a line on a missing joint or drive of the mechanism.
  void miss(const std::string& line);
  /// Notes a mark or colour that the scene does not keep; one remark lists all.
  void forget_look(const std::string& what) { looks_.insert(what); }

  /// Leaves out links that no drive moves and that one joint or none holds; adds remarks on these,
  /// on missing drives and on omitted marks. Called last.
  void finish();
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
  [[nodiscard]] bool is_complete() const { return is_complete_; }

  std::string unit;
  Table<ForeignPointIndex, ForeignPoint> points;
  Table<ForeignLinkIndex, ForeignLink> links;
  Table<ForeignJointIndex, ForeignJoint> joints;
  std::vector<ForeignDrive> drives;
  std::vector<std::string> hand_parameters;  ///< parameters that drives read beside the time
  std::vector<ForeignPointIndex> outputs;
  std::vector<ForeignMass> masses;
  std::string mass_factor, inertia_factor;  ///< factors that convert to the scene's units: `/100`
  std::string gravity;  ///< the formula of free fall along y; empty without gravity
  std::vector<ForeignForce> forces;
  bool wants_forces = false;
  std::optional<ForeignSweep> sweep;

 private:
  [[nodiscard]] int joints_of(ForeignLinkIndex link) const;
  [[nodiscard]] bool is_driven(ForeignLinkIndex link) const;
  void leave_out(ForeignLinkIndex link);

  ForeignLinkIndex ground_;
  std::set<std::string> looks_;
  std::vector<std::string> remarks_;
  bool is_complete_ = true;
};

}  // namespace assur::mechanism::foreign
