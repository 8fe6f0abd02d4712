// Forces in a configuration with known rates, coefficients of the equations of motion, and
// kinematic coefficients.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

/// A force and a moment about a point that the context names, in the frame of the ground.
struct Wrench {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  double moment = 0;
};

/// The force that the bearing of a joint transmits, without the effort of a driver, a spring or a
/// damper at the joint. NaN where the equations do not determine it.
struct JointForce {
  std::string joint;
  /// The links of the joint, in the order of `between`, and the force that acts on each of them.
  /// Their sum is zero.
  std::vector<std::pair<LinkIndex, Eigen::Vector2d>> on;
  bool has_moment = false;  ///< of a prismatic joint
  /// The couple on the second link, with the force acting at the `through` of this link's line.
  double moment = 0;

  [[nodiscard]] bool is_determined() const;
};

struct Forces {
  /// The torque or force of each driver, in the sense of its joint's coordinate; NaN where it is
  /// not determined.
  Table<DriverIndex, double> efforts;
  std::vector<JointForce> joints;
  /// The resultant of all forces on the ground, about its origin.
  Wrench ground;
  std::string reason;  ///< why an entry is not determined; empty if all are
};

/// M phi'' + bias = load + effort for the coordinates phi of the free drivers: those whose laws
/// read no joint. Entries that are not determined are NaN.
struct Dynamics {
  std::vector<DriverIndex> drivers;
  Eigen::MatrixXd mass_matrix;
  Eigen::VectorXd bias, load;
  std::string reason;  ///< why an entry is not determined; empty if all are
};

/// The derivatives of the coordinate of a joint of two links.
struct JointCoefficients {
  std::string joint;
  Derivatives<1> coordinate;
};

/// First and second derivatives with respect to the coordinates of the free drivers, in their
/// order; the other drivers follow their laws, and the parameters are constant. Entries that are
/// not determined are NaN.
struct KinematicCoefficients {
  std::vector<DriverIndex> drivers;
  Table<LinkIndex, Derivatives<3>> links;  ///< of x, y and theta
  Table<OutputIndex, Derivatives<2>> outputs;
  std::vector<JointCoefficients> joints;  ///< joints left out as redundant come last
  std::string reason;                     ///< why an entry is not determined; empty if all are
};

/// The described drivers: all except those that hold idle links at rest.
[[nodiscard]] std::vector<DriverIndex> described_drivers(const Mechanism& mechanism);
/// The described drivers whose laws read no joint.
[[nodiscard]] std::vector<DriverIndex> free_drivers(const Mechanism& mechanism);

/// The forces in a configuration. This function and the following ones throw MechanismError for a
/// load that has no value.
[[nodiscard]] Forces forces_of(const Values& values, const Configuration& configuration);
/// The derivatives of all numbers of the forces with respect to each parameter of the mechanism,
/// with the drivers following their laws; NaN where they are unknown.
[[nodiscard]] std::vector<Forces> force_sensitivities(const Values& values,
                                                      const Configuration& configuration);
[[nodiscard]] Dynamics dynamics_of(const Values& values, const Configuration& configuration);
[[nodiscard]] KinematicCoefficients coefficients_of(const Values& values,
                                                    const Configuration& configuration);

/// For each number of the forces the sum of |derivative| x tolerance, and the root of the sum of
/// (derivative x tolerance)^2. Both throw MechanismError for a mechanism without parameters.
[[nodiscard]] Forces worst_case(const std::vector<Forces>& sensitivities, const Spread& spread);
[[nodiscard]] Forces root_sum_square(const std::vector<Forces>& sensitivities,
                                     const Spread& spread);

}  // namespace assur::mechanism
