// Coordinates of joints in one configuration, their rates, and the laws that read them.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace assur::mechanism::forces {

/// The pair of features whose relative pose contains the coordinate of a joint of two links: for a
/// pin in a slot, the line is the first.
struct CoordinatePair {
  FeatureIndex first, second;
  int coordinate;  ///< 0: along the first line; 2: an angle
};

class JointCoordinates {
 public:
  /// Both must outlive it.
  JointCoordinates(const Values& values, const Configuration& configuration)
      : values_(values), configuration_(configuration) {}

  [[nodiscard]] CoordinatePair pair_of(JointIndex joint) const;
  /// The same by the joint's two features, also for a joint that the plan leaves out.
  [[nodiscard]] CoordinatePair pair_of(const std::array<FeatureIndex, 2>& between) const;
  /// The second feature in the frame of the first.
  [[nodiscard]] Frame relative(const CoordinatePair& pair) const;
  /// The coordinate, including whole turns given by a law or a branch.
  [[nodiscard]] double value(JointIndex joint) const;
  /// The angle of a pair's links along the branch of a sweep, less a spring's rest angle, if there
  /// is one; nothing if it is not followed.
  [[nodiscard]] std::optional<double> followed(const CoordinatePair& pair, NumberIndex rest) const;
  /// A number whose formula may read joints.
  [[nodiscard]] double number(NumberIndex number) const;
  /// The law of a driver, with derivatives with respect to the coordinates in `joints_of`.
  [[nodiscard]] Dual law(DriverIndex driver) const;
  [[nodiscard]] std::vector<JointIndex> joints_of(DriverIndex driver) const;

 private:
  const Values& values_;
  const Configuration& configuration_;
};

}  // namespace assur::mechanism::forces
