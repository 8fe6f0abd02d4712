// Common interface of all models: configurations of one group and their motion, as plain numbers.
#pragma once

#include <Eigen/Core>
#include <array>
#include <assur/assembly.hpp>
#include <assur/mechanism/group_model.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/support/displaced_frame.hpp>
#include <optional>
#include <vector>

#include "models/series.hpp"

namespace assur::mechanism::models {

/// Bounds on the sizes of a group: it has at most eight links, and no array of it is longer than
/// these. A link's own dimensions are two for each joint except the first.
inline constexpr int most_links = static_cast<int>(most_links_of_group);
inline constexpr int most_unknowns = 8;
inline constexpr int most_configurations = 70;  ///< the bihomogeneous bound of four loops
inline constexpr int most_rows = 3 * most_links;
inline constexpr int most_columns = 40;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_rows, most_columns>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_columns, 1>;

/// Variables of a model one after the other: a length is one number, an angle its cosine and sine.
template <typename Scalar>
using Flat = std::array<Scalar, 64>;
using FlatVariables = Flat<double>;

/// Every configuration of a group; the fields are those of `Assemblies`.
struct GroupAssemblies {
  AssemblyStatus status = AssemblyStatus::ok;
  int mobility = 0;
  std::size_t count = 0;
  std::vector<FlatVariables> configurations;  ///< the first `count` of them; kept for their memory
  std::vector<Status> regularity;
  /// False if the angles that prismatic joints of a degenerate model fix are incompatible.
  bool is_compatible = true;
  /// The number of complex configurations found, if the list follows from them and may be
  /// incomplete; else nothing: no configuration can be missing.
  std::optional<int> complex_count = std::nullopt;
};

/// The derivatives requested of one configuration, and the motion of the group's neighbours.
struct MotionQuery {
  bool derivatives = false;  ///< with respect to dimensions and inputs
  SmallVector input_rate, input_second_rate;
  support::Displacement displaced;  ///< of the neighbours, by rounding
};

/// The poses of a group's links, in the order of the model's table.
using GroupPoses = std::array<Pose<double>, most_links>;

/// One configuration of a group: rows in the order of the model's tables, poses (x, y, theta) link
/// by link. If the Jacobian has no inverse, rates and derivatives are NaN.
struct GroupMotion {
  double residual = 0;          ///< largest of the closures
  Regularity<double> standing;  ///< by the pivots alone
  double size = 0;              ///< the distance by which one radian moves points
  double held = 0;              ///< bound on the displacement of the group's neighbours by rounding
  support::Displacement displaced;  ///< bound on that of the group's links
  GroupPoses poses;
  SmallVector rate, second_rate;          ///< of the unknowns
  SmallMatrix velocities, accelerations;  ///< a row (x, y, theta) per link
  SmallMatrix inverse;                    ///< of the loop Jacobian
  SmallMatrix q_d, q_u;       ///< derivatives of the unknowns with respect to dimensions and inputs
  SmallMatrix p_q, p_d, p_u;  ///< partial derivatives of the poses
};

/// A direction of change of unknowns, dimensions and inputs, and the second derivatives along it:
/// `closures` = -d2f and `poses` = d2p of the loop closures f(q, d, u) and the link poses p(q, d,
/// u), all variables independent.
struct Curvature {
  SmallVector closures, poses;
};

/// Flat variables along a motion, with the resulting closures and link poses.
using FlatSeries = Flat<Series>;
/// The series of a group's closures and of its link poses.
struct MovingGroup {
  std::array<Series, most_unknowns> closures;
  std::array<Pose<Series>, most_links> poses;
};

}  // namespace assur::mechanism::models

namespace assur::mechanism {

/// The functions of one model as plain numbers: d, u and q are flat. Only `assemble` and `gap`
/// apply to a degenerate model, which has no isolated configuration.
class ModelKernel {
 public:
  /// Finds all configurations; `displaced` bounds the neighbours' displacement by rounding.
  virtual void assemble(const models::FlatVariables& d, const models::FlatVariables& u,
                        const support::Displacement& displaced,
                        models::GroupAssemblies& found) const = 0;
  /// Sets the least residual of the closures, if there are no configurations.
  virtual Status gap(const models::FlatVariables& d, const models::FlatVariables& u,
                     double& result) const = 0;
  /// Sets the poses of the links if the group's closures hold.
  virtual void stand(const models::FlatVariables&, const models::FlatVariables&,
                     const models::FlatVariables&, models::GroupPoses&) const {}
  virtual void move(const models::FlatVariables&, const models::FlatVariables&,
                    const models::FlatVariables&, const models::MotionQuery&,
                    models::GroupMotion&) const {}
  virtual void bend(const models::FlatVariables&, const models::FlatVariables&,
                    const models::FlatVariables&, const models::SmallVector& /*q_x*/,
                    const models::SmallVector& /*d_x*/, const models::SmallVector& /*u_x*/,
                    models::Curvature&) const {}
  /// The closures and poses of a moving group, to the order of a series.
  virtual void expand(const models::FlatSeries&, const models::FlatSeries&,
                      const models::FlatSeries&, models::MovingGroup&) const {}

 protected:
  ModelKernel() = default;
  ModelKernel(const ModelKernel&) = default;
  ModelKernel& operator=(const ModelKernel&) = default;
  ~ModelKernel() = default;
};

}  // namespace assur::mechanism
