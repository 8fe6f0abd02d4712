// Turns what the files of other programs say into one form: points in one frame, links that list
// them, joints and drives between the links, and remarks on what is left out.
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
  std::string id;      ///< an identifier that no other point has
  std::string name{};  ///< what the file calls it, which other points may be called, too
  double x = 0, y = 0;
};

/// A rigid body.
struct ForeignLink {
  std::string id, name{};  ///< as of points
  std::vector<ForeignPointIndex> points{};
  bool is_left_out = false;
};

/// A joint of two links. Links that list a point are pinned there without one; a revolute joint
/// gives the pin of two of them a coordinate.
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

/// What moves a joint from where it is drawn.
struct ForeignDrive {
  ForeignJointIndex joint;
  /// A term that is added to the drawn coordinate, with its sign: ` - 30*2*pi/60*t`, in the time t
  /// or another parameter.
  std::string motion{};
  /// The joint that this one follows, and its turns for one of the other's.
  ForeignJointIndex leader{};
  std::string ratio{};
};

/// A mass of a link, in the unit that makes forces those of the file.
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

/// A value of a parameter over which the mechanism is swept.
struct ForeignSweep {
  std::string parameter;
  double from = 0, to = 0;
  int count = 0;
};

/// The shortest text of a number that reads as the same number.
[[nodiscard]] std::string number_text(double number);
/// A number behind its sign as a term: ` + 2`, ` - 2`.
[[nodiscard]] std::string term_text(double number);

/// A mechanism as a file of another program has it. The first link is the ground.
class ForeignMechanism {
 public:
  ForeignMechanism() { ground_ = links.add({"ground", "ground"}); }

  [[nodiscard]] ForeignLinkIndex ground() const { return ground_; }
  void list(ForeignLinkIndex link, ForeignPointIndex point);
  [[nodiscard]] bool lists(ForeignLinkIndex link, ForeignPointIndex point) const;
  /// The links that list a point, but for those left out and those with a slot there.
  [[nodiscard]] std::vector<ForeignLinkIndex> pinned_at(ForeignPointIndex point) const;
  /// Whether a link other than the ground lists a point and is not left out.
  [[nodiscard]] bool is_moved(ForeignPointIndex point) const;
  /// The revolute joint of two links at a point: the one that is there, in either order of the
  /// links, or a new one, in which the ground is first.
  ForeignJointIndex pin(ForeignLinkIndex first, ForeignLinkIndex second, ForeignPointIndex point);
  [[nodiscard]] const ForeignDrive* drive_of(ForeignJointIndex joint) const;
  /// Whether a drive reads the time.
  [[nodiscard]] bool moves_in_time() const;
  [[nodiscard]] double distance(ForeignPointIndex one, ForeignPointIndex other) const;

  /// Something that the scene does not say, but that neither holds nor drives the mechanism.
  void remark(const std::string& line);
  /// Something that holds or drives the mechanism, and that is missing in the scene.
  void miss(const std::string& line);
  /// A mark or colour that the scene does not keep; one remark tells of all.
  void forget_look(const std::string& what) { looks_.insert(what); }

  /// Leaves out links that nothing drives and that one joint holds, or none, and says so; tells
  /// where nothing is driven, and of the marks that are forgotten. Comes last.
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
  std::string mass_factor, inertia_factor;  ///< what turns them into the scene's units: `/100`
  std::string gravity;                      ///< the formula of free fall along y; empty for none
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
